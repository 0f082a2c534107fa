#pragma once
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "core/archive_forward.h"
#include "image/importance_map.h"
#include "transport/efficiency_cells.h"

namespace ajar {

/// State of roulette by efficiency (`EfficiencyCells`) in a render of ordinary Monte Carlo: what a
/// ray has to bring, pixel by pixel, and what rays bring, place by place. It is frozen for a round,
/// and learns for the next.
///
/// With variance V and C rays per camera sample, the error after a given time follows V · C. A ray
/// of contribution v, traced with probability q, adds v²/q to V and q to C, so that V · C is
/// smallest with q = v / √(V/C), or 1 if that is more: √(V/C) is the price of a ray. It decides
/// nothing but how many samples there are of each part of a path, so no price, and no change of it
/// between rounds, biases the picture.
class EfficientRoulette {
 public:
  /// For the pixels of `crop`. `magnitude`: of the light of the picture, radiance, positive.
  EfficientRoulette(const Box3& scene, const Box2i& crop, double magnitude)
      : crop_(crop), cells_(scene, magnitude), light_cells_(scene, 1.0) {}

  /// False until a round has ended that showed noise.
  bool is_known() const { return !worths_.empty(); }
  /// Rays that one unit of light is worth there. Only if that is known.
  float rays_per_unit_light(const Vec2& raster) const { return worths_[pixel_at(crop_, raster)]; }
  /// In luminance · importance; 0 as long as it is not known.
  double price() const { return price_; }
  EfficiencyCells& cells() { return cells_; }
  /// For light subpaths, in rays.
  EfficiencyCells& light_cells() { return light_cells_; }

  /// Work that was done; from any thread.
  void count(std::uint64_t rays, std::uint64_t samples);
  /// Between passes. `variance`: of one camera sample, (luminance · importance)², pixel by pixel.
  /// Where there is no noise, all stays as it is.
  void end_round(const ImportanceMap& importance, std::span<const double> variance);

  std::uint64_t memory_bytes() const;
  void save_state(OutputArchive& archive) const;
  /// Raises a std::exception if the bytes make no sense.
  void load_state(InputArchive& archive);
  /// Sums since the last exchange, as `EfficiencyCells` has them.
  void export_delta(OutputArchive& archive);
  void import_delta(InputArchive& archive);

 private:
  struct Counts {
    std::uint64_t rays = 0;
    std::uint64_t samples = 0;
  };

  Box2i crop_;
  EfficiencyCells cells_;
  EfficiencyCells light_cells_;
  double price_ = 0.0;
  std::vector<float> worths_;  ///< importance / price, pixel by pixel; empty if not known
  std::atomic<std::uint64_t> rays_{0};
  std::atomic<std::uint64_t> samples_{0};
  Counts known_;  ///< counts of all processes
};

}  // namespace ajar
