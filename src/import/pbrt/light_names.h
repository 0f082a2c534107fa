#pragma once
#include <vector>

#include "import/common/name_table.h"

namespace ajar::pbrt {

/// pbrt's lights that are models of ours. All have a "scale", too, which is a factor of colours.
const std::vector<ModelName>& light_names();
/// pbrt's lights on surfaces that are models of ours.
const std::vector<ModelName>& emission_names();

}  // namespace ajar::pbrt
