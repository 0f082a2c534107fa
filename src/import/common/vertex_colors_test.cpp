#include "import/common/vertex_colors.h"

#include <gtest/gtest.h>

#include "scene/texture/image_cache.h"

namespace ajar {
namespace {

/// Result of a bilinear lookup of a float image; v from the bottom row.
Vec3 looked_up(const TexelImage& image, const Vec2& uv) {
  const auto& texels = std::get<std::vector<float>>(image.texels);
  const auto at = [&](int x, int y) {
    const std::size_t i = 3 * static_cast<std::size_t>((image.height - 1 - y) * image.width + x);
    return Vec3(texels[i], texels[i + 1], texels[i + 2]);
  };
  const float x = uv.x * static_cast<float>(image.width) - 0.5F;
  const float y = uv.y * static_cast<float>(image.height) - 0.5F;
  const int x0 = std::clamp(static_cast<int>(std::floor(x + 1e-3F)), 0, image.width - 2);
  const int y0 = std::clamp(static_cast<int>(std::floor(y + 1e-3F)), 0, image.height - 2);
  const float dx = x - static_cast<float>(x0);
  const float dy = y - static_cast<float>(y0);
  return (at(x0, y0) * (1.F - dx) + at(x0 + 1, y0) * dx) * (1.F - dy) +
         (at(x0, y0 + 1) * (1.F - dx) + at(x0 + 1, y0 + 1) * dx) * dy;
}

TEST(VertexColors, AreInterpolatedLinearlyOverEachTriangle) {
  desc::Mesh mesh;
  std::vector<Vec3> colors;
  constexpr unsigned kVertices = 9;
  for (unsigned i = 0; i < kVertices; ++i) {
    const auto t = static_cast<float>(i);
    mesh.positions.emplace_back(t, t * t, 1.F);
    mesh.normals.emplace_back(0.F, 0.F, 1.F);
    colors.emplace_back(std::sin(t) * 0.5F + 0.5F, t / 9.F, 1.F - t / 9.F);
  }
  // More than two rows of squares, the last not full.
  for (unsigned i = 0; i + 2 < kVertices; ++i) mesh.indices.emplace_back(i, i + 2, i + 1);
  const PaintedMesh result = painted(mesh, colors);
  const desc::EmbeddedFiles files = {{"a.exr", std::make_shared<const std::string>(result.image)}};
  const TexelImage image = read_texel_image({.path = "a.exr"}, files);
  ASSERT_EQ(result.mesh.indices.size(), mesh.indices.size());
  EXPECT_EQ(result.mesh.normals.size(), result.mesh.positions.size());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const auto& was = mesh.indices[i];
    const auto& is = result.mesh.indices[i];
    for (const Vec3& b : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.2F, 0.3F, 0.5F),
                          Vec3(0.F, 0.5F, 0.5F), Vec3(0.7F, 0.2F, 0.1F)}) {
      const auto mixed = [&](const auto& of, const auto& corners) {
        return of[corners.x] * b.x + of[corners.y] * b.y + of[corners.z] * b.z;
      };
      const Vec3 error = looked_up(image, mixed(result.mesh.uvs, is)) - mixed(colors, was);
      EXPECT_LT(error.length(), 1e-5F) << i;
      EXPECT_EQ(mixed(result.mesh.positions, is), mixed(mesh.positions, was));
    }
  }
}

}  // namespace
}  // namespace ajar
