#include "integrator/regions/region_map.h"

#include <algorithm>
#include <stdexcept>

#include "integrator/regions/impulse_noise.h"

namespace ajar {

std::vector<RegionNoise> aggregate_noise(const Plane& noise, const Regions& regions,
                                         float threshold) {
  if (noise.size != regions.size) {
    throw std::invalid_argument("region map: noise and regions are of pictures of different sizes");
  }
  std::vector<RegionNoise> result(regions.count());
  // A region may have millions of pixels: too many to add in single precision.
  std::vector<double> sums(regions.count(), 0.0);
  for (std::size_t i = 0; i < noise.values.size(); ++i) {
    const float value = noise.values[i];
    if (!(value >= threshold)) continue;
    const std::uint32_t label = regions.labels[i];
    RegionNoise& region = result[label];
    region.largest = region.pixels == 0 ? value : std::max(region.largest, value);
    ++region.pixels;
    sums[label] += static_cast<double>(value);
  }
  for (std::size_t r = 0; r < result.size(); ++r) {
    if (result[r].pixels > 0) result[r].mean = static_cast<float>(sums[r] / result[r].pixels);
  }
  return result;
}

std::vector<float> threshold_map(std::span<const RegionNoise> noise,
                                 const RegionMapSettings& settings) {
  std::vector<float> map;
  map.reserve(noise.size());
  for (const RegionNoise& region : noise) {
    map.push_back(region.fill() < settings.threshold ? settings.epsilon : 1.F);
  }
  return map;
}

std::vector<float> region_map(std::span<const float> indirect, const Regions& regions,
                              const RegionMapSettings& settings) {
  const Plane noise = impulse_noise(regions.size, indirect, settings.window);
  return threshold_map(aggregate_noise(noise, regions, settings.threshold), settings);
}

}  // namespace ajar
