#pragma once
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "image/features.h"
#include "integrator/integrator.h"

namespace ajar {

/// Rays per pixel for the features of a picture of so many samples per pixel: one for every eighth,
/// within bounds.
std::uint32_t feature_rays(std::uint64_t samples);

/// Traces auxiliary buffers of a scene for denoisers: camera rays are followed through mirrors and
/// clear glass, at random by Fresnel's equations, to the first surface that scatters, each pixel's
/// mean over its own square. Of the crop; by the picture's seed and the number of rays, whatever
/// the integrator does. Several threads may use it.
class FeatureTracer {
 public:
  using Progress = std::function<bool(double done)>;

  /// `scene` must outlive it.
  FeatureTracer(const Scene& scene, RenderSettings settings);

  /// Traces the rays that are missing to so many per pixel, on all threads. Calls `progress` with
  /// the finished part, in [0, 1], from any thread; false cancels it, and rows have different
  /// numbers of rays. False if it was cancelled.
  bool trace(std::uint32_t rays, const Progress& progress = {});
  /// Features by the rays so far.
  Features features() const;
  /// Features of a picture by at least so many rays; empty if `progress` ended it.
  std::optional<Features> look(std::uint32_t rays, const Progress& progress = {});

 private:
  void trace_row(int y, std::uint32_t rays);

  const Scene& scene_;
  const RenderSettings settings_;
  const Vec2i size_;
  mutable std::mutex mutex_;         // guards those below
  std::vector<std::uint32_t> rays_;  ///< rays per pixel, of each row
  Features sums_;
};

}  // namespace ajar
