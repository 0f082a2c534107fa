#pragma once
#include <cstdint>
#include <vector>

#include "image/film.h"
#include "integrator/division.h"
#include "integrator/integrator.h"
#include "integrator/montecarlo/efficient_roulette.h"
#include "integrator/montecarlo/g_buffer.h"
#include "integrator/montecarlo/technique_layers.h"
#include "integrator/montecarlo/technique_tally.h"
#include "integrator/outlier_paths.h"
#include "transport/path_sampler.h"
#include "transport/sample_source.h"

namespace ajar {

/// Sink of ordinary Monte Carlo's paths: gathers those of one camera sample, splats those of its
/// light subpath, leaves Markov chains their part, and gives the sampler the worth of rays. The
/// layers of the film are `direct` and, for longer paths, `kWeakLayer` if there is one, else
/// `indirect`. Contributions that are not finite or negative are left out and counted.
class SampleSink final : public PathSink {
 public:
  /// `divisions` is null where nothing is left to chains; `cull_below`: contribution worth a ray
  /// as long as no `roulette` knows better. References must outlive the sink.
  SampleSink(Film& film, const Divisions* divisions, const EfficientRoulette* roulette,
             double cull_below, const GBuffer& g_buffer, const TechniqueLayers& techniques,
             std::uint64_t seed, Counters& counters);

  void begin_pixel(Vec2i pixel, int replicate);
  /// `raster`: where the camera ray goes through the film. Its contributions have the weight
  /// `filter_weight`.
  void begin_sample(const Vec2& raster, float filter_weight, std::uint64_t sample);
  /// Before the paths of a camera sample or light subpath: its name.
  void begin_paths(std::uint64_t sample) { origin_ = sample; }

  void add(const Contribution& whole) override;
  bool reaches(const Vec2& raster) const override;
  float rays_per_unit_light(const Vec2& raster) const override;
  double brought() const override { return brought_; }
  double brought_to_lens() const override { return brought_to_lens_; }
  bool learns() const override;
  bool knows_price() const override;
  void first_vertex(const PathVertex& vertex, const Hit* hit, float distance) override;

  /// From now on keeps strong paths, above the threshold of `sink`.
  void keep_strong_for(const OutlierSink& sink);
  /// From now on roulette learns from all light, that which is left to chains included.
  void learn_from_all() { learns_from_all_ = true; }
  /// Lets a sink have the strong paths found since the last call. Those seen by a camera ray are
  /// worth its filter weight, and as much more as there are fewer rays near the film's border.
  void hand_over(OutlierSink& sink, SampleSource& numbers);

  void end_sample();
  void end_pixel(std::uint64_t samples) { tally_.end_pixel(static_cast<double>(samples)); }
  void end() { counters_.techniques += tally_.shares(); }

 private:
  struct Layers {
    int direct;
    int indirect;
    int strong;  ///< −1 if not recorded
  };

  void put(int layer, const Spectrum& value);
  /// Leaves chains their share.
  void divide(Contribution& contribution);
  void keep_strong(const Contribution& contribution, const Vec2& raster,
                   const Division::Parts& parts);
  void keep_strong_light(const Contribution& whole, const Spectrum& weak);
  void discard(const Contribution& contribution);

  Film& film_;
  const Divisions* divisions_;
  const Division* division_ = nullptr;  ///< division of the replicate
  const EfficientRoulette* roulette_;
  float rays_per_unit_light_;
  Layers layers_;
  const GBuffer& g_buffer_;
  const TechniqueLayers& techniques_;
  TechniqueTally tally_;
  std::uint64_t seed_;
  Counters& counters_;
  Vec2i pixel_{0, 0};
  Vec2 raster_{0.F, 0.F};
  int replicate_ = 0;
  float filter_weight_ = 1.F;
  std::uint64_t sample_ = 0;
  bool sees_something_ = false;   ///< the camera ray of this sample has met something
  double brought_ = 0.0;          ///< luminance, of this sample
  double brought_to_lens_ = 0.0;  ///< rays
  Spectrum direct_;
  Spectrum indirect_;
  Spectrum strong_light_;
  bool keeps_strong_ = false;
  bool learns_from_all_ = false;
  double outlier_threshold_ = 0.0;  ///< Russian roulette of outlier paths
  std::uint64_t origin_ = 0;
  std::vector<OutlierPath> strong_;
};

}  // namespace ajar
