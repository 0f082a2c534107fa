#pragma once
#include <optional>
#include <string>

#include "import/mitsuba/material_plugins.h"

namespace ajar::mitsuba {

/// Roughness of a surface's microfacets.
struct Roughness {
  desc::Value alpha;                   ///< or that along u
  std::optional<desc::Value> alpha_v;  ///< if it is another one
  std::string distribution;            ///< "ggx" or "beckmann"

  /// Sets "roughness", and "roughness_v", "distribution" and "masking" if the model has them.
  void set(desc::Node& node) const;
};

/// From "distribution", "alpha", "alpha_u" and "alpha_v". Distributions that we do not have are the
/// nearest, with a warning.
Roughness read_roughness(const MaterialInputs& in);

}  // namespace ajar::mitsuba
