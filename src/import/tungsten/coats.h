#pragma once
#include "import/tungsten/bsdf_models.h"

/// Bsdfs with a dielectric layer on top. Bases that are neither diffuse nor a metal become a blend,
/// with a warning, that reflects as much light on average (coat_optics.h).
namespace ajar::tungsten {

desc::Node plastic(const BsdfInputs& in);
desc::Node rough_plastic(const BsdfInputs& in);
desc::Node smooth_coat(const BsdfInputs& in);
desc::Node rough_coat(const BsdfInputs& in);

}  // namespace ajar::tungsten
