#pragma once

namespace ajar {

/// The fitted numbers of the wing, beside parameters, which tell their own ranges; see
/// `SelectiveHeuristics`.
struct MetropolisHeuristics {
  /// Chains do not go beyond: each keeps numbers for all vertices that it may have.
  /// Unit: edges. Range: >= 1. Source: c345e65, for memory; half and double not measured.
  static constexpr int kMostEdges = 1000;
  /// Of the bootstrap of each population, however little light its paths are expected to carry.
  /// Unit: paths. Range: >= 1. Source: a1480d1; set by hand, no study.
  static constexpr double kFewestBootstrapPaths = 64.0;
  /// Share of small steps that move the place on the picture alone, where `raster-steps` is auto.
  /// `SelectiveHeuristics::kRasterStepsOfAllLight` is the same for chains that make nearly all
  /// light.
  /// Unit: share. Range: [0, 1]. Source: docs/chains.md, "Steps, and what they are worth": 0.5 and
  /// 0.9 are worse by a few percent on pool and level on torus-in-glass.
  static constexpr double kRasterSteps = 0.7;
};

}  // namespace ajar
