#pragma once
#include <vector>

#include "import/common/name_table.h"

namespace ajar::pbrt {

/// pbrt's shapes that are models of ours. Their arrays are read in `shapes.cpp`.
const std::vector<ModelName>& shape_names();

}  // namespace ajar::pbrt
