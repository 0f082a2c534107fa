#include "mcmc/primary/step_kind.h"

#include <array>
#include <stdexcept>

#include "mcmc/primary/heuristics.h"

namespace ajar {

std::span<const Move> primary_moves() {
  static constexpr std::array<Move, 5> kMoves = {
      {{"large", true}, {"small"}, {"camera"}, {"light"}, {"raster"}}};
  return kMoves;
}

void StepProbabilities::check() const {
  if (!(large >= 0.0 && large <= 1.0 && camera_half >= 0.0 && light_half >= 0.0 &&
        camera_half + light_half <= 1.0 && fine >= 0.0 && fine <= 1.0 && raster >= 0.0 &&
        raster <= 1.0)) {
    throw std::invalid_argument("shares of the kinds of steps must be probabilities");
  }
}

StepKind StepProbabilities::choose(double u) const {
  if (u < large) return StepKind::Large;
  const double among_small = (u - large) / (1.0 - large);
  if (among_small < raster) return StepKind::SmallRaster;
  const double among_others = (among_small - raster) / (1.0 - raster);
  if (among_others < camera_half) return StepKind::SmallCamera;
  if (among_others < camera_half + light_half) return StepKind::SmallLight;
  return StepKind::SmallBoth;
}

std::uint64_t StepProbabilities::choose_length(double u) const {
  if (u >= fine) return kStepUnits;
  constexpr std::array<std::uint64_t, 2> kFiner = PrimaryHeuristics::kFiner;
  return kStepUnits / (u < 0.5 * fine ? kFiner[0] : kFiner[1]);
}

Change change_of(StepKind kind, ConnectionMoves connection, bool uses_raster) {
  switch (kind) {
    case StepKind::SmallCamera:
      return {true, false, connection.with_camera};
    case StepKind::SmallLight:
      return {false, true, connection.with_light};
    case StepKind::SmallRaster:
      return {false, !uses_raster, false, uses_raster};
    case StepKind::Large:
    case StepKind::SmallBoth:
      break;
  }
  return {};
}

}  // namespace ajar
