#pragma once

namespace ajar {

/// The numbers of walks on specular manifolds. No picture's expectation hangs on them, as long as
/// walks that do not lead back are rejected.
struct PathHeuristics {
  /// A walk has arrived when the end of its chain is as near to its target as this.
  /// Unit: share of the length of the chain. Range: > 1e-6, where roundings of rays are. Source:
  /// docs/notebook/mutations.md, "When a walk back counts": half and double are each better in one
  /// scene and worse in another.
  static constexpr double kWalkTolerance = 1e-5;
  /// Most steps of a walk, halved ones included.
  /// Unit: steps. Range: >= 1. Source: docs/notebook/mutations.md, "Half and double of other
  /// numbers": half and double make no difference.
  static constexpr int kMostWalkSteps = 20;
};

}  // namespace ajar
