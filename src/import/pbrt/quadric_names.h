#pragma once
#include <vector>

#include "import/common/name_table.h"

namespace ajar::pbrt {

/// pbrt's quadrics, which all are models of ours.
const std::vector<ModelName>& quadric_names();

}  // namespace ajar::pbrt
