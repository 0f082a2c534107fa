#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.h"

namespace ajar {

/// Index of refraction and extinction coefficient, linear RGB.
struct ComplexIndex {
  Vec3 eta;
  Vec3 k;
};

/// The conductor, or other opaque solid, that renderers call by this name: "Au", "TiN", "a-C",
/// "V_palik". Empty for others.
std::optional<ComplexIndex> conductor_named(std::string_view name);
std::vector<std::string> conductor_names();

}  // namespace ajar
