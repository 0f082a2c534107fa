#include "integrator/selective/brightness_pilot.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/random.h"
#include "core/random_use.h"
#include "image/heuristics.h"
#include "integrator/metropolis/member_chain.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/selective/heuristics.h"
#include "transport/sources.h"

namespace ajar {

namespace {

/// Mean of luminance · importance.
double mean_strength(const std::vector<float>& luminances, const Box2i& crop,
                     const ImportanceMap& importance) {
  const int width = crop.max.x - crop.min.x + 1;
  double sum = 0.0;
  for (std::size_t i = 0; i < luminances.size(); ++i) {
    const int x = crop.min.x + static_cast<int>(i) % width;
    const int y = crop.min.y + static_cast<int>(i) / width;
    if (!std::isfinite(luminances[i])) continue;
    sum += static_cast<double>(luminances[i]) *
           static_cast<double>(importance(Vec2(Vec2i(x, y)) + Vec2(0.5F, 0.5F)));
  }
  return sum / static_cast<double>(luminances.size());
}

/// Work items, and groups whose median tells the scale of the picture.
constexpr std::uint64_t kBrightnessItems = 16;

int side_for(std::uint64_t pixels) {
  const double enough = static_cast<double>(SelectiveHeuristics::kBrightnessSamples);
  const double side = std::ceil(std::sqrt(static_cast<double>(pixels) / enough));
  return std::min(static_cast<int>(side), ImageHeuristics::kImportanceBlur);
}

}  // namespace

class BrightnessPilot::Sink final : public PathSink {
 public:
  Sink(const BrightnessPilot& pilot, double light_subpaths, Found& found)
      : pilot_(pilot), light_subpaths_(light_subpaths), found_(found) {}
  void begin(std::size_t square) { found_.camera.push_back({square, Spectrum()}); }
  void add(const Contribution& contribution) override {
    if (!contribution.value.is_finite()) return;
    if (contribution.technique.t == 1) {
      const Spectrum value = contribution.value * static_cast<float>(light_subpaths_);
      const Vec2i square = pilot_.square_at(contribution.raster);
      found_.light.push_back(
          {static_cast<std::size_t>(square.y * pilot_.count_.x + square.x), value});
      found_.largest_lanes += static_cast<double>(value.max());
    } else {
      found_.camera.back().value += contribution.value;
      found_.largest_lanes += static_cast<double>(contribution.value.max());
    }
  }
  bool reaches(const Vec2& raster) const override {
    const Box2i& crop = pilot_.prepared_.config.settings.crop;
    return raster.x >= static_cast<float>(crop.min.x) &&
           raster.y >= static_cast<float>(crop.min.y) &&
           raster.x < static_cast<float>(crop.max.x + 1) &&
           raster.y < static_cast<float>(crop.max.y + 1);
  }

