#include "integrator/montecarlo/sample_sink.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/random.h"
#include "integrator/montecarlo/heuristics.h"

namespace ajar {

SampleSink::SampleSink(Film& film, const Divisions* divisions, const EfficientRoulette* roulette,
                       double cull_below, const GBuffer& g_buffer,
                       const TechniqueLayers& techniques, std::uint64_t seed, Counters& counters)
    : film_(film),
      divisions_(divisions),
      roulette_(roulette),
      rays_per_unit_light_(static_cast<float>(1.0 / cull_below)),
      layers_{film.layer("direct"), std::max(film.layer(kWeakLayer), film.layer("indirect")),
              film.layer(kStrongLayer)},
      g_buffer_(g_buffer),
      techniques_(techniques),
      seed_(seed),
      counters_(counters) {}

void SampleSink::begin_pixel(Vec2i pixel, int replicate) {
  pixel_ = pixel;
  replicate_ = replicate;
  division_ = divisions_ != nullptr ? &divisions_->of(replicate) : nullptr;
  if (division_ != nullptr && division_->takes_nothing()) division_ = nullptr;
}

void SampleSink::begin_sample(const Vec2& raster, float filter_weight, std::uint64_t sample) {
  raster_ = raster;
  filter_weight_ = filter_weight;
  sample_ = sample;
  sees_something_ = false;
  brought_ = 0.0;
  direct_ = Spectrum();
  indirect_ = Spectrum();
  strong_light_ = Spectrum();
}

void SampleSink::add(const Contribution& whole) {
  Contribution contribution = whole;
  if (division_ != nullptr && division_->divides(whole.technique)) {
    divide(contribution);
    if (layers_.strong >= 0) keep_strong_light(whole, contribution.value);
  }
  const Spectrum& value = contribution.value;
  if (!value.is_finite() || value.min() < 0.F) {
    discard(contribution);
    return;
  }
  const Spectrum& learned = learns_from_all_ ? whole.value : value;
  const bool direct = contribution.technique.depth() <= 2;
  if (!techniques_.empty() && !techniques_.add(film_, pixel_, filter_weight_, contribution)) {
    ++counters_.discarded_infinite;
  }
  if (contribution.technique.t == 1) {
    tally_.add_splat(contribution.technique, luminance(value));
    brought_to_lens_ +=
        static_cast<double>(luminance(learned) * rays_per_unit_light(contribution.raster));
    if (!film_.splat(direct ? layers_.direct : layers_.indirect, replicate_, contribution.raster,
                     value)) {
      discard(contribution);
    }
  } else {
    const float light = luminance(value);
    brought_ += static_cast<double>(luminance(learned));
    tally_.add_camera_contribution(contribution.technique, light * filter_weight_);
    (direct ? direct_ : indirect_) += value;
  }
}

bool SampleSink::reaches(const Vec2& raster) const {
  const Vec2 radius = film_.filter().radius();
  const Box2i& crop = film_.crop();
  return raster.x + radius.x > static_cast<float>(crop.min.x) &&
         raster.y + radius.y > static_cast<float>(crop.min.y) &&
         raster.x - radius.x < static_cast<float>(crop.max.x + 1) &&
         raster.y - radius.y < static_cast<float>(crop.max.y + 1);
}

float SampleSink::rays_per_unit_light(const Vec2& raster) const {
  return roulette_ != nullptr && roulette_->is_known() ? roulette_->rays_per_unit_light(raster)
                                                       : rays_per_unit_light_;
}

bool SampleSink::learns() const {
  return roulette_ != nullptr &&
         (sample_ < MonteCarloHeuristics::kSamplesToLearn ||
          hash_numbers(pixel_.x, pixel_.y, sample_) % MonteCarloHeuristics::kLearnsFromOneOf == 0);
}

bool SampleSink::knows_price() const { return roulette_ != nullptr && roulette_->is_known(); }

void SampleSink::first_vertex(const PathVertex& vertex, const Hit* hit, float distance) {
  sees_something_ = true;
  if (g_buffer_.empty()) return;
  g_buffer_.add(film_, pixel_, filter_weight_, sample_, distance, vertex, hit);
}

void SampleSink::keep_strong_for(const OutlierSink& sink) {
  keeps_strong_ = true;
  outlier_threshold_ = sink.threshold();
}

void SampleSink::hand_over(OutlierSink& sink, SampleSource& numbers) {
  for (OutlierPath& path : strong_) {
    if (path.technique.t > 1) {
      const float coverage = film_.coverage(path.raster);
      if (!(coverage > 0.F)) {
        // Rounding has put the ray on the film's border, where splats do not reach any pixel.
        put(layers_.indirect, path.value * filter_weight_);
        continue;
      }
      const float weight = filter_weight_ / coverage;
      path.value *= weight;
      path.energy *= static_cast<double>(weight);
    }
    if (sink.spread(numbers, path)) continue;
    if (!film_.splat(layers_.indirect, path.replicate, path.raster, path.value)) {
      ++counters_.discarded_infinite;
    }
  }
  strong_.clear();
}

void SampleSink::end_sample() {
  put(layers_.direct, direct_ * filter_weight_);
  put(layers_.indirect, indirect_ * filter_weight_);
  put(layers_.strong, strong_light_ * filter_weight_);
  if (!sees_something_) g_buffer_.add_nothing(film_, pixel_, sample_);
  tally_.end_sample();
}

void SampleSink::put(int layer, const Spectrum& value) {
  if (value.is_black()) return;
  if (!film_.add(layer, replicate_, pixel_, value)) ++counters_.discarded_infinite;
}

void SampleSink::divide(Contribution& contribution) {
  const Vec2& raster = contribution.technique.t == 1 ? contribution.raster : raster_;
  const Division::Parts parts = division_->parts(contribution, raster);
  if (keeps_strong_ && std::isfinite(parts.light) && parts.chains > 0.F) {
    keep_strong(contribution, raster, parts);
  }
  contribution.value *= parts.omc;
}

void SampleSink::keep_strong(const Contribution& contribution, const Vec2& raster,
                             const Division::Parts& parts) {
  OutlierPath path{contribution.technique,
                   raster,
                   replicate_,
                   parts.strength,
                   Spectrum(),
                   static_cast<double>(parts.light * parts.chains),
                   origin_ + static_cast<std::uint64_t>(contribution.light_subpath),
                   contribution.light_subpath,
                   contribution.unidirectional_only};
  const double survivor_weight = russian_roulette(path.energy, outlier_threshold_, path.key());
  if (survivor_weight == 0.0) return;
  path.value = contribution.value * (parts.chains * static_cast<float>(survivor_weight));
  path.energy *= survivor_weight;
  strong_.push_back(path);
}

void SampleSink::keep_strong_light(const Contribution& whole, const Spectrum& weak) {
  const Spectrum strong = whole.value - weak;
  if (!strong.is_finite() || strong.min() < 0.F || strong.is_black()) return;
  if (whole.technique.t == 1) {
    film_.splat(layers_.strong, replicate_, whole.raster, strong);
  } else {
    strong_light_ += strong;
  }
}

void SampleSink::discard(const Contribution& contribution) {
  const Spectrum& value = contribution.value;
  bool nan = false;
  bool infinite = false;
  for (int lane = 0; lane < 3; ++lane) {
    nan = nan || std::isnan(value[lane]);
    infinite = infinite || std::isinf(value[lane]);
  }
  ++(nan        ? counters_.discarded_nan
     : infinite ? counters_.discarded_infinite
                : counters_.discarded_negative);
  if (!counters_.first_discarded.empty()) return;
  const std::string x = std::to_string(pixel_.x);
  const std::string y = std::to_string(pixel_.y);
  counters_.first_discarded = std::string(nan        ? "NaN"
                                          : infinite ? "infinite"
                                                     : "negative") +
                              " contribution at pixel (" + x + ", " + y + "), sample " +
                              std::to_string(sample_) + ", technique (" +
                              std::to_string(contribution.technique.s) + ", " +
                              std::to_string(contribution.technique.t) +
                              "); to replay it: the same scene and resolution with --seed " +
                              std::to_string(seed_) + " --spp " + std::to_string(sample_ + 1);
  // Light subpaths belong to the whole picture, so only contributions of a camera path alone can be
  // replayed in a crop.
  if (contribution.technique.s <= 1) {
    counters_.first_discarded += " --crop " + x + "," + y + "," + std::to_string(pixel_.x + 1) +
                                 "," + std::to_string(pixel_.y + 1);
  }
}

}  // namespace ajar
