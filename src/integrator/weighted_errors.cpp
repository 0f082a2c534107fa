#include "integrator/weighted_errors.h"

#include <algorithm>

#include "core/spectrum.h"

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

WeightedErrors weighted_errors(const Replicates& replicates, const Box2i& crop,
                               const ImportanceMap& importance) {
  const auto count = static_cast<double>(replicates.size());
  const int width = crop.max.x - crop.min.x + 1;
  const std::size_t pixels = replicates.front().size() / 3;
  WeightedErrors errors{std::vector<double>(pixels), std::vector<double>(pixels)};
  for (std::size_t i = 0; i < pixels; ++i) {
    const Vec2i pixel(crop.min.x + static_cast<int>(i) % width,
                      crop.min.y + static_cast<int>(i) / width);
    const auto weight = static_cast<double>(importance(Vec2(pixel) + Vec2(0.5F, 0.5F)));
    double sum = 0.0;
    double squares = 0.0;
    for (const std::vector<float>& picture : replicates) {
      const double value = weight * static_cast<double>(luminance(Spectrum(
                                        picture[3 * i], picture[3 * i + 1], picture[3 * i + 2])));
      sum += value;
      squares += value * value;
    }
    errors.light[i] = sum / count;
    errors.variance[i] = std::max(0.0, squares - sum * sum / count) / (count * (count - 1.0));
  }
  return errors;
}

}  // namespace ajar
