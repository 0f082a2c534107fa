#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>

#include "core/random.h"
#include "core/warp.h"
#include "scene/shape/make_surface_sampler.h"
#include "scene/testing/quadrics.h"

namespace ajar {
namespace {

SurfaceUniforms next(Rng& rng) { return {rng.next(), {rng.next(), rng.next()}}; }

Mat4 similarity() {
  Mat4 m;
  m.setAxisAngle(Vec3d(1.0, 2.0, -0.5).normalized(), 0.8);
  Mat4 scale;
  scale.setScale(1.7);
  Mat4 move;
  move.setTranslation(Vec3d(1.0, -2.0, 0.5));
  return scale * m * move;
}
Mat4 stretched() {
  Mat4 scale;
  scale.setScale(Vec3d(2.0, 0.6, -1.3));
  return scale * similarity();
}

std::vector<std::pair<std::string, Quadric>> quadrics() {
  return {{"sphere", *testing::quadric_of(testing::sphere_node())},
          {"partial sphere", *testing::quadric_of(testing::sphere_node(1, -0.4F, 0.9F, 200))},
          {"disk", *testing::quadric_of(testing::disk_node(0.3F, 1.2F, 0.4F, 300))},
          {"disk of radii and angles",
           *testing::quadric_of(testing::disk_node_of("radius_then_angle"))},
          {"cylinder", *testing::quadric_of(testing::cylinder_node(0.6F, -1, 1, 360))},
          {"cone", *testing::quadric_of(testing::cone_node(0.8F, 1.5F, 360))},
          {"paraboloid", *testing::quadric_of(testing::paraboloid_node(1, 0, 1.3F, 270))},
          {"hyperboloid",
           *testing::quadric_of(testing::hyperboloid_node({1, -1, -1}, {0.5F, 1.5F, 1}, 360))}};
}

/// χ² of samples in cells of (u, v) against the integral of the density over each cell: passes only
/// if the density is that of the samples and integrates to one. `mass(cell)` integrates
/// numerically.
void expect_density_of_samples(const SurfaceSampler& sampler, const Quadric& quadric,
                               const Placement& placement, const std::string& name) {
  constexpr int kCells = 8;
  constexpr int kSamples = 100000;
  constexpr int kFine = 16;
  std::vector<double> expected(kCells * kCells);
  double total = 0.0;
  for (int j = 0; j < kCells * kFine; ++j) {
    for (int i = 0; i < kCells * kFine; ++i) {
      const Imath::V2d uv((i + 0.5) / (kCells * kFine), (j + 0.5) / (kCells * kFine));
      const SurfacePoint p = quadric_surface_point(quadric, placement, false, uv);
      const double area = length(cross(p.dpdu, p.dpdv)) / (kCells * kCells * kFine * kFine);
      const double mass = double{sampler.pdf(p).value()} * area;
      const int cell = j / kFine * kCells + i / kFine;
      expected[static_cast<std::size_t>(cell)] += mass;
      total += mass;
    }
  }
  EXPECT_NEAR(total, 1.0, 2e-3) << name;
  std::vector<int> counts(kCells * kCells);
  Rng rng(11);
  for (int i = 0; i < kSamples; ++i) {
    const SurfaceSample s = sampler.sample(next(rng));
    ASSERT_NEAR(s.pdf.value(), sampler.pdf(s.point).value(), 1e-4F * s.pdf.value()) << name;
    const int x = std::min(static_cast<int>(s.point.uv.x * kCells), kCells - 1);
    const int y = std::min(static_cast<int>(s.point.uv.y * kCells), kCells - 1);
    const int cell = y * kCells + x;
    ++counts[static_cast<std::size_t>(cell)];
  }
  double chi_squared = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double mean = expected[i] * kSamples;
    chi_squared += (counts[i] - mean) * (counts[i] - mean) / mean;
  }
  // 63 degrees of freedom: p < 1e-6 beyond 130; quadrature error adds a little.
  EXPECT_LT(chi_squared, 140.0) << name;
}

TEST(QuadricSampler, DensityIsThatOfItsSamples) {
  for (const auto& [name, quadric] : quadrics()) {
    for (const Mat4& m : {similarity(), stretched()}) {
      const Placement placement = *Placement::make(m);
      const auto sampler = make_surface_sampler(quadric, placement, false);
      expect_density_of_samples(*sampler, quadric, placement, name);
    }
  }
}

TEST(QuadricSampler, AreaIsTheMeanOfInverseDensity) {
  for (const auto& [name, quadric] : quadrics()) {
    for (const Mat4& m : {similarity(), stretched()}) {
      const auto sampler = make_surface_sampler(quadric, *Placement::make(m), false);
      Rng rng(5);
      double sum = 0.0;
      constexpr int kSamples = 20000;
      for (int i = 0; i < kSamples; ++i)
        sum += 1.0 / double{sampler->sample(next(rng)).pdf.value()};
      EXPECT_NEAR(sum / kSamples, sampler->area(), 0.02 * sampler->area()) << name;
    }
  }
}

TEST(QuadricSampler, AreasEqualClosedForms) {
  const Placement identity = *Placement::make(Mat4());
  const auto area = [&](const auto& node) {
    return make_surface_sampler(*testing::quadric_of(node), identity, false)->area();
  };
  EXPECT_NEAR(area(testing::sphere_node(2, -2, 2, 360)), 16.F * kPi, 1e-3F);
  EXPECT_NEAR(area(testing::disk_node(0, 2, 1, 180)), 1.5F * kPi, 1e-4F);
  EXPECT_NEAR(area(testing::cylinder_node(0.5F, 0, 3, 360)), 3.F * kPi, 1e-4F);
  EXPECT_NEAR(area(testing::cone_node(3, 4, 360)), 15.F * kPi, 1e-3F);
  EXPECT_NEAR(area(testing::paraboloid_node(1, 0, 1, 360)), kPi / 6.F * (std::pow(5.F, 1.5F) - 1.F),
              1e-4F);
  EXPECT_NEAR(area(testing::hyperboloid_node({3, 0, 0}, {0, 0, 4}, 360)), 15.F * kPi, 1e-3F);
}

class SphereFrom : public ::testing::TestWithParam<float> {};

/// From outside the directions are uniform within the cone of the sphere: the cosine to the axis is
/// uniform.
TEST_P(SphereFrom, OutsideIsUniformInSolidAngle) {
  const Placement placement = *Placement::make(similarity());
  const Quadric sphere = *testing::quadric_of(testing::sphere_node());
  const auto sampler = make_surface_sampler(sphere, placement, false);
  const Vec3 center(placement.point(Vec3d(0.0)));
  const float radius = 1.7F;
  const float distance = radius * GetParam();
  const Vec3 axis = normalize(Vec3(0.3F, -0.5F, 0.8F));
  const Vec3 reference = center - axis * distance;
  const double sine = 1.0 / GetParam();
  const double one_minus_cos_max = 1.0 - std::sqrt(1.0 - sine * sine);
  Rng rng(3);
  constexpr int kBins = 20;
  constexpr int kSamples = 40000;
  std::vector<int> counts(kBins);
  for (int i = 0; i < kSamples; ++i) {
    const auto s = sampler->sample_toward(reference, next(rng));
    ASSERT_TRUE(s);
    const Vec3d d = (Vec3d(s->point.p) - Vec3d(reference));
    const double squared_sine = d.normalized().cross(Vec3d(axis)).length2();
    const double one_minus_cos =
        squared_sine / (1.0 + std::sqrt(std::max(0.0, 1.0 - squared_sine)));
    const auto bin = static_cast<int>(one_minus_cos / one_minus_cos_max * kBins);
    ++counts[static_cast<std::size_t>(std::clamp(bin, 0, kBins - 1))];
    ASSERT_NEAR((Vec3d(s->point.p) - Vec3d(center)).length(), radius, 2e-6 * radius);
    ASSERT_FLOAT_EQ(s->pdf.value(), sampler->pdf_toward(reference, s->point).value());
    // The density as solid angle is that of the cone.
    const float solid = to_solid_angle(s->pdf, reference, s->point.p, s->point.ng).value();
    const double cone = 1.0 / (2.0 * double{kPi} * one_minus_cos_max);
    ASSERT_NEAR(solid, cone, 1e-3 * cone);
  }
  double chi_squared = 0.0;
  for (const int n : counts) {
    const double mean = static_cast<double>(kSamples) / kBins;
    chi_squared += (n - mean) * (n - mean) / mean;
  }
  EXPECT_LT(chi_squared, 65.0);  // 19 degrees of freedom, p < 1e-6
}

INSTANTIATE_TEST_SUITE_P(Distances, SphereFrom, ::testing::Values(1.001F, 1.1F, 2.F, 30.F, 1000.F));

TEST(SphereSampler, InsideSamplesTheWholeSphere) {
  const Placement placement = *Placement::make(similarity());
  const auto sampler =
      make_surface_sampler(*testing::quadric_of(testing::sphere_node()), placement, false);
  const Vec3 inside = Vec3(placement.point(Vec3d(0.3, 0.2, -0.5)));
  Rng rng(9);
  Vec3d mean(0.0);
  constexpr int kSamples = 20000;
  for (int i = 0; i < kSamples; ++i) {
    const auto s = sampler->sample_toward(inside, next(rng));
    ASSERT_TRUE(s);
    ASSERT_FLOAT_EQ(s->pdf.value(), 1.F / sampler->area());
    mean += Vec3d(s->point.ng);
  }
  EXPECT_LT((mean / kSamples).length(), 5.0 / std::sqrt(static_cast<double>(kSamples)));
}

TEST(SphereSampler, FarSideHasNoDensity) {
  const auto sampler = make_surface_sampler(*testing::quadric_of(testing::sphere_node()),
                                            *Placement::make(Mat4()), false);
  SurfacePoint back = quadric_surface_point(*testing::quadric_of(testing::sphere_node()),
                                            *Placement::make(Mat4()), false, {0.5, 0.5});
  EXPECT_EQ(sampler->pdf_toward({3.F, 0.F, 0.F}, back).value(), 0.F);
  EXPECT_GT(sampler->pdf_toward({-3.F, 0.F, 0.F}, back).value(), 0.F);
}

using Corners = std::vector<std::array<unsigned, 3>>;

std::shared_ptr<desc::Mesh> mesh_of(const Corners& triangles) {
  auto mesh = std::make_shared<desc::Mesh>();
  mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {1, 0, 0}, {2, 0, 0}};
  for (const auto& t : triangles) mesh->indices.emplace_back(t[0], t[1], t[2]);
  return mesh;
}
// Without area: one with two equal corners, and one with all corners on a line.
constexpr std::array<unsigned, 3> kEqualCorners = {1, 1, 2};
constexpr std::array<unsigned, 3> kOnALine = {0, 4, 5};

