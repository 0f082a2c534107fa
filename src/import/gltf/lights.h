#pragma once
#include "import/gltf/nodes.h"

namespace ajar::gltf {

/// Adds the lights of KHR_lights_punctual that nodes hold. Candela are taken as W/sr, lux as W/m²:
/// photometric units differ from radiometric ones by one factor, which sets the exposure alone.
void add_lights(Context& context, const std::vector<PlacedNode>& nodes);

}  // namespace ajar::gltf
