#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vector.h"

namespace ajar {

/// The pixels of an image in the unit square of the two raster numbers, whose opposite sides are
/// joined. Boundaries lie on the grid of primary numbers (`unit_grid.h`), so that a pixel has a
/// whole number of places, at least one in each direction.
class RasterGrid {
 public:
  /// The unit square covers `size` pixels from `low` on, in an image of `pixels` pixels that begins
  /// at (0, 0); 0 ≤ low < 1 and low + size ≤ pixels. The outermost pixels may be covered in part.
  RasterGrid(const Vec2& low, const Vec2& size, const Vec2i& pixels);

  Vec2i size() const { return {columns_.count(), rows_.count()}; }
  Vec2i pixel(const Vec2& u) const { return {columns_.at(u.x), rows_.at(u.y)}; }
  std::size_t index(const Vec2i& pixel) const {
    return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(columns_.count()) +
           static_cast<std::size_t>(pixel.x);
  }
  /// The pixel `step` away, around the border if need be.
  Vec2i neighbour(const Vec2i& pixel, const Vec2i& step) const;
  /// A place in a pixel, all equally likely; `bits` are random.
  Vec2 place(const Vec2i& pixel, std::uint64_t bits_x, std::uint64_t bits_y) const {
    return {columns_.place(pixel.x, bits_x), rows_.place(pixel.y, bits_y)};
  }
  /// Share of the unit square that a pixel covers.
  double area(const Vec2i& pixel) const { return columns_.length(pixel.x) * rows_.length(pixel.y); }

 private:
  /// The pixels of one direction.
  class Axis {
   public:
    Axis(float low, float size, int pixels);
    int count() const { return static_cast<int>(first_.size()) - 1; }
    int at(float u) const;
    float place(int pixel, std::uint64_t bits) const;
    double length(int pixel) const;

   private:
    float low_;
    float size_;
    std::vector<std::int64_t> first_;  ///< place of each pixel on the grid, and the end
  };

  Axis columns_;
  Axis rows_;
};

}  // namespace ajar
