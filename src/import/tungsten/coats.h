#pragma once
#include "import/tungsten/bsdf_models.h"

/// Bsdfs with a dielectric layer on top, which is not among our materials: others stand in, with a
/// warning, that reflect as much light on average (coat_optics.h).
namespace ajar::tungsten {

desc::Node plastic(const BsdfInputs& in);
desc::Node rough_plastic(const BsdfInputs& in);
desc::Node smooth_coat(const BsdfInputs& in);
desc::Node rough_coat(const BsdfInputs& in);

}  // namespace ajar::tungsten
