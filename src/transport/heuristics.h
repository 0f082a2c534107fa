#pragma once

namespace ajar {

/// The fitted numbers of the room, beside parameters, which declare their own ranges.
struct TransportHeuristics {
  /// First edge at which efficiency-aware roulette may end a walk. The reflectance of the first
  /// surface varies too much for one estimate.
  /// Unit: edges. Range: >= 1. Source: docs/notebook/selective.md, "Which rays are traced": from 1
  /// on, veach-mis has 1.5 times the error of ibpt, from 2 on 0.86; 4 not measured.
  static constexpr int kEfficientRouletteStart = 2;
};

}  // namespace ajar
