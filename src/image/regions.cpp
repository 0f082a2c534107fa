#include "image/regions.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace ajar {

namespace {

/// Sets of pixels; each is known by the first of them.
class PixelSets {
 public:
  explicit PixelSets(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
  }
  std::size_t first(std::size_t pixel) {
    while (parents_[pixel] != pixel) {
      // Halving the way keeps later walks short.
      parents_[pixel] = parents_[parents_[pixel]];
      pixel = parents_[pixel];
    }
    return pixel;
  }
  void unite(std::size_t a, std::size_t b) {
    const auto [low, high] = std::minmax({first(a), first(b)});
    parents_[high] = low;
  }

 private:
  std::vector<std::size_t> parents_;
};

}  // namespace

Regions connected_regions(Vec2i size, std::span<const PixelIdentity> identities) {
  const auto width = static_cast<std::size_t>(std::max(size.x, 0));
  const std::size_t count = width * static_cast<std::size_t>(std::max(size.y, 0));
  if (identities.size() != count) {
    throw std::invalid_argument("regions: there is not one identity per pixel");
  }
  PixelSets sets(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % width != 0 && identities[i] == identities[i - 1]) sets.unite(i, i - 1);
    if (i >= width && identities[i] == identities[i - width]) sets.unite(i, i - width);
  }
  Regions regions{size, std::vector<std::uint32_t>(count), {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = sets.first(i);
    if (first == i) {
      regions.labels[i] = static_cast<std::uint32_t>(regions.count());
      regions.identities.push_back(identities[i]);
      regions.pixel_counts.push_back(0);
    }
    regions.labels[i] = regions.labels[first];
    ++regions.pixel_counts[regions.labels[i]];
  }
  return regions;
}

Plane fill_regions(const Regions& regions, std::span<const float> values) {
  if (values.size() != regions.count()) {
    throw std::invalid_argument("regions: there is not one value per region");
  }
  Plane plane(regions.size);
  std::transform(regions.labels.begin(), regions.labels.end(), plane.values.begin(),
                 [&](std::uint32_t label) { return values[label]; });
  return plane;
}

}  // namespace ajar
