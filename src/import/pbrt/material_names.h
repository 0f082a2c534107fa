#pragma once
#include <string>
#include <vector>

#include "import/common/name_table.h"
#include "import/pbrt/dialect.h"

namespace ajar::pbrt {

/// pbrt's materials that are models of ours. The writer writes pbrt-v3.
const std::vector<ModelName>& material_names(Dialect dialect = Dialect::V3);

}  // namespace ajar::pbrt
