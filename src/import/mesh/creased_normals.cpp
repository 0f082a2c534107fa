#include "import/mesh/creased_normals.h"

#include <algorithm>
#include <array>
#include <map>

namespace ajar {
namespace {

using Position = std::array<float, 3>;

/// Where more triangles meet, each keeps its own normal: comparing all of them would take too long.
constexpr std::size_t kMostMeeting = 4096;

Position key_of(const Vec3& p) { return {p.x, p.y, p.z}; }

}  // namespace

desc::Mesh with_creased_normals(const desc::Mesh& mesh, float cos_limit) {
  std::vector<Vec3> weighted;  // normal of each triangle, twice its area long
  std::map<Position, std::vector<std::size_t>> around;
  const auto corners = [&](std::size_t t) {
    const Imath::Vec3<unsigned>& of = mesh.indices[t];
    return std::array<unsigned, 3>{of.x, of.y, of.z};
  };
  for (std::size_t t = 0; t < mesh.indices.size(); ++t) {
    const auto [a, b, c] = corners(t);
    weighted.push_back(
        cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
    for (const unsigned corner : {a, b, c}) around[key_of(mesh.positions[corner])].push_back(t);
  }
  desc::Mesh result;
  for (std::size_t t = 0; t < mesh.indices.size(); ++t) {
    const float own_length = length(weighted[t]);
    for (const unsigned corner : corners(t)) {
      Vec3 sum(0.F);
      const std::vector<std::size_t>& meeting = around[key_of(mesh.positions[corner])];
      if (meeting.size() > kMostMeeting) sum = weighted[t];
      for (const std::size_t other : meeting) {
        if (meeting.size() > kMostMeeting) break;
        const float lengths = own_length * length(weighted[other]);
        if (dot(weighted[t], weighted[other]) >= cos_limit * lengths) sum += weighted[other];
      }
      const float size = length(sum);
      result.positions.push_back(mesh.positions[corner]);
      result.normals.push_back(size > 0.F ? sum / size : Vec3(0.F));
      if (!mesh.uvs.empty()) result.uvs.push_back(mesh.uvs[corner]);
    }
    const auto first = static_cast<unsigned>(3 * t);
    result.indices.emplace_back(first, first + 1, first + 2);
  }
  return result;
}

}  // namespace ajar
