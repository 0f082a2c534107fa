#include "scene/light/light_sampler.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ajar {

namespace {
std::vector<float> powers(std::span<const std::unique_ptr<Light>> lights) {
  std::vector<float> result;
  result.reserve(lights.size());
  for (const auto& light : lights) {
    const float power = luminance(light->power());
    result.push_back(std::isnan(power) ? 0.F : std::clamp(power, 0.F, 1e30F));
  }
  return result;
}
}  // namespace

LightSampler::LightSampler(std::span<const std::unique_ptr<Light>> lights)
    : lights_(lights), by_power_(powers(lights)) {}

bool LightSampler::empty() const { return lights_.empty(); }

ChosenLight LightSampler::choose(const Vec3& /*reference*/, float u) const {
  return choose_emitter(u);
}

Pdf<Discrete> LightSampler::probability(const Vec3& /*reference*/, const Light& light) const {
  return emitter_probability(light);
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
