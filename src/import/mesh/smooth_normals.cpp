#include "import/mesh/smooth_normals.h"

#include <cmath>

namespace ajar {
namespace {

/// Between two vectors of any length.
double angle_between(const Vec3d& a, const Vec3d& b) {
  return std::atan2(a.cross(b).length(), a.dot(b));
}

}  // namespace

void make_smooth_normals(desc::Mesh& mesh) {
  std::vector<Vec3d> sums(mesh.positions.size(), Vec3d(0.0));
  for (const Imath::Vec3<unsigned>& t : mesh.indices) {
    const Vec3d p[3] = {Vec3d(mesh.positions[t.x]), Vec3d(mesh.positions[t.y]),
                        Vec3d(mesh.positions[t.z])};
    const Vec3d normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    for (int i = 0; i < 3; ++i) {
      const Vec3d& here = p[i];
      sums[t[i]] += normal * angle_between(p[(i + 1) % 3] - here, p[(i + 2) % 3] - here);
    }
  }
  mesh.normals.resize(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double length = sums[i].length();
    mesh.normals[i] = length > 0.0 ? Vec3(sums[i] / length) : Vec3(0.F, 0.F, 1.F);
  }
}

}  // namespace ajar
