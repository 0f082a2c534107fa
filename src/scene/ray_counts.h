#pragma once
#include <cstdint>

namespace ajar {

/// Rays that were asked for.
struct RayCounts {
  std::uint64_t rays = 0;  ///< nearest-hit and shadow rays
  /// Rays that could not be traced (`Scene::can_trace`), which lost their contribution.
  std::uint64_t rays_out_of_range = 0;

  void add_rays(const RayCounts& other) {
    rays += other.rays;
    rays_out_of_range += other.rays_out_of_range;
  }
};

}  // namespace ajar
