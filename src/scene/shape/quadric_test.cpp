#include "scene/shape/quadric.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "core/random.h"
#include "core/warp.h"
#include "scene/shape/quadric_math.h"
#include "scene/testing/quadrics.h"

namespace ajar {
namespace {

struct QuadricCase {
  std::string name;
  Quadric quadric;
  /// Zero on the untrimmed surface.
  std::function<double(const Vec3d&)> implicit;
  /// True if a point of that surface belongs to the shape.
  std::function<bool(const Vec3d&)> inside;
};

double angle(const Vec3d& p) {
  const double phi = std::atan2(p.y, p.x) * 180.0 / double{kPi};
  return phi < 0.0 ? phi + 360.0 : phi;
}

std::vector<QuadricCase> quadric_cases() {
  std::vector<QuadricCase> all;
  const auto sphere = [](const Vec3d& p) { return p.dot(p) - 4.0; };
  all.push_back({"sphere", *testing::quadric_of(testing::sphere_node(2, -2, 2, 360)), sphere,
                 [](const Vec3d&) { return true; }});
  all.push_back({"partial sphere", *testing::quadric_of(testing::sphere_node(2, -1, 1.5F, 220)),
                 sphere, [](const Vec3d& p) { return p.z > -1 && p.z < 1.5 && angle(p) < 220; }});
  for (const std::string coordinates :
       {"angle_then_radius_inward", "radius_then_angle", "angle_then_radius"}) {
    all.push_back({"disk, " + coordinates, *testing::quadric_of(testing::disk_node_of(coordinates)),
                   [](const Vec3d& p) { return p.z - 0.5; },
                   [](const Vec3d& p) {
                     const double r = std::hypot(p.x, p.y);
                     return r < 2 && r > 0.7F && angle(p) < 250;
                   }});
  }
  all.push_back({"cylinder", *testing::quadric_of(testing::cylinder_node(1.5F, -1, 2, 300)),
                 [](const Vec3d& p) { return p.x * p.x + p.y * p.y - 2.25; },
                 [](const Vec3d& p) { return p.z > -1 && p.z < 2 && angle(p) < 300; }});
  all.push_back({"cone", *testing::quadric_of(testing::cone_node(1.5F, 2, 270)),
                 [](const Vec3d& p) {
                   const double r = 1.5 * (1 - p.z / 2);
                   return p.x * p.x + p.y * p.y - r * r;
                 },
                 [](const Vec3d& p) { return p.z > 0 && p.z < 2 && angle(p) < 270; }});
  all.push_back({"paraboloid", *testing::quadric_of(testing::paraboloid_node(1.5F, 0.25F, 2, 270)),
                 [](const Vec3d& p) { return (p.x * p.x + p.y * p.y) * 2 / 2.25 - p.z; },
                 [](const Vec3d& p) { return p.z > 0.25 && p.z < 2 && angle(p) < 270; }});
  all.push_back({"hyperboloid",
                 *testing::quadric_of(testing::hyperboloid_node({1, -1, -1}, {0.5F, 1.5F, 1}, 360)),
                 [](const Vec3d& p) {
                   const double v = (p.z + 1) / 2;
                   const double x = 1 - 0.5 * v;
                   const double y = -1 + 2.5 * v;
                   return p.x * p.x + p.y * p.y - x * x - y * y;
                 },
                 [](const Vec3d& p) { return p.z > -1 && p.z < 1; }});
  return all;
}

/// Roots by marching along the ray and bisecting sign changes.
std::vector<double> march(const QuadricCase& c, const Vec3d& o, const Vec3d& d, double from,
                          double to) {
  constexpr int kSteps = 4000;
  std::vector<double> roots;
  double a = from;
  double fa = c.implicit(o + d * a);
  for (int i = 1; i <= kSteps; ++i) {
    const double b = from + (to - from) * i / kSteps;
    const double fb = c.implicit(o + d * b);
    if ((fa < 0) != (fb < 0)) {
      double low = a;
      double high = b;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        ((c.implicit(o + d * middle) < 0) == (fa < 0) ? low : high) = middle;
      }
      if (c.inside(o + d * low)) roots.push_back(low);
    }
    a = b;
    fa = fb;
  }
  return roots;
}

TEST(Quadric, RootsAgreeWithMarching) {
  Rng rng(1);
  for (const QuadricCase& c : quadric_cases()) {
    int with_roots = 0;
    for (int i = 0; i < 300; ++i) {
      const Vec3d o(8.0 * rng.next() - 4.0, 8.0 * rng.next() - 4.0, 8.0 * rng.next() - 4.0);
      const Vec3d target(3.0 * rng.next() - 1.5, 3.0 * rng.next() - 1.5, 3.0 * rng.next() - 1.0);
      const Vec3d d = (target - o) * 0.5;
      const Quadric::Roots roots = c.quadric.intersect(o, d);
      const std::vector<double> expected = march(c, o, d, -20.0, 20.0);
      std::vector<double> near;
      for (int k = 0; k < roots.count; ++k) {
        if (std::abs(roots.t[k]) < 20.0) near.push_back(roots.t[k]);
      }
      // Grazing pairs closer than a marching step are invisible to the oracle.
      if (near.size() == 2 && near[1] - near[0] < 0.02) continue;
      ASSERT_EQ(near.size(), expected.size()) << c.name << " ray " << i;
      for (std::size_t k = 0; k < near.size(); ++k)
        ASSERT_NEAR(near[k], expected[k], 1e-9) << c.name;
      with_roots += near.empty() ? 0 : 1;
    }
    EXPECT_GT(with_roots, 40) << c.name;
  }
}

TEST(Quadric, StaysExactFromFarAway) {
  const Quadric sphere = *testing::quadric_of(testing::sphere_node());
  const Vec3d direction = Vec3d(1.0, 0.7, -0.4).normalized();
  const Vec3d o = direction * -1e7 + Vec3d(0.0, 0.3, 0.2);
  const Quadric::Roots roots = sphere.intersect(o, direction);
  ASSERT_EQ(roots.count, 2);
  EXPECT_NEAR((o + direction * roots.t[0]).length(), 1.0, 1e-8);
}

TEST(Quadric, ParametersInvertPosition) {
  Rng rng(2);
  for (const QuadricCase& c : quadric_cases()) {
    for (int i = 0; i < 200; ++i) {
      const Imath::V2d uv(0.001 + 0.998 * rng.next(), 0.001 + 0.998 * rng.next());
      const Quadric::Point at = c.quadric.at(uv);
      EXPECT_NEAR(c.implicit(at.p), 0.0, 1e-6) << c.name;
      const Imath::V2d found = c.quadric.parameters(at.p);
      EXPECT_NEAR(found.x, uv.x, 1e-9) << c.name;
      EXPECT_NEAR(found.y, uv.y, 1e-9) << c.name;
    }
  }
}

TEST(Quadric, DisksHaveTheCoordinatesThatTheyName) {
  // A quarter of the way from the hole (0.7) to the rim (2), a fifth of 250 degrees around.
  const double phi = 50.0 * double{kPi} / 180.0;
  const double r = 0.7F + (2.0 - 0.7F) * 0.25;
  const Vec3d p(r * std::cos(phi), r * std::sin(phi), 0.5);
  const auto expect = [&](const std::string& coordinates, double u, double v) {
    const Quadric disk = *testing::quadric_of(testing::disk_node_of(coordinates));
    EXPECT_NEAR((disk.parameters(p) - Imath::V2d(u, v)).length(), 0.0, 1e-7) << coordinates;
    EXPECT_NEAR((disk.at({u, v}).p - p).length(), 0.0, 1e-7) << coordinates;
    EXPECT_EQ(disk.at({u, v}).n.z, 1.0) << coordinates;
  };
  expect("angle_then_radius_inward", 0.2, 0.75);
  expect("radius_then_angle", 0.25, 0.2);
  expect("angle_then_radius", 0.2, 0.25);
}

TEST(Quadric, DerivativesMatchDifferences) {
  Rng rng(3);
  constexpr double kStep = 1e-5;
  for (const QuadricCase& c : quadric_cases()) {
    for (int i = 0; i < 100; ++i) {
      const Imath::V2d uv(0.05 + 0.9 * rng.next(), 0.05 + 0.9 * rng.next());
      const Quadric::Point at = c.quadric.at(uv);
      const Quadric::Point u1 = c.quadric.at(uv + Imath::V2d(kStep, 0.0));
      const Quadric::Point u0 = c.quadric.at(uv - Imath::V2d(kStep, 0.0));
      const Quadric::Point v1 = c.quadric.at(uv + Imath::V2d(0.0, kStep));
      const Quadric::Point v0 = c.quadric.at(uv - Imath::V2d(0.0, kStep));
      const double scale = 1.0 / (2.0 * kStep);
      EXPECT_NEAR(((u1.p - u0.p) * scale - at.dpdu).length(), 0.0, 1e-5) << c.name;
      EXPECT_NEAR(((v1.p - v0.p) * scale - at.dpdv).length(), 0.0, 1e-5) << c.name;
      EXPECT_NEAR(((u1.n - u0.n) * scale - at.dndu).length(), 0.0, 1e-4) << c.name;
      EXPECT_NEAR(((v1.n - v0.n) * scale - at.dndv).length(), 0.0, 1e-4) << c.name;
      const double side = at.n.dot(at.dpdu.cross(at.dpdv).normalized());
      EXPECT_NEAR(side, c.name == "disk, angle_then_radius" ? -1.0 : 1.0, 1e-9) << c.name;
    }
  }
}

TEST(Quadric, PolesHaveNormalsAndTangents) {
  const std::vector<Quadric> quadrics = {
      *testing::quadric_of(testing::sphere_node()), *testing::quadric_of(testing::disk_node()),
      *testing::quadric_of(testing::cone_node()), *testing::quadric_of(testing::paraboloid_node())};
  for (const Quadric& q : quadrics) {
    for (const double v : {0.0, 1.0}) {
      const Quadric::Point at = q.at({0.3, v});
      EXPECT_NEAR(at.n.length(), 1.0, 1e-6);
      EXPECT_GT(at.dpdu.length(), 0.0);
      EXPECT_GT(at.dpdv.length(), 0.0);
      EXPECT_TRUE(std::isfinite(at.dndu.length()) && std::isfinite(at.dndv.length()));
    }
  }
}

TEST(Quadric, AreaMatchesQuadrature) {
  for (const QuadricCase& c : quadric_cases()) {
    constexpr int kSteps = 2000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      // Along the diagonal, which crosses the profile whichever coordinate that is.
      const double x = (i + 0.5) / kSteps;
      const Quadric::Point at = c.quadric.at({x, x});
      sum += at.dpdu.cross(at.dpdv).length() / kSteps;
    }
    EXPECT_NEAR(sum, c.quadric.area(), 1e-5 * sum) << c.name;
  }
}

