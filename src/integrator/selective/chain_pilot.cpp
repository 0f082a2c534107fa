#include "integrator/selective/chain_pilot.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/random.h"
#include "core/random_use.h"
#include "integrator/selective/heuristics.h"

namespace ajar {

namespace {
/// Of each pixel: small pictures need more to show how bright they are.
std::uint64_t pilot_samples(const ChainPlan& plan) {
  return plan.pixels() < SelectiveHeuristics::kPixelsToTellBrightness ? 2 : 1;
}

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

ChainPilot::ChainPilot(ChainPlan& plan) : plan_(plan) {}

double ChainPilot::effort() const {
  return static_cast<double>(pilot_samples(plan_)) *
         ChainPlan::effort_with(plan_.omc.light_paths_per_pixel);
}

std::uint64_t ChainPilot::begin() {
  RenderSettings settings = plan_.settings;
  settings.replicates = 1;
  settings.aovs.clear();
  settings.seed = hash_numbers(settings.seed, RandomUse::BrightnessPilot);
  omc_ = plan_.make_omc(settings, {settings.min_depth, settings.max_depth});
  film_ =
      std::make_unique<Film>(settings.resolution, settings.crop, Filter::box(), 1, omc_->layers());
  return omc_->items_in_round();
}

void ChainPilot::run(std::uint64_t item, Counters& counters) {
  Counters own;
  omc_->run_item(item, 0, pilot_samples(plan_), *film_, own);
  counters.add_rays(own);
}

std::vector<float> ChainPilot::colors(const char* layer) const {
  return film_->develop(film_->layer(layer), 1.0 / static_cast<double>(pilot_samples(plan_)));
}

void ChainPilot::end() {
  std::vector<float> picture(plan_.pixels());
  plan_.first_look.assign(3 * picture.size(), 0.F);
  for (const char* layer : {"direct", "indirect"}) {
    const std::vector<float> light = colors(layer);
    for (std::size_t i = 0; i < picture.size(); ++i) {
      picture[i] += luminance(Spectrum(light[3 * i], light[3 * i + 1], light[3 * i + 2]));
    }
    std::transform(light.begin(), light.end(), plan_.first_look.begin(), plan_.first_look.begin(),
                   std::plus<>());
  }
  const Box2i& crop = plan_.settings.crop;
  if (plan_.parameters.get_text("importance") == "relative") {
    plan_.view.importance = ImportanceMap::relative(crop, picture);
  }
  plan_.brightness = mean_strength(picture, crop, plan_.view.importance);
  plan_.is_black = !(plan_.brightness > 0.0);
  if (!plan_.is_black) {
    plan_.moves.settings.large_step_cap = SelectiveHeuristics::kWhite * plan_.brightness;
  }
  if (!plan_.thresholds.empty() && !plan_.is_black) {
    plan_.divisions.emplace(Division(plan_.lowest_threshold(), plan_.view.importance));
  }
  film_.reset();
  omc_.reset();
}

}  // namespace ajar
