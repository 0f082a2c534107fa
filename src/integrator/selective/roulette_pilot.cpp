#include "integrator/selective/roulette_pilot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/random.h"
#include "core/random_use.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/selective/heuristics.h"
#include "transport/heuristics.h"
#include "transport/sources.h"

namespace ajar {

namespace {

/// Work items, so that threads share the places.
constexpr std::uint64_t kItems = 16;
/// Places on the film in each, with two camera samples.
constexpr std::uint64_t kPairs = SelectiveHeuristics::kPilotPlaces / kItems;

}  // namespace

/// Adds up what camera samples bring, and what each of their vertices had yet to.
class RoulettePilot::Sink final : public PathSink {
 public:
  /// `light_subpaths`: per camera sample, of those that are traced alone.
  Sink(const SelectivePreparation& prepared, const PathSampler& sampler, double light_subpaths,
       Sums& sums)
      : view_(prepared.view),
        brightness_(prepared.brightness),
        sampler_(sampler),
        light_subpaths_(light_subpaths),
        sums_(sums) {}

  void begin(const Vec2& raster) {
    raster_ = raster;
    light_ = 0.0;
    departures_.clear();
  }
  void add(const Contribution& contribution) override {
    const bool from_light = contribution.technique.t == 1;
    const float importance = view_.importance(from_light ? contribution.raster : raster_);
    const double light = std::min(static_cast<double>(luminance(contribution.value) * importance),
                                  SelectiveHeuristics::kBright * brightness_);
    if (!(light > 0.0)) return;
    if (from_light) {
      sums_.variance += light_subpaths_ * light * light;
    } else {
      light_ += light;
    }
  }
  bool reaches(const Vec2& raster) const override { return view_.contains(raster); }
  float rays_per_unit_light(const Vec2& raster) const override {
    return view_.importance(raster) /
           static_cast<float>(SelectiveHeuristics::kUsualPrice * brightness_);
  }
  void scattered(Stream stream, const PathVertex& vertex, const Flight& flight) override {
    if (stream != Stream::Camera || vertex.edges < TransportHeuristics::kEfficientRouletteStart)
      return;
    // The scale has `worth` · Λ in it.
    const auto expected = static_cast<double>(flight.throughput.max() * flight.roulette_scale);
    departures_.push_back({expected * SelectiveHeuristics::kUsualPrice, light_, rays()});
  }
  /// Luminance · importance of the camera sample.
  double end() {
    for (const Departure& departure : departures_) {
      if (!(departure.throughput > 0.0)) continue;
      const double rest = light_ - departure.light;
      sums_.brought += rest * rest / departure.throughput;
      sums_.taken += departure.throughput * (rays() - departure.rays);
    }
    return light_;
  }

 private:
  /// A subpath's, from one of its vertices.
  struct Departure {
    double throughput;  ///< times the importance of the place on the film
    double light;       ///< brought until then
    double rays;        ///< rays of the sampler until then
  };
  double rays() const { return static_cast<double>(sampler_.rays()); }

  const ChainView& view_;
  double brightness_;
  const PathSampler& sampler_;
  double light_subpaths_;
  Sums& sums_;
  Vec2 raster_{0.F, 0.F};
  double light_ = 0.0;
  std::vector<Departure> departures_;
};

RoulettePilot::RoulettePilot(const SelectivePreparation& prepared) : prepared_(prepared) {}

double RoulettePilot::effort() const {
  return static_cast<double>(2 * kItems * kPairs) / static_cast<double>(prepared_.pixels());
}

std::uint64_t RoulettePilot::begin() {
  const PathFamilyDefaults& omc = prepared_.techniques.omc;
  sampler_ = sampler_settings(prepared_.config.settings, SelectivePreparation::omc_parameters(omc));
  sampler_.camera_rest = static_cast<float>(prepared_.brightness);
  sums_.resize(kItems);
  return kItems;
}

void RoulettePilot::run(std::uint64_t item, Counters& counters) {
  PathSampler sampler(prepared_.scene(), sampler_);
  const bool light_is_alone = light_alone(sampler_.techniques);
  const double light_subpaths = light_is_alone ? sampler_.light_subpaths : 1.0;
  Sums& sums = sums_[item];
  Sink sink(prepared_, sampler, light_subpaths, sums);
  double light_rays = 0.0;
  for (std::uint64_t pair = 0; pair < kPairs; ++pair) {
    const std::uint64_t seed =
        hash_numbers(prepared_.config.settings.seed, RandomUse::RouletteTrial, item, pair);
    Vec2 raster(0.F, 0.F);
    std::array<double, 2> light{};
    for (std::uint32_t i = 0; i < light.size(); ++i) {
      SobolSource source({seed, i, hash_numbers(seed, RandomUse::RouletteScramble), i});
      if (i == 0) {
        raster = prepared_.view.raster(source.get_pair({Stream::Camera, 0, kEmissionDirection}));
      }
      sink.begin(raster);
      if (light_is_alone) {
        const std::uint64_t before = sampler.rays();
        sampler.sample_light(source, sink);
        light_rays += static_cast<double>(sampler.rays() - before);
      }
      sampler.sample(source, raster, sink);
      light[i] = sink.end();
    }
    const double difference = light[0] - light[1];
    sums.variance += difference * difference;  // the variance of either, twice
  }
  sums.rays = static_cast<double>(sampler.rays()) - (1.0 - light_subpaths) * light_rays;
  counters.add_rays(sampler.ray_counts());
}

void RoulettePilot::end() {
  Sums all;
  for (const Sums& sums : sums_) {
    all.variance += sums.variance;
    all.rays += sums.rays;
    all.brought += sums.brought;
    all.taken += sums.taken;
  }
  if (!(all.variance > 0.0 && all.brought > 0.0 && all.taken > 0.0)) return;
  price_.emplace(prepared_.view.importance, std::sqrt(all.variance / all.rays),
                 std::sqrt(all.brought / all.taken));
}

}  // namespace ajar
