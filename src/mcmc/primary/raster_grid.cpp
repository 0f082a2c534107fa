#include "mcmc/primary/raster_grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ajar {

namespace {
constexpr std::int64_t kPlaces = std::int64_t{1} << 24;
}  // namespace

RasterGrid::Axis::Axis(float low, float size, int pixels) : low_(low), size_(size) {
  if (!(low >= 0.F && low < 1.F && size > 0.F && pixels > 0 && pixels < 0x10000)) {
    throw std::invalid_argument("a raster grid needs pixels that cover the unit square");
  }
  first_.push_back(0);
  for (int i = 1; i < pixels; ++i) {
    const double boundary = std::ceil((i - double{low}) / double{size} * double{kPlaces});
    const auto place = static_cast<std::int64_t>(std::min(boundary, double{kPlaces}));
    // A sliver of a pixel may fall between two places.
    first_.push_back(std::clamp(place, first_.back() + 1, kPlaces - (pixels - i)));
  }
  first_.push_back(kPlaces);
}

int RasterGrid::Axis::at(float u) const {
  const auto place = static_cast<std::int64_t>(u * 0x1p24F);
  int pixel = std::clamp(static_cast<int>(low_ + u * size_), 0, count() - 1);
  while (place < first_[static_cast<std::size_t>(pixel)]) --pixel;
  while (place >= first_[static_cast<std::size_t>(pixel) + 1]) ++pixel;
  return pixel;
}

float RasterGrid::Axis::place(int pixel, std::uint64_t bits) const {
  const std::int64_t first = first_[static_cast<std::size_t>(pixel)];
  const auto places =
      static_cast<std::uint64_t>(first_[static_cast<std::size_t>(pixel) + 1] - first);
  // 40 random bits for at most 2²⁴ places: none is preferred by more than 2⁻¹⁶.
  const auto chosen = static_cast<std::int64_t>(((bits >> 24U) * places) >> 40U);
  return static_cast<float>(first + chosen) * 0x1p-24F;
}

double RasterGrid::Axis::length(int pixel) const {
  const auto i = static_cast<std::size_t>(pixel);
  return static_cast<double>(first_[i + 1] - first_[i]) * 0x1p-24;
}

RasterGrid::RasterGrid(const Vec2& low, const Vec2& size, const Vec2i& pixels)
    : columns_(low.x, size.x, pixels.x), rows_(low.y, size.y, pixels.y) {}

Vec2i RasterGrid::neighbour(const Vec2i& pixel, const Vec2i& step) const {
  const Vec2i all = size();
  return {(pixel.x + step.x + all.x) % all.x, (pixel.y + step.y + all.y) % all.y};
}

}  // namespace ajar
