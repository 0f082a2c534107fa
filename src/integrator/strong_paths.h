#pragma once
#include <cmath>
#include <cstdint>
#include <memory>

#include "core/random.h"
#include "image/film.h"
#include "integrator/integrator.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Part of one sampled path that ordinary Monte Carlo leaves to chains.
struct StrongPath {
  Technique technique;
  Vec2 raster;
  int replicate;
  float strength;        ///< g of the division (`Division`)
  Spectrum value;        ///< the chains' share, as it would be splatted
  double energy;         ///< luminance · importance of it; below 0 in negative lobes of a filter
  std::uint64_t sample;  ///< names the camera sample and the light subpath that found it
  /// Index of the sample's light subpath, if s ≥ 2. Not saved: the path's numbers are.
  int light_subpath = 0;
  bool hit_only = false;  ///< as in `Contribution`
  /// Key of its random numbers.
  std::uint64_t key() const {
    return hash_numbers(sample, static_cast<std::uint64_t>(technique.s),
                        static_cast<std::uint64_t>(technique.t));
  }
};

/// Russian roulette below `grain`; returns the survivor's weight, 0 if terminated. `key` names the
/// randomness.
inline double draw_lot(double carried, double grain, std::uint64_t key) {
  carried = std::abs(carried);
  if (carried >= grain) return 1.0;
  const auto u = static_cast<double>(to_unit_float(static_cast<std::uint32_t>(key >> 32U)));
  return u * grain < carried ? grain / carried : 0.0;
}

/// Does something with such paths, on one thread.
class StrongPathSink {
 public:
  virtual ~StrongPathSink() = default;
  /// Threshold of the energy below which paths are subject to roulette (`draw_lot`); constant.
  virtual double grain() const { return 0.0; }
  /// `numbers`: those that the path was made of. Returns false if chains cannot make the path;
  /// `path` then holds the contribution to splat.
  virtual bool spread(SampleSource& numbers, StrongPath& path) = 0;
};

/// Makes the sinks of work items.
class StrongPathSinks {
 public:
  virtual ~StrongPathSinks() = default;
  /// For a film; film and counters must outlive the sink.
  virtual std::unique_ptr<StrongPathSink> make(Film& film, Counters& counters) const = 0;
};

}  // namespace ajar