 private:
  const BrightnessPilot& pilot_;
  double light_subpaths_;  ///< per sample, of those that are traced alone
  Found& found_;
};

BrightnessPilot::BrightnessPilot(const SelectivePreparation& prepared)
    : prepared_(prepared), side_(side_for(prepared.pixels())) {
  const Vec2i size = prepared.config.settings.crop.size() + Vec2i(1, 1);
  count_ = (size + Vec2i(side_ - 1, side_ - 1)) / side_;
}

double BrightnessPilot::effort() const {
  return effort_of(prepared_.config.omc) * static_cast<double>(squares()) /
         static_cast<double>(prepared_.pixels());
}

std::uint64_t BrightnessPilot::begin() {
  sampler_ = sampler_settings(prepared_.config.settings,
                              SelectivePreparation::omc_parameters(prepared_.config.omc));
  found_.resize(kBrightnessItems);
  return kBrightnessItems;
}

Vec2i BrightnessPilot::square_at(const Vec2& raster) const {
  const Box2i& crop = prepared_.config.settings.crop;
  const Vec2i pixel(static_cast<int>(std::floor(raster.x)), static_cast<int>(std::floor(raster.y)));
  const Vec2i square = (pixel - crop.min) / side_;
  return {std::clamp(square.x, 0, count_.x - 1), std::clamp(square.y, 0, count_.y - 1)};
}

Box2i BrightnessPilot::pixels_of(Vec2i square) const {
  const Box2i& crop = prepared_.config.settings.crop;
  const Vec2i low = crop.min + square * side_;
  return {low, {std::min(low.x + side_ - 1, crop.max.x), std::min(low.y + side_ - 1, crop.max.y)}};
}

void BrightnessPilot::run(std::uint64_t item, Counters& counters) {
  PathSampler sampler(prepared_.scene(), sampler_);
  const bool has_light_alone = light_alone(sampler_.techniques);
  Sink sink(*this, has_light_alone ? sampler_.light_subpaths : 1.0, found_[item]);
  const auto across = static_cast<std::uint64_t>(count_.x);
  const std::uint64_t seed =
      hash_numbers(prepared_.config.settings.seed, RandomUse::BrightnessPilot);
  for (std::uint64_t i = item; i < squares(); i += kBrightnessItems) {
    sink.begin(i);
    const auto index = static_cast<std::uint32_t>(i);
    SobolSource source({seed, index, seed, index});
    const Box2i pixels = pixels_of({static_cast<int>(i % across), static_cast<int>(i / across)});
    const Vec2 raster =
        Vec2(pixels.min) + source.get_pair({Stream::Camera, 0, kEmissionDirection}) *
                               Vec2(pixels.size() + Vec2i(1, 1));
    sampler.sample(source, raster, sink);
    if (has_light_alone) sampler.sample_light(source, sink);
  }
  counters.add_rays(sampler.ray_counts());
}

PictureScale BrightnessPilot::scale() const {
  std::vector<double> means;
  double sum = 0.0;
  for (const Found& found : found_) {
    sum += found.largest_lanes;
    if (found.camera.empty()) continue;
    means.push_back(found.largest_lanes / static_cast<double>(found.camera.size()));
  }
  std::nth_element(means.begin(), means.begin() + static_cast<std::ptrdiff_t>(means.size() / 2),
                   means.end());
  const double mean = sum / static_cast<double>(squares());
  if (mean > 0.0 && std::isfinite(mean)) return {mean, means[means.size() / 2]};
  // More of them may tell the unit of sums.
  return measure_scale(prepared_.scene(), prepared_.config.settings,
                       SelectivePreparation::omc_parameters(prepared_.config.omc));
}

std::vector<Spectrum> BrightnessPilot::mean_light() const {
  std::vector<Spectrum> light(squares());
  std::vector<Spectrum> camera(squares());
  for (const Found& found : found_) {
    for (const Splat& splat : found.light) light[splat.square] += splat.value;
    for (const Splat& splat : found.camera) camera[splat.square] = splat.value;
  }
  // One light subpath stands for so many pixels.
  const double of_sample = static_cast<double>(prepared_.pixels()) / static_cast<double>(squares());
  for (std::size_t i = 0; i < light.size(); ++i) {
    const auto number = static_cast<int>(i);
    const Vec2i size = pixels_of({number % count_.x, number / count_.x}).size() + Vec2i(1, 1);
    light[i] = camera[i] + light[i] * static_cast<float>(of_sample / (size.x * size.y));
  }
  return light;
}

void BrightnessPilot::end() {
  const SelectiveConfig& config = prepared_.config;
  const Box2i& crop = config.settings.crop;
  const std::vector<Spectrum> light = mean_light();
  std::vector<float> picture;
  for (int y = crop.min.y; y <= crop.max.y; ++y) {
    for (int x = crop.min.x; x <= crop.max.x; ++x) {
      const Vec2i square = square_at(Vec2(Vec2i(x, y)));
      const Spectrum& value = light[static_cast<std::size_t>(square.y * count_.x + square.x)];
      picture.push_back(luminance(value));
      for (int lane = 0; lane < 3; ++lane) result_.first_look.push_back(value[lane]);
    }
  }
  result_.importance =
      config.relative_importance ? ImportanceMap::relative(crop, picture) : config.view.importance;
  result_.brightness = mean_strength(picture, crop, result_.importance);
  result_.scale = scale();
  found_.clear();
}

std::uint64_t DarkPilot::begin() {
  if (prepared_.brightness > 0.0) return 0;
  const std::vector<PathGroup>& groups = prepared_.groups();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const double share = bootstrap_share(groups, g);
    weights_.emplace_back(static_cast<std::size_t>(
        std::ceil(share * static_cast<double>(SelectiveHeuristics::kPilotSamples))));
    add_blocks(blocks_, g, 0, weights_.back().size());
  }
  return blocks_.size();
}

void DarkPilot::run(std::uint64_t item, Counters& counters) {
  const SampleBlock& block = blocks_[item];
  const PathGroup& group = prepared_.groups()[block.owner];
  const auto target = make_seed_target(prepared_.scene(), group, prepared_.view);
  const std::uint64_t seed =
      hash_numbers(prepared_.config.settings.seed, RandomUse::DarkPilot, group.depth);
  sample_bootstrap(*target, seed, block.first, block.last,
                   std::span(weights_[block.owner]).subspan(block.first));
  counters.add_rays(target->ray_counts());
}

void DarkPilot::end() {
  for (const std::vector<double>& weights : weights_) {
    brightness_ += std::accumulate(weights.begin(), weights.end(), 0.0) /
                   static_cast<double>(weights.size()) * prepared_.view.area_per_pixel();
  }
  if (!std::isfinite(brightness_)) brightness_ = 0.0;
  weights_.clear();
}

}  // namespace ajar
