#include "image/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace ajar {

namespace {
void check(const Replicates& replicates, std::size_t at_least) {
  if (replicates.size() < at_least) throw std::invalid_argument("statistics: too few replicates");
  for (const auto& image : replicates) {
    if (image.size() != replicates.front().size()) {
      throw std::invalid_argument("statistics: replicates differ in size");
    }
  }
}

double mean_at(const Replicates& replicates, std::size_t i) {
  double sum = 0.0;
  for (const auto& image : replicates) sum += image[i];
  return sum / static_cast<double>(replicates.size());
}
}  // namespace

Replicates develop_replicates(const Film& film, std::span<const ScaledLayer> layers) {
  const auto complete = [&](const ScaledLayer& layer) {
    return layer.scales.size() == static_cast<std::size_t>(film.replicates());
  };
  if (layers.empty() || !std::all_of(layers.begin(), layers.end(), complete)) {
    throw std::invalid_argument("statistics: needs layers and one scale per replicate");
  }
  const auto develop = [&](const ScaledLayer& layer, int r) {
    return film.develop_replicate(layer.layer, r, layer.scales[static_cast<std::size_t>(r)]);
  };
  Replicates replicates;
  for (int r = 0; r < film.replicates(); ++r) {
    std::vector<float> sum = develop(layers[0], r);
    for (const ScaledLayer& layer : layers.subspan(1)) {
      const std::vector<float> image = develop(layer, r);
      std::transform(sum.begin(), sum.end(), image.begin(), sum.begin(), std::plus<>());
    }
    replicates.push_back(std::move(sum));
  }
  return replicates;
}

std::vector<float> replicate_mean(const Replicates& replicates) {
  check(replicates, 1);
  std::vector<float> mean(replicates.front().size());
  for (std::size_t i = 0; i < mean.size(); ++i)
    mean[i] = static_cast<float>(mean_at(replicates, i));
  return mean;
}

std::vector<float> replicate_median(const Replicates& replicates) {
  check(replicates, 1);
  std::vector<float> median(replicates.front().size());
  std::vector<float> values(replicates.size());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  for (std::size_t i = 0; i < median.size(); ++i) {
    std::transform(replicates.begin(), replicates.end(), values.begin(),
                   [&](const std::vector<float>& image) { return image[i]; });
    std::nth_element(values.begin(), middle, values.end());
    median[i] = *middle;
  }
  return median;
}

std::vector<float> standard_error(const Replicates& replicates) {
  check(replicates, 2);
  const auto count = static_cast<double>(replicates.size());
  std::vector<float> error(replicates.front().size());
  for (std::size_t i = 0; i < error.size(); ++i) {
    const double mean = mean_at(replicates, i);
    double squares = 0.0;
    for (const auto& image : replicates) squares += (image[i] - mean) * (image[i] - mean);
    error[i] = static_cast<float>(std::sqrt(squares / (count * (count - 1.0))));
  }
  return error;
}

double median_lit(std::span<const float> values) {
  std::vector<float> lit;
  for (const float v : values) {
    if (v != 0.F && std::isfinite(v)) lit.push_back(std::abs(v));
  }
  if (lit.empty()) return 0.0;
  const auto middle = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() / 2);
  std::nth_element(lit.begin(), middle, lit.end());
  return *middle;
}

Estimate image_mean(const Replicates& replicates) {
  check(replicates, 2);
  const auto count = static_cast<double>(replicates.size());
  std::vector<double> means;
  for (const auto& image : replicates) {
    means.push_back(std::accumulate(image.begin(), image.end(), 0.0) /
                    static_cast<double>(image.size()));
  }
  const double mean = std::accumulate(means.begin(), means.end(), 0.0) / count;
  double squares = 0.0;
  for (const double m : means) squares += (m - mean) * (m - mean);
  return {mean, std::sqrt(squares / (count * (count - 1.0))),
          static_cast<int>(replicates.size()) - 1};
}

}  // namespace ajar
