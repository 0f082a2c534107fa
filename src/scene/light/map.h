#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/distribution.h"
#include "core/error.h"
#include "core/spectrum.h"
#include "core/vector.h"
#include "core/warnings.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Wrap mode of a map beyond its left and right edge. Beyond the upper and lower edge it always
/// keeps its edge value.
enum class MapEdge { Repeat, Clamp };
/// Interpolation between the centres of texels.
enum class MapFilter { Bilinear, Nearest };

/// An image that shapes the emission of a light: linear RGB, finite, not negative. Row 0 is at v =
/// 0.
class Map {
 public:
  /// Requires width, height > 0 and texels.size() = width · height, row by row. Values that are
  /// negative or not finite become zero, those above 1e30 become that.
  Map(int width, int height, std::vector<Spectrum> texels, MapEdge edge,
      MapFilter filter = MapFilter::Bilinear);

  /// Makes each texel the mean of its colours.
  void make_gray() {
    for (Spectrum& texel : texels_) texel = Spectrum(texel.average());
  }

  /// Puts the first and the last row at the upper and lower edge, and the others evenly between;
  /// without, their centres are half a row from the edges. Counts between texels, not for the
  /// nearest, and not for a map of one row.
  void put_rows_at_edges() {
    if (height_ == 1) return;
    row_steps_ = height_ - 1;
    first_row_ = 0.F;
  }

  int width() const { return width_; }
  int height() const { return height_; }
  /// Bands of the same height, between whose edges and middles the map is linear along v.
  int bands() const { return row_steps_; }
  /// Texel centres are at half-integers.
  Spectrum lookup(const Vec2& uv) const {
    if (filter_ == MapFilter::Nearest) {
      const int x = static_cast<int>(uv.x * static_cast<float>(width_));
      const int y = static_cast<int>(uv.y * static_cast<float>(height_));
      return row(y)[std::clamp(x, 0, width_ - 1)];
    }
    const float x = uv.x * static_cast<float>(width_) - 0.5F;
    const float y = uv.y * static_cast<float>(row_steps_) - first_row_;
    const float x0 = std::floor(x);
    const float y0 = std::floor(y);
    const float fx = x - x0;
    const float fy = y - y0;
    const int left = column(static_cast<int>(x0));
    const int right = column(static_cast<int>(x0) + 1);
    const Spectrum* upper = row(static_cast<int>(y0));
    const Spectrum* lower = row(static_cast<int>(y0) + 1);
    return (upper[left] * (1.F - fx) + upper[right] * fx) * (1.F - fy) +
           (lower[left] * (1.F - fx) + lower[right] * fx) * fy;
  }

 private:
  int column(int x) const {
    if (edge_ == MapEdge::Clamp) return std::clamp(x, 0, width_ - 1);
    if (x < 0) return x + width_;
    return x >= width_ ? x - width_ : x;
  }
  const Spectrum* row(int y) const {
    return texels_.data() + static_cast<std::size_t>(std::clamp(y, 0, height_ - 1)) *
                                static_cast<std::size_t>(width_);
  }

  int width_;
  int height_;
  int row_steps_ = height_;  ///< from row to row between the edges
  float first_row_ = 0.5F;   ///< in steps from the upper edge
  MapEdge edge_;
  MapFilter filter_;
  std::vector<Spectrum> texels_;
};

/// Reads `path`, which may be one of `embedded`, as linear RGB: integer formats are decoded by
/// `decoding_exponent`, without one from sRGB; of channels those are taken that are the picture
/// (`ColorChannels`). A file that cannot be read gives one magenta texel and a warning naming it.
Map load_map(const std::string& path, MapEdge edge, const SourceLocation& where, Warnings& warnings,
             MapFilter filter = MapFilter::Bilinear, const desc::EmbeddedFiles& embedded = {},
             std::optional<float> decoding_exponent = std::nullopt);

/// Maps up to this size are sampled by half texels. They fit the bilinear interpolation four times
/// better than whole ones but need four times the memory.
inline constexpr std::size_t kMaxTexelsToHalve = std::size_t{1} << 19U;

/// Distribution over the unit square proportional to luminance × `jacobian(uv)`, piecewise constant
/// on half texels (whole ones above `max_texels_to_halve`). Its density is > 0 wherever the
/// interpolated map is not black: cells are weighted by the mean of the interpolated map, not by
/// one of its texels.
template <typename Jacobian>
Distribution2D make_map_distribution(const Map& map, const Jacobian& jacobian,
                                     std::size_t max_texels_to_halve = kMaxTexelsToHalve) {
  const auto texels = static_cast<std::size_t>(map.width()) * static_cast<std::size_t>(map.bands());
  const int parts = texels <= max_texels_to_halve ? 2 : 1;
  const int columns = map.width() * parts;
  const int rows = map.bands() * parts;
  const int points = 2 / parts;  // half texels per cell and axis
  std::vector<float> weights;
  weights.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      // Within a half texel the interpolation is one bilinear patch: its mean is its value in the
      // middle.
      float sum = 0.F;
      for (int j = 0; j < points; ++j) {
        for (int i = 0; i < points; ++i) {
          const Vec2 uv(
              (static_cast<float>(x * points + i) + 0.5F) / static_cast<float>(columns * points),
              (static_cast<float>(y * points + j) + 0.5F) / static_cast<float>(rows * points));
          sum += luminance(map.lookup(uv)) * jacobian(uv);
        }
      }
      weights.push_back(sum);
    }
  }
  return Distribution2D(weights, columns, rows);
}

/// ∫ map · `jacobian(uv)` over the unit square, by midpoints of half texels or finer.
template <typename Jacobian>
Spectrum integrate_map(const Map& map, const Jacobian& jacobian) {
  constexpr int kLeastPoints = 64;
  const auto points = [](int texels) { return texels * std::max(2, 2 * (kLeastPoints / texels)); };
  const int columns = points(map.width());
  const int rows = points(map.bands());
  Vec3d sum(0.0);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const Vec2 uv((static_cast<float>(x) + 0.5F) / static_cast<float>(columns),
                    (static_cast<float>(y) + 0.5F) / static_cast<float>(rows));
      const Spectrum value = map.lookup(uv) * jacobian(uv);
      sum += Vec3d(value[0], value[1], value[2]);
    }
  }
  const Vec3 mean(sum / (static_cast<double>(columns) * rows));
  return {mean.x, mean.y, mean.z};
}

}  // namespace ajar
