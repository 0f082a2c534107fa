#pragma once
#include <string>
#include <vector>

#include "import/common/name_table.h"

namespace ajar::pbrt {

/// pbrt's materials that are models of ours.
const std::vector<ModelName>& material_names();

/// A material that we cannot render: a diffuse one stands in.
struct StandIn {
  std::string_view type;
  std::string_view color;  ///< the parameter that is most like a reflectance; may be empty
  float fallback;          ///< reflectance without it
};
/// Null for others.
const StandIn* find_stand_in(std::string_view type);
std::vector<std::string> stand_in_types();

}  // namespace ajar::pbrt
