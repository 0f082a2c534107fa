#include "integrator/montecarlo/weighted_errors.h"

#include <algorithm>

#include "core/spectrum.h"
#include "integrator/montecarlo/heuristics.h"

namespace ajar {

Replicates develop_layers(const Film& film, const Integrator& integrator, std::uint64_t samples,
                          std::initializer_list<std::string> names) {
  std::vector<ScaledLayer> layers;
  for (const std::string& name : names) {
    ScaledLayer scaled{film.layer(name), {}};
    if (scaled.layer < 0) continue;
    const LayerSpec& spec = film.layers()[static_cast<std::size_t>(scaled.layer)];
    for (int r = 0; r < film.replicates(); ++r) {
      scaled.scales.push_back(integrator.develop_scale(spec, samples, r));
    }
    layers.push_back(std::move(scaled));
  }
  return develop_replicates(film, layers);
}

std::vector<std::vector<float>> weighted_light(const Replicates& replicates, const Box2i& crop,
                                               const ImportanceMap& importance) {
  const int width = crop.max.x - crop.min.x + 1;
  std::vector<std::vector<float>> light;
  for (const std::vector<float>& picture : replicates) {
    std::vector<float>& values = light.emplace_back(picture.size() / 3);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Vec2i pixel(crop.min.x + static_cast<int>(i) % width,
                        crop.min.y + static_cast<int>(i) / width);
      values[i] = importance(Vec2(pixel) + Vec2(0.5F, 0.5F)) *
                  luminance(Spectrum(picture[3 * i], picture[3 * i + 1], picture[3 * i + 2]));
    }
  }
  return light;
}

std::vector<double> variance_of_mean(std::span<const std::vector<float>> pictures) {
  const auto count = static_cast<double>(pictures.size());
  std::vector<double> variance(pictures.front().size());
  for (std::size_t i = 0; i < variance.size(); ++i) {
    double sum = 0.0;
    double squares = 0.0;
    for (const std::vector<float>& picture : pictures) {
      const auto value = static_cast<double>(picture[i]);
      sum += value;
      squares += value * value;
    }
    variance[i] = std::max(0.0, squares - sum * sum / count) / (count * (count - 1.0));
  }
  return variance;
}

WeightedErrors weighted_errors(const Replicates& replicates, const Box2i& crop,
                               const ImportanceMap& importance) {
  const std::vector<std::vector<float>> light = weighted_light(replicates, crop, importance);
  WeightedErrors errors{variance_of_mean(light), std::vector<double>(light.front().size())};
  for (const std::vector<float>& picture : light) {
    for (std::size_t i = 0; i < picture.size(); ++i) {
      errors.light[i] += static_cast<double>(picture[i]) / static_cast<double>(light.size());
    }
  }
  return errors;
}

std::vector<double> WeightedErrors::of_sample(std::uint64_t samples) const {
  std::vector<double> result = variance;
  for (double& value : result) value *= static_cast<double>(samples);
  return result;
}

ImportanceMap relative_importance(const Replicates& replicates, const Box2i& crop) {
  const std::vector<float> mean = replicate_mean(replicates);
  std::vector<float> luminances(mean.size() / 3);
  for (std::size_t i = 0; i < luminances.size(); ++i) {
    luminances[i] = luminance(Spectrum(mean[3 * i], mean[3 * i + 1], mean[3 * i + 2]));
  }
  const bool is_black =
      std::none_of(luminances.begin(), luminances.end(), [](float value) { return value > 0.F; });
  return is_black ? ImportanceMap() : ImportanceMap::relative(crop, std::move(luminances));
}

std::vector<double> trimmed(std::vector<double> variance) {
  constexpr std::size_t kOneOf = MonteCarloHeuristics::kWorstOf;
  std::vector<double> sorted = variance;
  const auto limit = sorted.end() - static_cast<std::ptrdiff_t>(sorted.size() / kOneOf);
  if (limit == sorted.end()) return variance;
  std::nth_element(sorted.begin(), limit, sorted.end());
  // Where hardly any pixel has an error at all, those few are what matters.
  if (!(*limit > 0.0)) return variance;
  for (double& value : variance) {
    if (value >= *limit) value = 0.0;
  }
  return variance;
}

}  // namespace ajar
