#include "scene/light/light_sampler.h"

#include <algorithm>
#include <cmath>

namespace ajar {

namespace {
/// Powers and intensities of broken lights are not numbers.
float sane(float x) { return std::isnan(x) ? 0.F : std::clamp(x, 0.F, 1e30F); }
}  // namespace

LightSampler::LightSampler(std::span<const std::unique_ptr<Light>> lights,
                           const BoundingSphere& bounds)
    : lights_(lights), distant_index_(lights.size(), kPlaced) {
  std::vector<float> powers;
  std::vector<float> distant_powers;
  std::vector<LightTree::Item> items;
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    const Light& light = *lights[i];
    const float power = sane(luminance(light.power()));
    powers.push_back(power);
    if (std::optional<LightBounds> where = light.bounds()) {
      where->intensity = sane(where->intensity);
      if (power > 0.F && where->intensity > 0.F) items.push_back({*where, i});
    } else if (power > 0.F) {
      distant_index_[i] = static_cast<std::uint32_t>(distant_.size());
      distant_.push_back(i);
      distant_powers.push_back(power);
    }
  }
  by_power_ = Distribution1D(powers);
  if (lights.size() == 1) return;
  placed_ = !items.empty();
  tree_ = LightTree(std::move(items));
  distant_by_power_ = Distribution1D(distant_powers);
  const auto radius = static_cast<double>(bounds.radius);
  distant_irradiance_ = distant_by_power_.total() / (double{kPi} * radius * radius);
}

bool LightSampler::empty() const { return lights_.empty(); }

float LightSampler::distant_share(const Vec3& reference) const {
  if (distant_.empty()) return 0.F;
  // Neither kind gets less than a quarter: shadows, of walls most of all, are not in the estimates.
  // Measured against shares by power, by number and by irradiance alone on scenes in and out of
  // doors: none of these is better everywhere, all are much worse somewhere.
  const double near = tree_.irradiance(reference);
  const double share = distant_irradiance_ / (distant_irradiance_ + near);
  return static_cast<float>(0.25 + 0.5 * share);
}

float LightSampler::placed_probability(const Vec3& reference, std::uint32_t light) const {
  const float distant = distant_share(reference);
  const std::uint32_t index = distant_index_[light];
  if (index != kPlaced) return distant * distant_by_power_.probability(index);
  return (1.F - distant) * tree_.probability(reference, light);
}

ChosenLight LightSampler::choose(const Vec3& reference, float u) const {
  if (!placed_) return choose_emitter(u);
  if (u < kByPower) {
    const Distribution1D::Choice choice = by_power_.choose(u / kByPower);
    const float placed = placed_probability(reference, static_cast<std::uint32_t>(choice.index));
    return {lights_[choice.index].get(), Pdf<Discrete>(mixed(choice.probability, placed)),
            choice.u};
  }
  u = std::min((u - kByPower) / (1.F - kByPower), kOneMinusEpsilon);
  const float distant = distant_share(reference);
  if (u < distant) {
    const Distribution1D::Choice choice =
        distant_by_power_.choose(std::min(u / distant, kOneMinusEpsilon));
    const std::uint32_t light = distant_[choice.index];
    const float probability = mixed(by_power_.probability(light), distant * choice.probability);
    return {lights_[light].get(), Pdf<Discrete>(probability), choice.u};
  }
  u = std::min((u - distant) / (1.F - distant), kOneMinusEpsilon);
  const LightTree::Choice choice = tree_.choose(reference, u);
  const float probability =
      mixed(by_power_.probability(choice.light), (1.F - distant) * choice.probability);
  return {lights_[choice.light].get(), Pdf<Discrete>(probability), choice.u};
}

Pdf<Discrete> LightSampler::probability(const Vec3& reference, const Light& light) const {
  if (!placed_) return emitter_probability(light);
  return Pdf<Discrete>(
      mixed(by_power_.probability(light.index), placed_probability(reference, light.index)));
}

std::optional<float> LightSampler::invert(const Vec3& reference, const Light& light,
                                          float u) const {
  if (!placed_) return invert_emitter(light, u);
  const std::uint32_t index = light.index;
  const double by_power = double{kByPower} * static_cast<double>(by_power_.probability(index));
  const double placed =
      (1.0 - double{kByPower}) * static_cast<double>(placed_probability(reference, index));
  if (!(by_power + placed > 0.0)) return std::nullopt;
  UnitInterval numbers{0.0, double{kByPower}};
  if (came_first(by_power, placed, u)) {
    numbers = numbers.part(by_power_.interval(index));
  } else {
    numbers = {double{kByPower}, 1.0 - double{kByPower}};
    const double distant = distant_share(reference);
    const std::uint32_t place = distant_index_[index];
    numbers = place != kPlaced
                  ? numbers.part({0.0, distant}).part(distant_by_power_.interval(place))
                  : numbers.part({distant, 1.0 - distant}).part(tree_.interval(reference, index));
  }
  const float number = numbers.at(u);
  if (choose(reference, number).light != &light) return std::nullopt;
  return number;
}

std::optional<float> LightSampler::invert_emitter(const Light& light, float u) const {
  if (lights_.size() == 1) return u;
  if (!(by_power_.probability(light.index) > 0.F)) return std::nullopt;
  return by_power_.invert(light.index, u);
}

ChosenLight LightSampler::choose_emitter(float u) const {
  if (lights_.size() == 1) return {lights_.front().get(), Pdf<Discrete>(1.F), u};
  const Distribution1D::Choice choice = by_power_.choose(u);
  return {lights_[choice.index].get(), Pdf<Discrete>(choice.probability), choice.u};
}

Pdf<Discrete> LightSampler::emitter_probability(const Light& light) const {
  return Pdf<Discrete>(by_power_.probability(light.index));
}

}  // namespace ajar
