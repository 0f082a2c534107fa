#pragma once
#include <optional>
#include <vector>

#include "core/parameters.h"
#include "image/regions.h"
#include "integrator/integrator.h"
#include "integrator/regions/region_rules.h"

namespace ajar {

/// Chain weights that the user sets by hand (manual fill): by rules, or painted.
struct UserRegions {
  std::vector<RegionRule> rules{};
  std::vector<float> painted{};  ///< in [0, 1], of each pixel of the crop; empty if none are

  /// The parameter `regions`.
  static ParameterSpec parameter();
  /// Raises UsageError, SceneError (rules) or IoError (files).
  static UserRegions read(const std::string& path, const Scene& scene,
                          const RenderSettings& settings);

  bool empty() const { return rules.empty() && painted.empty(); }
  /// Weights that rules set, by region. `omc_weight`: of the choice `omc`.
  std::vector<std::optional<float>> fixed_weights(const Regions& regions, const Scene& scene,
                                                  float omc_weight) const;
};

}  // namespace ajar
