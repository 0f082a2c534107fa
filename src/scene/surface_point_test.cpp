#include "scene/surface_point.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "core/warp.h"

namespace ajar {
namespace {

/// Signed distance of a float point from the plane through `on` with normal `n`, in double
/// precision.
double height(const Vec3& p, const Vec3d& on, const Vec3d& n) { return (Vec3d(p) - on).dot(n); }

/// The exact plane passes within rounding of p; worst case over random planes through a true point.
void expect_offset_clears_plane(double scale) {
  Rng rng(7);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 n = warp::uniform_sphere({rng.next(), rng.next()});
    const Vec3d exact(scale * (2.0 * rng.next() - 1.0), scale * 1e-3 * rng.next(),
                      scale * rng.next());
    const Vec3 p(exact);
    const Vec3 above = offset_ray_origin(p, n, n);
    const Vec3 below = offset_ray_origin(p, n, -n);
    ASSERT_GT(height(above, exact, Vec3d(n)), 0.0);
    ASSERT_LT(height(below, exact, Vec3d(n)), 0.0);
    // Small: less than a millionth of the coordinates.
    ASSERT_LT(height(above, exact, Vec3d(n)), 1e-6 * scale);
  }
}

TEST(OffsetRayOrigin, ClearsThePlaneNearTheOrigin) { expect_offset_clears_plane(1e-12); }
TEST(OffsetRayOrigin, ClearsThePlaneAtUnitScale) { expect_offset_clears_plane(1.0); }
TEST(OffsetRayOrigin, ClearsThePlaneAtAHundredThousand) { expect_offset_clears_plane(1e5); }

TEST(OffsetRayOrigin, GoesToTheSideOfTheDirection) {
  const Vec3 p(1.F, 2.F, 3.F);
  const Vec3 n(0.F, 0.F, 1.F);
  EXPECT_GT(offset_ray_origin(p, n, Vec3(0.9F, 0.F, 0.1F)).z, 3.F);
  EXPECT_LT(offset_ray_origin(p, n, Vec3(0.9F, 0.F, -0.1F)).z, 3.F);
}

TEST(OffsetRayOrigin, LeavesCoordinatesAlongThePlaneAlone) {
  const Vec3 moved = offset_ray_origin({1e5F, 0.F, -3e4F}, {0.F, 1.F, 0.F}, {0.F, 1.F, 0.F});
  EXPECT_EQ(moved.x, 1e5F);
  EXPECT_EQ(moved.z, -3e4F);
  EXPECT_LT(moved.y, 1e-5F);
}

TEST(OffsetRayOrigin, HasNoLengthOfItsOwn) {
  const Vec3 p(1.F, -2.F, 3.F);
  const Vec3 n = normalize(Vec3(0.3F, 0.1F, -0.7F));
  for (const float size : {0x1p-40F, 0x1p-3F, 0x1p30F}) {
    EXPECT_EQ(offset_ray_origin(p * size, n, n), offset_ray_origin(p, n, n) * size);
    EXPECT_EQ(offset_ray_end(p * size, n, n, 5.F * size), offset_ray_end(p, n, n, 5.F) * size);
  }
}

}  // namespace
}  // namespace ajar
