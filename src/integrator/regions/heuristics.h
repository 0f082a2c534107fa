#pragma once

namespace ajar {

/// The fitted numbers of the wing.
struct RegionHeuristics {
  /// Difference of depths where an edge counts as whole.
  /// Unit: share of the nearer depth. Range: > 0. Source: d2c038e; set by hand, no study.
  static constexpr float kDepthStep = 0.05F;
  /// Angle between normals where an edge counts as whole.
  /// Unit: radians. Range: > 0. Source: d2c038e; set by hand, no study.
  static constexpr float kNormalAngle = 0.35F;
};

}  // namespace ajar
