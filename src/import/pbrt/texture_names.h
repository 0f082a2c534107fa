#pragma once
#include <string>
#include <vector>

#include "import/common/name_table.h"
#include "import/pbrt/dialect.h"

namespace ajar::pbrt {

/// pbrt's textures that are models of ours.
const std::vector<ModelName>& texture_names(Dialect dialect = Dialect::V3);

}  // namespace ajar::pbrt