TEST(MeshSampler, ChoosesTrianglesByAreaAndNeverEmptyOnes) {
  Warnings warnings;
  const TriangleMesh mesh(mesh_of({{0, 1, 2}, kEqualCorners, {0, 2, 3}, kOnALine}),
                          *Placement::make(Mat4()), false, {}, warnings);
  const auto sampler = make_surface_sampler(mesh);
  ASSERT_TRUE(sampler);
  EXPECT_NEAR(sampler->area(), 4.F, 1e-6F);
  Rng rng(21);
  std::map<std::uint32_t, int> counts;
  constexpr int kSamples = 50000;
  for (int i = 0; i < kSamples; ++i) {
    const SurfaceSample s = sampler->sample(next(rng));
    ++counts[s.point.primitive];
    ASSERT_NEAR(s.pdf.value(), 0.25F, 1e-5F);
    ASSERT_FLOAT_EQ(s.pdf.value(), sampler->pdf(s.point).value());
  }
  EXPECT_EQ(counts[1], 0);
  EXPECT_EQ(counts[3], 0);
  EXPECT_NEAR(counts[0], 0.25 * kSamples, 5.0 * std::sqrt(kSamples * 0.25 * 0.75));
}

void expect_within_extent(const SurfaceSampler& sampler, const std::string& name) {
  const SurfaceExtent extent = sampler.extent();
  const float slack = 1e-5F * extent.box.size().length();
  Rng rng(8);
  for (int i = 0; i < 5000; ++i) {
    const SurfacePoint at = sampler.sample(next(rng)).point;
    ASSERT_TRUE(Box3(extent.box.min - Vec3(slack), extent.box.max + Vec3(slack)).intersects(at.p))
        << name;
    ASSERT_LE(angle_between(extent.normals.axis, at.ng), extent.normals.angle + 1e-3F) << name;
  }
}

