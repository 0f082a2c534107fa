#include "path/offset_normal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/bsdf/rough_dielectric.h"

/// Offset normals against the laws of reflection and refraction, and against differences.
namespace ajar {
namespace {

/// On a surface that is seen from its front along +z; its shading normal is another.
InnerVertex frosted(bool transmission) {
  InnerVertex vertex;
  vertex.hit.point.ng = Vec3(0.F, 0.F, 1.F);
  vertex.hit.point.ns = normalize(Vec3(0.2F, -0.1F, 1.F));
  vertex.bsdf = Bsdf(Frame::around(vertex.hit.point.ns), vertex.hit.point.ng);
  RoughDielectric lobe{Microfacets(FacetModel::Ggx, 0.3F, 0.3F), PackedSpectrum(Spectrum(1.F)),
                       PackedSpectrum(Spectrum(1.F)), 1.5F};
  vertex.bsdf.add(lobe);
  vertex.event.transmission = transmission;
  return vertex;
}

const Vec3d kAbove = Vec3d(0.3, -0.5, 1.0).normalized();
const Vec3d kBelow = Vec3d(0.2, 0.4, -1.0).normalized();
constexpr OffsetNormal kOffset{0.15, -0.25};

TEST(OffsetNormal, TurnsLightByItsFacetAndBack) {
  for (const bool transmission : {false, true}) {
    const InnerVertex vertex = frosted(transmission);
    for (const Vec3d& a : {kAbove, kBelow}) {
      const auto b = turn(vertex, transmission, kOffset, a);
      ASSERT_TRUE(b);
      EXPECT_NEAR(b->length(), 1.0, 1e-12);
      EXPECT_EQ(a.z * b->z < 0.0, transmission);
      const Vec3d m = *facet_normal(vertex, kOffset);
      const double eta = transmission ? (a.z > 0.0 ? 1.5 : 1.0 / 1.5) : 1.0;
      EXPECT_LT((m.cross(a) + m.cross(*b) * eta).length(), 1e-12) << "the law of Snell";
      const auto again = offset_normal(vertex, a, *b);
      ASSERT_TRUE(again);
      EXPECT_NEAR(again->x, kOffset.x, 1e-12);
      EXPECT_NEAR(again->y, kOffset.y, 1e-12);
      const auto back = turn(vertex, transmission, kOffset, *b);
      ASSERT_TRUE(back);
      EXPECT_LT((*back - a).length(), 1e-12);
    }
  }
}

TEST(OffsetNormal, ChangesWithDirectionsAsDifferencesDo) {
  for (const bool transmission : {false, true}) {
    const InnerVertex vertex = frosted(transmission);
    for (const Vec3d& a : {kAbove, kBelow}) {
      const Vec3d b = *turn(vertex, transmission, kOffset, a);
      const TangentPlane plane = plane_across(b);
      constexpr double kStep = 1e-5;
      const auto difference = [&](const Vec3d& way) {
        const auto to = offset_normal(vertex, a, (b + way * kStep).normalized());
        const auto from = offset_normal(vertex, a, (b - way * kStep).normalized());
        return OffsetNormal{(to->x - from->x) / (2.0 * kStep), (to->y - from->y) / (2.0 * kStep)};
      };
      const OffsetNormal dx = difference(plane.x);
      const OffsetNormal dy = difference(plane.y);
      const double area = std::abs(dx.x * dy.y - dx.y * dy.x);
      EXPECT_NEAR(offset_change(vertex, a, b) / area, 1.0, 1e-6);
    }
  }
}

TEST(OffsetNormal, IsEmptyWithoutAFacet) {
  const InnerVertex vertex = frosted(true);
  EXPECT_FALSE(turn(vertex, false, {0.8, 0.7}, kAbove)) << "no unit vector";
  EXPECT_FALSE(turn(vertex, true, {0.9, -0.2}, kBelow)) << "total reflection";
  EXPECT_FALSE(turn(vertex, false, {0.7, -0.1}, Vec3d(-0.9, 0.0, 0.1).normalized()))
      << "into the surface";
  EXPECT_FALSE(offset_normal(vertex, kAbove, Vec3d(-0.9, 0.3, -0.1).normalized()))
      << "refracted too far";
  InnerVertex matte = vertex;
  matte.bsdf = Bsdf(Frame::around(vertex.hit.point.ns), vertex.hit.point.ng);
  EXPECT_FALSE(relative_index(matte, true, kAbove)) << "nothing refracts";
  EXPECT_EQ(relative_index(matte, false, kAbove), 1.0);
}

}  // namespace
}  // namespace ajar
