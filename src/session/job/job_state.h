#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/work_slice.h"
#include "image/relative_error.h"
#include "integrator/integrator.h"

namespace ajar {

/// A pass that was cut short: what is in the film already.
struct PartialPass {
  std::uint64_t first_sample = 0;
  std::uint64_t samples = 0;
  std::vector<std::uint8_t> done;  ///< per item of the round, 0 or 1
  int round = 0;
  int rounds = 1;  ///< rounds of the pass

  /// Finished part of it, in [0, 1]; all rounds count equally.
  double fraction() const;
};

/// Where a render stands between two passes. Together with the film's sums and what the integrator
/// saves, all that a render needs to go on with the same bits.
struct JobState {
  /// The relative error that was estimated after so many samples per pixel.
  struct ErrorMark {
    std::uint64_t samples = 0;
    double error = 0.0;
  };
  std::uint64_t samples_per_pixel = 0;  ///< samples of complete passes
  std::optional<PartialPass> partial;
  Counters counters;
  std::uint64_t passes = 0;
  double seconds = 0.0;        ///< time of rendering, wall clock, all runs together
  double cpu_seconds = 0.0;    ///< CPU time of all threads
  double chain_seconds = 0.0;  ///< CPU time of all threads: for items of Markov chains
  double seconds_per_sample = 0.0;
  std::optional<RelativeError> relative_error;
  std::uint64_t error_samples = 0;       ///< per pixel, when `relative_error` was taken
  std::vector<ErrorMark> recent_errors;  ///< at the latest milestones

  /// Samples per pixel, those of a partial pass counted in part: on average, the picture is as
  /// bright as so many samples make it.
  std::uint64_t mean_samples() const;
};

/// True if the error of a picture has reached `target` at the last of these milestones. Single
/// estimates can be low by luck, most easily early ones. So all of the latest estimates must agree,
/// each lowered by the samples that have come since: those from a half of the present samples on,
/// and at least three.
bool target_is_reached(const std::vector<JobState::ErrorMark>& recent, double target);
/// Forgets what `target_is_reached` does not need any more.
void forget_old_errors(std::vector<JobState::ErrorMark>& recent);

}  // namespace ajar
