#include "import/pbrt/bilinear_mesh.h"

#include <array>
#include <cmath>

namespace ajar::pbrt {
namespace {

/// Triangles along each side of a patch that is not flat.
constexpr unsigned kSteps = 8;
/// More patches than this are certainly a mistake in the file.
constexpr std::size_t kMostPatches = 10000000;

/// Corners (u, v) = (0, 0), (1, 0), (0, 1), (1, 1).
using Patch = std::array<unsigned, 4>;

template <typename Vector>
Vector bilinear(const std::vector<Vector>& corners, const Patch& patch, float u, float v) {
  return (corners[patch[0]] * (1.F - u) + corners[patch[1]] * u) * (1.F - v) +
         (corners[patch[2]] * (1.F - u) + corners[patch[3]] * u) * v;
}

/// True if the corners, where there are any, are those of a parallelogram: two triangles show it as
/// it is.
template <typename Vector>
bool is_parallelogram(const std::vector<Vector>& p, const Patch& patch) {
  if (p.empty()) return true;
  const Vector twist = p[patch[0]] - p[patch[1]] - p[patch[2]] + p[patch[3]];
  const float size = (p[patch[3]] - p[patch[0]]).length() + (p[patch[2]] - p[patch[1]]).length();
  return twist.length() <= 1e-4F * size;
}

std::vector<Patch> patches_of(const SourceLocation& where, const ParameterList& p,
                              std::size_t vertices) {
  const Parameter* indices = p.find("indices", ParameterKind::Integer);
  if (indices == nullptr) {
    if (vertices == 4) return {{0, 1, 2, 3}};
    throw SceneError(where, "a bilinearmesh needs \"integer indices\", or four points");
  }
  const std::vector<int>& n = indices->integers;
  if (n.empty() || n.size() % 4 != 0) {
    throw SceneError(indices->where, "a bilinearmesh needs four indices for each patch");
  }
  if (n.size() / 4 > kMostPatches) throw SceneError(indices->where, "there are too many patches");
  std::vector<Patch> patches(n.size() / 4);
  for (std::size_t i = 0; i < n.size(); ++i) {
    if (n[i] < 0 || static_cast<std::size_t>(n[i]) >= vertices) {
      throw SceneError(indices->where, "the index " + std::to_string(n[i]) + " is not one of " +
                                           std::to_string(vertices) + " points");
    }
    patches[i / 4][i % 4] = static_cast<unsigned>(n[i]);
  }
  return patches;
}

/// `steps` by `steps` squares of two triangles.
void add_patch(const desc::Mesh& corners, const Patch& patch, unsigned steps, desc::Mesh& mesh) {
  const auto first = static_cast<unsigned>(mesh.positions.size());
  for (unsigned y = 0; y <= steps; ++y) {
    for (unsigned x = 0; x <= steps; ++x) {
      const float u = static_cast<float>(x) / static_cast<float>(steps);
      const float v = static_cast<float>(y) / static_cast<float>(steps);
      mesh.positions.push_back(bilinear(corners.positions, patch, u, v));
      if (!corners.normals.empty()) {
        mesh.normals.push_back(bilinear(corners.normals, patch, u, v));
      }
      mesh.uvs.push_back(corners.uvs.empty() ? Vec2(u, v) : bilinear(corners.uvs, patch, u, v));
    }
  }
  const unsigned row = steps + 1;
  for (unsigned y = 0; y < steps; ++y) {
    for (unsigned x = 0; x < steps; ++x) {
      const unsigned corner = first + y * row + x;
      mesh.indices.emplace_back(corner, corner + 1, corner + row + 1);
      mesh.indices.emplace_back(corner, corner + row + 1, corner + row);
    }
  }
}

}  // namespace

BilinearMesh read_bilinear_mesh(const SourceLocation& where, const ParameterList& p) {
  desc::Mesh corners;
  corners.positions = p.get_points("P");
  corners.normals = p.get_normals("N");
  corners.uvs = p.get_point2s("uv");
  p.accept({"emissionfilename", "faceIndices"});
  const std::size_t vertices = corners.positions.size();
  if (vertices == 0) throw SceneError(where, "a bilinearmesh needs \"point3 P\"");
  if ((!corners.normals.empty() && corners.normals.size() != vertices) ||
      (!corners.uvs.empty() && corners.uvs.size() != vertices)) {
    throw SceneError(where, "a bilinearmesh has as many \"N\" and \"uv\" as \"P\", or none");
  }
  const std::vector<Patch> patches = patches_of(where, p, vertices);
  bool flat = true;
  for (const Patch& patch : patches) {
    flat = flat && is_parallelogram(corners.positions, patch) &&
           is_parallelogram(corners.normals, patch) && is_parallelogram(corners.uvs, patch);
  }
  const unsigned steps = flat ? 1 : kSteps;
  BilinearMesh result;
  result.triangles_per_patch = std::size_t{2} * steps * steps;
  for (const Patch& patch : patches) add_patch(corners, patch, steps, result.mesh);
  return result;
}

}  // namespace ajar::pbrt
