#pragma once
#include <vector>

#include "import/common/name_table.h"
#include "import/pbrt/dialect.h"

namespace ajar::pbrt {

/// pbrt's lights that are models of ours. All have a "scale", too, which is a factor of colours.
const std::vector<ModelName>& light_names(Dialect dialect = Dialect::V3);
/// pbrt's lights on surfaces that are models of ours.
const std::vector<ModelName>& emission_names(Dialect dialect = Dialect::V3);

}  // namespace ajar::pbrt
