#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "mcmc/kernel.h"
#include "transport/sample_source.h"

namespace ajar {

/// Part of the numbers that a step of a chain moves: all afresh, or by a small step both subpaths,
/// one, or only the raster position.
enum class StepKind : std::uint8_t { Large, SmallBoth, SmallCamera, SmallLight, SmallRaster };
/// Its number among a kernel's moves.
constexpr std::size_t move_of(StepKind kind) { return static_cast<std::size_t>(kind); }
/// The kinds, in this order.
std::span<const Move> primary_moves();

/// The numbers that a step may change.
struct Change {
  bool camera = true;
  bool light = true;
  bool connection = true;
  bool raster = false;  ///< only the two raster numbers of the camera's
  /// True if all numbers of a stream move.
  bool moves(Stream stream) const {
    if (stream == Stream::Camera) return camera;
    return stream == Stream::Light ? light : connection;
  }
  /// True if the camera's half of a path may change.
  bool moves_camera_half() const { return camera || raster; }
};

/// Halves whose moves take the numbers of `Stream::Connection` along; moves of both always do.
struct ConnectionMoves {
  bool with_camera = true;
  bool with_light = false;
};

/// Lengths of small steps are counted by their variance. A step of the mutation's own length has so
/// many units, one of 1/8 of its length 1/64 of them.
inline constexpr std::uint64_t kStepUnits = 4096;

/// Probability of each kind of step, independent of the state.
struct StepProbabilities {
  double large = 0.3;
  /// Shares of the small steps that do not move the raster numbers alone; the rest moves both
  /// halves.
  double camera_half = 0.0;
  double light_half = 0.0;
  /// Share of the small steps that have 1/8 or 1/64 of the length, one as often as the other: where
  /// light is found in a narrow place only, steps of one length hardly ever end in it again.
  double fine = 0.0;
  /// Share of the small steps that move the raster numbers alone. Directions stay, so that such a
  /// step is accepted more often than others, and spreads light over the picture.
  double raster = 0.0;

  /// Raises std::invalid_argument unless all shares are probabilities.
  void check() const;
  /// `u` uniform in [0, 1).
  StepKind choose(double u) const;
  /// Units of a small step.
  std::uint64_t choose_length(double u) const;
};

/// Numbers that a step changes in a state that uses its raster numbers for its position, or in one
/// that does not (a light subpath that is connected to the lens). In the latter, steps of the
/// raster numbers move the light's half instead, and never the numbers that decide the kind of a
/// state: so such a step is as probable as the reverse.
Change change_of(StepKind kind, ConnectionMoves connection, bool uses_raster);

/// Data of a step before its proposal.
struct PrimaryStep {
  std::uint64_t key = 0;  ///< names its randomness
  StepKind kind = StepKind::Large;
  Change change;
  std::uint64_t units = kStepUnits;  ///< length of a small step
  bool large() const { return kind == StepKind::Large; }
};

}  // namespace ajar
