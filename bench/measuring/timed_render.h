#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "image/relative_error.h"
#include "integrator/integrator.h"
#include "measuring/variant.h"
#include "session/job/interrupts.h"
#include "session/output/picture_filter.h"

namespace ajar::bench {

struct TimedRender {
  std::vector<float> picture;         ///< direct + indirect, scene-linear RGB
  PictureEstimates estimates;         ///< for filters
  std::vector<float> standard_error;  ///< standard error of each value, from replicates
  std::optional<RelativeError> estimate;
  std::uint64_t samples = 0;  ///< per pixel
  /// CPU time of all threads, and of all that the integrator does: start-up phases count.
  double cpu_seconds = 0.0;
  bool complete = true;  ///< false if the user cut a pass short
};

/// Time limit of a render, and its threads.
struct TimeLimit {
  double cpu_seconds;
  int threads = 0;  ///< 0: as many as the machine offers
};

/// Renders for that many CPU-seconds, rounded up to whole passes, of which there are many.
TimedRender render_for(const TimeLimit& limit, const Scene& scene, const Variant& variant,
                       const RenderSettings& settings, const InterruptCount& user_interrupts);

}  // namespace ajar::bench