TEST(Quadric, ShapesWithoutAreaAreRefused) {
  EXPECT_FALSE(testing::quadric_of(testing::sphere_node(0, -1, 1, 360)));
  EXPECT_FALSE(testing::quadric_of(testing::sphere_node(1, 0.5F, 0.5F, 360)));
  EXPECT_FALSE(testing::quadric_of(testing::disk_node(0, 1, 1, 360)));
  EXPECT_FALSE(testing::quadric_of(testing::cylinder_node(1, 0, 0, 360)));
  EXPECT_FALSE(testing::quadric_of(testing::cone_node(1, 0, 360)));
  EXPECT_FALSE(testing::quadric_of(testing::paraboloid_node(1, 0, 1, 0)));
  EXPECT_FALSE(testing::quadric_of(testing::hyperboloid_node({0, 0, 0}, {0, 0, 1}, 360)));
}

TEST(QuadricSurfacePoint, NormalDerivativesHoldUnderShear) {
  Mat4 m;
  m[0][0] = 2.0;
  m[1][0] = 0.7;
  m[2][2] = -0.5;
  m[3][1] = 4.0;
  const Placement placement = *Placement::make(m);
  const Quadric sphere = *testing::quadric_of(testing::sphere_node());
  constexpr double kStep = 1e-3;
  for (const bool reversed : {false, true}) {
    const auto at = [&](double u, double v) {
      return quadric_surface_point(sphere, placement, reversed, {u, v});
    };
    const SurfacePoint p = at(0.2, 0.6);
    const float scale = 1.F / (2.F * static_cast<float>(kStep));
    const Vec3 du = (at(0.2 + kStep, 0.6).ns - at(0.2 - kStep, 0.6).ns) * scale;
    const Vec3 dv = (at(0.2, 0.6 + kStep).ns - at(0.2, 0.6 - kStep).ns) * scale;
    EXPECT_LT(length(du - p.dndu), 2e-3F * length(du) + 1e-3F);
    EXPECT_LT(length(dv - p.dndv), 2e-3F * length(dv) + 1e-3F);
    EXPECT_NEAR(abs_dot(normalize(cross(p.dpdu, p.dpdv)), p.ng), 1.F, 1e-5F);
    // Outward of the ellipsoid unless reversed, although the transform mirrors.
    EXPECT_EQ(dot(p.ng, p.p - Vec3(0.F, 4.F, 0.F)) < 0.F, reversed);
  }
}

