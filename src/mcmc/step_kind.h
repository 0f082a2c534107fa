#pragma once
#include <cstddef>
#include <cstdint>

#include "transport/sample_source.h"

namespace ajar {

/// What one step of a chain moves: everything afresh, or by a small step both subpaths or one.
enum class StepKind : std::uint8_t { Large, SmallBoth, SmallCamera, SmallLight };
inline constexpr std::size_t kStepKinds = 4;

/// The streams whose numbers a step may change.
struct Change {
  bool camera = true;
  bool light = true;
  bool connection = true;
  bool moves(Stream stream) const {
    if (stream == Stream::Camera) return camera;
    return stream == Stream::Light ? light : connection;
  }
};

/// Which half moves take the numbers of `Stream::Connection` along; moves of both always do.
struct ConnectionMoves {
  bool with_camera = true;
  bool with_light = false;
};

/// How often each kind of step is made, whatever the state is.
struct StepProbabilities {
  double large = 0.3;
  /// Shares of the small steps; the rest moves both halves.
  double camera_half = 0.0;
  double light_half = 0.0;

  /// Raises std::invalid_argument unless all shares are probabilities.
  void check() const;
  /// `u` uniform in [0, 1).
  StepKind choose(double u) const;
};

Change change_of(StepKind kind, ConnectionMoves connection);

}  // namespace ajar
