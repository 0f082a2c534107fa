#pragma once
#include <span>

#include "core/archive_forward.h"
#include "image/importance_map.h"

namespace ajar {

/// Contribution below which a ray of ordinary Monte Carlo is not worth tracing, for
/// efficiency-aware Russian roulette (after Rath et al. 2022, "EARS").
///
/// With variance V and C rays per camera sample, the error after a given time follows V · C. A ray
/// of contribution v, traced with probability q, adds v²/q to V and q to C, so that V · C is
/// smallest with q = v / √(V/C), or 1 if that is more: √(V/C) is the price of a ray. The v of a
/// connection is known. That of a camera subpath of throughput β is estimated as Λ · β for each of
/// the rays that the rest of it takes (see `RoulettePilot`). The price affects survival
/// probabilities alone, so no price, and no change of it between passes, biases the picture.
class RayPrice {
 public:
  /// `price`: in luminance · importance, until `adjust`. `rest`: Λ, in radiance. Both positive.
  /// `importance` must outlive it.
  RayPrice(const ImportanceMap& importance, double price, double rest)
      : importance_(&importance), price_(price), rest_(rest) {}

  /// Rays that one unit of light is worth there.
  float rays_per_unit_light(const Vec2& raster) const {
    return (*importance_)(raster) / static_cast<float>(price_);
  }
  /// In luminance · importance.
  double price() const { return price_; }
  /// Λ.
  double rest() const { return rest_; }

  /// `variance`: of one camera sample, (luminance · importance)², pixel by pixel. `rays`: per
  /// camera sample. Where there is no noise, the price stays.
  void adjust(std::span<const double> variance, double rays);

  void save_state(OutputArchive& archive) const;
  /// May raise any std::exception if the bytes make no sense.
  void load_state(InputArchive& archive);

 private:
  const ImportanceMap* importance_;
  double price_;
  double rest_;
};

}  // namespace ajar
