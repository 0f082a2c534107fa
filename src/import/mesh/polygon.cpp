#include "import/mesh/polygon.h"

#include <cmath>
#include <numeric>

namespace ajar {
namespace {

/// A bound on work, which may grow with the cube.
constexpr std::size_t kMostCorners = 500;

using Point = Imath::V2d;

/// Twice the area of a triangle, positive if it is counterclockwise.
double doubled_area(const Point& a, const Point& b, const Point& c) { return (b - a).cross(c - a); }

/// Newell's: its length is twice the area.
Vec3d mean_normal(std::span<const Vec3> corners) {
  Vec3d normal(0.0);
  const Vec3d origin(corners.front());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d a = Vec3d(corners[i]) - origin;
    normal += a.cross(Vec3d(corners[(i + 1) % corners.size()]) - origin);
  }
  return normal;
}

/// Projection seen against the normal, so that they are counterclockwise; distances along its
/// largest axis are left out, which preserves containment.
std::vector<Point> projected(std::span<const Vec3> corners, const Vec3d& normal) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
  }
  int first = (axis + 1) % 3;
  int second = (axis + 2) % 3;
  if (normal[axis] < 0.0) std::swap(first, second);
  std::vector<Point> points;
  for (const Vec3& corner : corners) {
    points.emplace_back(static_cast<double>(corner[first]), static_cast<double>(corner[second]));
  }
  return points;
}

/// Orientation seen along the normal. Takes no memory: most polygons are.
bool is_convex(std::span<const Vec3> corners, const Vec3d& normal) {
  const std::size_t n = corners.size();
  Vec3d here(corners[n - 1]);
  Vec3d arriving = here - Vec3d(corners[n - 2]);
  for (const Vec3& corner : corners) {
    const Vec3d leaving = Vec3d(corner) - here;
    if (arriving.cross(leaving).dot(normal) < 0.0) return false;
    here = Vec3d(corner);
    arriving = leaving;
  }
  return true;
}

class EarCutter {
 public:
  EarCutter(const std::vector<Point>& points, std::vector<std::array<std::uint32_t, 3>>& triangles)
      : points_(points), left_(points.size()), triangles_(triangles) {
    std::iota(left_.begin(), left_.end(), 0U);
  }

  void cut() {
    std::size_t at = 0;
    std::size_t tried = 0;
    while (left_.size() > 3 && tried < left_.size()) {
      const std::size_t n = left_.size();
      at %= n;
      const std::uint32_t before = left_[(at + n - 1) % n];
      const std::uint32_t here = left_[at];
      const std::uint32_t after = left_[(at + 1) % n];
      const double area = doubled_area(points_[before], points_[here], points_[after]);
      if (area < 0.0 || (area > 0.0 && !is_free(before, here, after))) {
        ++at;
        ++tried;
        continue;
      }
      // Degenerate triangles are left out.
      if (area > 0.0) triangles_.push_back({before, here, after});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
      tried = 0;
    }
    for (std::size_t i = 2; i < left_.size(); ++i) {
      triangles_.push_back({left_[0], left_[i - 1], left_[i]});
    }
  }

 private:
  /// True if no other corner is in this triangle. Corners in the place of one of its own are those
  /// of a cut that leads to a hole.
  bool is_free(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Point& pa = points_[a];
    const Point& pb = points_[b];
    const Point& pc = points_[c];
    for (const std::uint32_t i : left_) {
      const Point& p = points_[i];
      if (p == pa || p == pb || p == pc) continue;
      if (doubled_area(pa, pb, p) >= 0.0 && doubled_area(pb, pc, p) >= 0.0 &&
          doubled_area(pc, pa, p) >= 0.0) {
        return false;
      }
    }
    return true;
  }

  const std::vector<Point>& points_;
  std::vector<std::uint32_t> left_;
  std::vector<std::array<std::uint32_t, 3>>& triangles_;
};

}  // namespace

void triangulate(std::span<const Vec3> corners,
                 std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (corners.size() > 3 && corners.size() <= kMostCorners) {
    const Vec3d normal = mean_normal(corners);
    if (!is_convex(corners, normal)) {
      const std::vector<Point> points = projected(corners, normal);
      return EarCutter(points, triangles).cut();
    }
  }
  for (std::uint32_t i = 2; i < corners.size(); ++i) triangles.push_back({0, i - 1, i});
}

}  // namespace ajar
