#pragma once
#include "import/mitsuba/media.h"
#include "import/mitsuba/textures.h"

namespace ajar::mitsuba {

/// Adds the lights of `<emitter>` in the scene, which are on no surface. Unsupported ones become
/// the nearest equivalent, or are left out, with a warning.
void add_lights(Context& context, MediumTable& media, const Element& emitter);

// In sky.cpp: "sun", "sky" and "sunsky": light of the sun from one direction, and a clear sky.
void add_sun_and_sky(Context& context, Arguments& arguments);

}  // namespace ajar::mitsuba
