#pragma once
#include <string>
#include <vector>

#include "import/common/name_table.h"

namespace ajar::pbrt {

/// pbrt's textures that are models of ours.
const std::vector<ModelName>& texture_names();

}  // namespace ajar::pbrt
