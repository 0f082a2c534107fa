#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.h"

namespace ajar::tungsten {

/// Index of refraction and extinction coefficient, linear RGB.
struct ComplexIor {
  Vec3 eta;
  Vec3 k;
};

/// A material that bsdfs name, such as "Cu" or "Cu_palik"; nothing for others.
/// Source: Tungsten, src/core/bsdfs/ComplexIorData.hpp.
std::optional<ComplexIor> find_metal(std::string_view name);

/// All their names.
std::vector<std::string> metal_names();

}  // namespace ajar::tungsten
