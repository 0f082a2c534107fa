#include "integrator/selective/brightness_pilot.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "core/random.h"
#include "core/random_use.h"
#include "integrator/metropolis/member_chain.h"
#include "integrator/selective/heuristics.h"

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

}  // namespace

BrightnessPilot::BrightnessPilot(const SelectivePreparation& prepared) : prepared_(prepared) {}

double BrightnessPilot::effort() const {
  return effort_with(prepared_.config.omc.light_paths_per_pixel);
}

std::uint64_t BrightnessPilot::begin() {
  const SelectiveConfig& config = prepared_.config;
  RenderSettings settings = config.settings;
  settings.replicates = 1;
  settings.aovs.clear();
  settings.seed = hash_numbers(settings.seed, RandomUse::BrightnessPilot);
  result_.scale =
      measure_scale(config.scene, settings, SelectivePreparation::omc_parameters(config.omc));
  omc_ = prepared_.make_omc(config.omc, settings, {.scale = result_.scale});
  film_ =
      std::make_unique<Film>(settings.resolution, settings.crop, Filter::box(), 1, omc_->layers());
  return omc_->items_in_round();
}

void BrightnessPilot::run(std::uint64_t item, Counters& counters) {
  Counters own;
  omc_->run_item(item, 0, 1, *film_, own);
  counters.add_rays(own);
}

std::vector<float> BrightnessPilot::colors(const char* layer) const {
  return film_->develop(film_->layer(layer), 1.0);
}

void BrightnessPilot::end() {
  const SelectiveConfig& config = prepared_.config;
  std::vector<float> picture(config.pixels());
  result_.first_look.assign(3 * picture.size(), 0.F);
  for (const char* layer : {"direct", "indirect"}) {
    const std::vector<float> light = colors(layer);
    for (std::size_t i = 0; i < picture.size(); ++i) {
      picture[i] += luminance(Spectrum(light[3 * i], light[3 * i + 1], light[3 * i + 2]));
    }
    std::transform(light.begin(), light.end(), result_.first_look.begin(),
                   result_.first_look.begin(), std::plus<>());
  }
  const Box2i& crop = config.settings.crop;
  result_.importance =
      config.relative_importance ? ImportanceMap::relative(crop, picture) : config.view.importance;
  result_.brightness = mean_strength(picture, crop, result_.importance);
  film_.reset();
  omc_.reset();
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