TEST(SurfaceExtent, ContainsEveryPointAndNormalOfQuadrics) {
  for (const Mat4& to_world : {Mat4(), similarity(), stretched()}) {
    const Placement placement = *Placement::make(to_world);
    for (const auto& [name, quadric] : quadrics()) {
      for (const bool reversed : {false, true}) {
        expect_within_extent(*make_surface_sampler(quadric, placement, reversed), name);
      }
    }
  }
}

// A tent: its two sides are 90° apart, so their cone has half of that.
TEST(SurfaceExtent, IsTightForMeshes) {
  auto mesh = std::make_shared<desc::Mesh>();
  mesh->positions = {{-1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 2}, {0, 1, 2}, {1, 0, 2}};
  mesh->indices = {{0, 3, 1}, {1, 3, 4}, {1, 4, 2}, {2, 4, 5}};
  Warnings warnings;
  const TriangleMesh tent(mesh, *Placement::make(Mat4()), false, {}, warnings);
  const auto sampler = make_surface_sampler(tent);
  expect_within_extent(*sampler, "tent");
  const SurfaceExtent extent = sampler->extent();
  EXPECT_EQ(extent.box.min, Vec3(-1, 0, 0));
  EXPECT_EQ(extent.box.max, Vec3(1, 1, 2));
  EXPECT_NEAR(extent.normals.angle, kPi / 4.F, 1e-4F);
  EXPECT_NEAR(std::abs(extent.normals.axis.y), 1.F, 1e-4F);
}

TEST(MeshSampler, MeshWithoutAreaCannotEmit) {
  Warnings warnings;
  const TriangleMesh flat(mesh_of({kEqualCorners, kOnALine}), *Placement::make(Mat4()), false, {},
                          warnings);
  EXPECT_EQ(make_surface_sampler(flat), nullptr);
}

}  // namespace
}  // namespace ajar
