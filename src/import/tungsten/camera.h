#pragma once
#include "import/tungsten/lights.h"
#include "import/tungsten/media.h"

namespace ajar::tungsten {

/// Reads the camera: place, view, film and filter. `places` are those of the primitives that it may
/// be focused on.
void read_camera(Context& context, const LocatedJson& json, MediumTable& media,
                 const PrimitivePlaces& places);

}  // namespace ajar::tungsten