TEST(Placement, InvertsTinyAndMirroredTransforms) {
  Mat4 m;
  for (int i = 0; i < 3; ++i) m[i][i] = 1e-6;
  m[0][0] = -1e-6;
  m[3][0] = 5.0;
  const auto placement = Placement::make(m);
  ASSERT_TRUE(placement);
  const Vec3d p(0.1, -2.0, 3.0);
  EXPECT_NEAR((placement->point_to_object(placement->point(p)) - p).length(), 0.0, 1e-8);
  EXPECT_TRUE(placement->mirrors());
  EXPECT_NEAR(*placement->similarity_scale(), 1e-6, 1e-15);
  m[2][2] = 0.0;
  EXPECT_FALSE(Placement::make(m));
}

TEST(SolveQuadratic, KeepsSmallRoots) {
  double t[2];
  ASSERT_EQ(solve_quadratic(1.0, -1e8, 1.0, t), 2);
  EXPECT_NEAR(t[0], 5e-9, 1e-15);
  ASSERT_EQ(solve_quadratic(0.0, -1.0, 4.0, t), 1);
  EXPECT_NEAR(t[0], 2.0, 1e-12);
  EXPECT_EQ(solve_quadratic(1.0, 0.0, 1.0, t), 0);
}

}  // namespace
}  // namespace ajar
