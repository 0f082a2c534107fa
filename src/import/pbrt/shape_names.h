#pragma once
#include <vector>

#include "import/common/name_table.h"
#include "import/pbrt/dialect.h"

namespace ajar::pbrt {

/// pbrt's shapes that are models of ours. Their arrays are read in `shapes.cpp`.
const std::vector<ModelName>& shape_names(Dialect dialect = Dialect::V3);

}  // namespace ajar::pbrt
