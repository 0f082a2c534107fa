#pragma once
#include <cstddef>

namespace ajar {

/// The fitted numbers of the wing.
struct RegionHeuristics {
  /// Difference of depths where an edge counts as whole.
  /// Unit: share of the nearer depth. Range: > 0. Source: d2c038e; set by hand, no study.
  static constexpr float kDepthStep = 0.05F;
  /// Angle between normals where an edge counts as whole.
  /// Unit: radians. Range: > 0. Source: d2c038e; set by hand, no study.
  static constexpr float kNormalAngle = 0.35F;
  /// Camera rays alone that cost as much as one camera sample.
  /// Unit: rays. Range: >= 1. Source: an estimate, for the time of a preparation only.
  static constexpr double kCameraRaysOfSample = 10.0;
  /// The largest regions, in statistics.
  /// Unit: regions. Range: >= 1. Source: set by hand.
  static constexpr std::size_t kMostRegionsListed = 200;
};

}  // namespace ajar
