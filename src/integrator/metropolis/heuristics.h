#pragma once

namespace ajar {

/// The fitted numbers of the wing, beside parameters, which tell their own ranges.
struct MetropolisHeuristics {
  /// Chains do not go beyond: each keeps numbers for all vertices that it may have.
  /// Unit: edges. Range: >= 1. Source: c345e65, for memory; half and double not measured.
  static constexpr int kMostEdges = 1000;
  /// Least size of the bootstrap of each population, however little light its paths are expected to
  /// carry.
  /// Unit: paths. Range: >= 1. Source: a1480d1; set by hand, no study.
  static constexpr double kFewestBootstrapPaths = 64.0;
  /// Probability of a bootstrap sample of explicit paths to try manifold connections.
  /// Unit: probability. Range: (0, 1]. Source: set by hand: in water-caustic, where each costs as
  /// much as 70 others, 100 000 samples then take four seconds of one processor, and find 2700
  /// paths.
  static constexpr double kManifoldTries = 0.0625;
  /// Parts of the samples of a replicate of `erpt`, which threads share.
  /// Unit: items. Range: >= 1. Source: set by hand, for machines of up to 256 processors; no study.
  static constexpr double kMostItems = 64.0;
};

}  // namespace ajar
