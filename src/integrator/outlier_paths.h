#pragma once
#include <cmath>
#include <cstdint>
#include <memory>

#include "core/random.h"
#include "image/film.h"
#include "integrator/integrator.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Part of a path that ordinary Monte Carlo has found and leaves to chains.
struct OutlierPath {
  Technique technique;
  Vec2 raster;
  int replicate;
  float strength;        ///< g of the division (`Division`)
  Spectrum value;        ///< the chains' share, as it would be splatted
  double energy;         ///< luminance · importance of it; below 0 in negative lobes of a filter
  std::uint64_t sample;  ///< names the camera sample and the light subpath that found it
  /// Index of the sample's light subpath, if s ≥ 2. Not saved: the path's numbers are.
  int light_subpath = 0;
  bool unidirectional_only = false;  ///< as in `Contribution`
  /// Key of its random numbers.
  std::uint64_t key() const {
    return hash_numbers(sample, static_cast<std::uint64_t>(technique.s),
                        static_cast<std::uint64_t>(technique.t));
  }
};

/// Russian roulette below `threshold`; returns the survivor's weight, 0 if terminated. `key` names
/// the randomness.
inline double russian_roulette(double carried, double threshold, std::uint64_t key) {
  carried = std::abs(carried);
  if (carried >= threshold) return 1.0;
  const auto u = static_cast<double>(to_unit_float(static_cast<std::uint32_t>(key >> 32U)));
  return u * threshold < carried ? threshold / carried : 0.0;
}

/// Receiver of such paths, on one thread.
class OutlierSink {
 public:
  virtual ~OutlierSink() = default;
  /// Energy below which paths come by Russian roulette; constant.
  virtual double threshold() const { return 0.0; }
  /// `numbers`: those that the path was made of. Returns false if chains cannot make the path, for
  /// the caller to splat what `path` is then.
  virtual bool spread(SampleSource& numbers, OutlierPath& path) = 0;
};

/// Makes the sinks of work items.
class OutlierSinkFactory {
 public:
  virtual ~OutlierSinkFactory() = default;
  /// For a film; film and counters must outlive the sink.
  virtual std::unique_ptr<OutlierSink> make(Film& film, Counters& counters) const = 0;
};

}  // namespace ajar
