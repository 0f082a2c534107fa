#include "import/common/vertex_colors.h"

#include <algorithm>
#include <cmath>

#include "imageio/image_encoder.h"

namespace ajar {
namespace {

/// Where a triangle has its four texels: a square of 2 × 2, from the lower left.
class Squares {
 public:
  explicit Squares(std::size_t count)
      : columns_(std::max<std::size_t>(
            1, static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count)))))),
        rows_(std::max<std::size_t>(1, (count + columns_ - 1) / columns_)) {}

  std::size_t width() const { return 2 * columns_; }
  std::size_t height() const { return 2 * rows_; }
  std::size_t column(std::size_t square) const { return 2 * (square % columns_); }
  std::size_t row(std::size_t square) const { return 2 * (square / columns_); }

  /// Coordinates of the middle of a texel.
  Vec2 uv(std::size_t column, std::size_t row) const {
    return Vec2(
        static_cast<float>((static_cast<double>(column) + 0.5) / static_cast<double>(width())),
        static_cast<float>((static_cast<double>(row) + 0.5) / static_cast<double>(height())));
  }

 private:
  std::size_t columns_, rows_;
};

std::string encoded(const Squares& squares, const std::vector<Vec3>& texels) {
  const auto width = static_cast<int>(squares.width());
  const auto height = static_cast<int>(squares.height());
  const ImageLayout layout{.width = width,
                           .height = height,
                           .names = {"R", "G", "B"},
                           .resolution = {width, height},
                           .texts = {}};
  const std::vector<unsigned char> bytes = encode_exr(layout, [&](int y, float* row) {
    const std::size_t first = static_cast<std::size_t>(height - 1 - y) * squares.width();
    for (std::size_t x = 0; x < squares.width(); ++x) {
      for (int lane = 0; lane < 3; ++lane) *row++ = texels[first + x][lane];
    }
  });
  return {bytes.begin(), bytes.end()};
}

}  // namespace

PaintedMesh painted(const desc::Mesh& mesh, std::span<const Vec3> colors) {
  const Squares squares(mesh.indices.size());
  std::vector<Vec3> texels(squares.width() * squares.height(), Vec3(0.F));
  PaintedMesh result;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const auto& corners = mesh.indices[i];
    const std::size_t x = squares.column(i);
    const std::size_t y = squares.row(i);
    const auto texel = [&](std::size_t dx, std::size_t dy) -> Vec3& {
      return texels[(y + dy) * squares.width() + x + dx];
    };
    const Vec3 c[] = {colors[corners.x], colors[corners.y], colors[corners.z]};
    texel(0, 0) = c[0];
    texel(1, 0) = c[1];
    texel(0, 1) = c[2];
    // Fourth corner that makes the bilinear interpolation of the square linear. It may be below 0,
    // but has the least weight within the triangle.
    texel(1, 1) = c[1] + c[2] - c[0];
    const auto first = static_cast<unsigned>(result.mesh.positions.size());
    for (const unsigned vertex : {corners.x, corners.y, corners.z}) {
      result.mesh.positions.push_back(mesh.positions[vertex]);
      if (!mesh.normals.empty()) result.mesh.normals.push_back(mesh.normals[vertex]);
      if (!mesh.tangents.empty()) result.mesh.tangents.push_back(mesh.tangents[vertex]);
      if (!mesh.handedness.empty()) result.mesh.handedness.push_back(mesh.handedness[vertex]);
    }
    for (const Vec2& at : {squares.uv(x, y), squares.uv(x + 1, y), squares.uv(x, y + 1)}) {
      result.mesh.uvs.push_back(at);
    }
    result.mesh.indices.emplace_back(first, first + 1, first + 2);
  }
  result.image = encoded(squares, texels);
  return result;
}

}  // namespace ajar
