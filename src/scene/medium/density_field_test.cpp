#include "scene/medium/density_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "core/warp.h"
#include "scene/medium/medium.h"

namespace ajar {
namespace {

using desc::DensityGrid;

constexpr float kForEver = std::numeric_limits<float>::infinity();

/// Many values at random, of which a corner is empty and a corner is full.
desc::Density random_density(const desc::Vec3i& resolution, DensityGrid::Points points,
                             DensityGrid::Border border, const Mat4& to_world) {
  DensityGrid grid{resolution, {}, points, border};
  Rng rng(7);
  for (int z = 0; z < resolution.z; ++z) {
    for (int y = 0; y < resolution.y; ++y) {
      for (int x = 0; x < resolution.x; ++x) {
        const float value = rng.next();
        const int low = std::max({x, y, z});
        const int high = std::min({x, y, z});
        grid.values.push_back(low < 9 ? 0.F : high >= 9 ? 0.75F : value);
      }
    }
  }
  return {std::make_shared<const DensityGrid>(std::move(grid)), to_world};
}

Mat4 skewed() { return {2, 0.1, 0, 0, -0.2, 3, 0.3, 0, 0, 0.4, 1.5, 0, -1, -1.5, -0.75, 1}; }

/// Oracle by the declaration, point by point.
double density_at(const desc::Density& density, const Vec3d& world) {
  const DensityGrid& grid = *density.grid;
  Vec3d p;
  density.to_world.inverse().multVecMatrix(world, p);
  if (std::min({p.x, p.y, p.z}) < 0.0 || std::max({p.x, p.y, p.z}) > 1.0) return 0.0;
  const bool at_corners = grid.points == DensityGrid::Points::Corners;
  p = at_corners ? p * Vec3d(grid.resolution - desc::Vec3i(1))
                 : p * Vec3d(grid.resolution) - Vec3d(0.5);
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1.0;
    bool is_inside = true;
    std::size_t index = 0;
    for (int axis = 2; axis >= 0; --axis) {
      const int n = grid.resolution[axis];
      const int at = static_cast<int>(std::floor(p[axis])) + ((corner >> axis) & 1);
      weight *= 1.0 - std::abs(p[axis] - at);
      is_inside = is_inside && at >= 0 && at < n;
      index =
          index * static_cast<std::size_t>(n) + static_cast<std::size_t>(std::clamp(at, 0, n - 1));
    }
    if (is_inside || grid.border == DensityGrid::Border::Clamp) {
      sum += weight * static_cast<double>(grid.values[index]);
    }
  }
  return sum;
}

/// From around the box, through it or not.
Ray random_ray(Rng& rng) {
  const auto signed_number = [&] { return 2.F * rng.next() - 1.F; };
  const Vec3 origin(3.F * signed_number(), 3.F * signed_number(), 3.F * signed_number());
  const Vec3 target(signed_number(), signed_number(), signed_number());
  return {origin, normalize(target - origin)};
}

struct Kind {
  DensityGrid::Points points;
  DensityGrid::Border border;
};
class DensityFields : public ::testing::TestWithParam<Kind> {
 protected:
  desc::Density density(const desc::Vec3i& resolution = {20, 23, 18}) const {
    return random_density(resolution, GetParam().points, GetParam().border, skewed());
  }
};

TEST_P(DensityFields, IntegrateAlongRaysAsSumsOfManyPointsDo) {
  const desc::Density described = density();
  const DensityField field(described);
  Rng rng(1);
  int crossed = 0;
  for (int i = 0; i < 60; ++i) {
    Ray ray = random_ray(rng);
    if (i % 6 < 3) {  // along an axis
      ray.direction = Vec3(0.F);
      ray.direction[i % 3] = i % 2 == 0 ? 1.F : -1.F;
    }
    const float length = i % 4 == 0 ? 2.F : 8.F;
    constexpr int kPoints = 40000;
    double sum = 0.0;
    for (int k = 0; k < kPoints; ++k) {
      const double t = static_cast<double>(length) * (k + 0.5) / kPoints;
      sum += density_at(described, Vec3d(ray.origin) + Vec3d(ray.direction) * t);
    }
    sum *= static_cast<double>(length) / kPoints;
    const Column column = field.along(ray, length, kForEver);
    EXPECT_NEAR(column.density, sum, 5e-4) << i;
    EXPECT_FALSE(column.reached);
    EXPECT_EQ(column.distance, length);
    crossed += sum > 0.1 ? 1 : 0;
  }
  EXPECT_GT(crossed, 20);
}

TEST_P(DensityFields, InvertTheIntegral) {
  const DensityField field(density());
  Rng rng(2);
  int ended = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray = random_ray(rng);
    const float whole = field.along(ray, kForEver, kForEver).density;
    const float asked = whole * rng.next();
    if (whole == 0.F) continue;
    const Column column = field.along(ray, kForEver, asked);
    ASSERT_TRUE(column.reached);
    EXPECT_EQ(column.density, asked);
    EXPECT_NEAR(field.along(ray, column.distance, kForEver).density, asked, 1e-5F) << i;
    EXPECT_FALSE(field.along(ray, kForEver, whole * 1.0001F).reached);
    ++ended;
  }
  EXPECT_GT(ended, 1000);
}

TEST_P(DensityFields, HaveTheDensityOfTheirPoints) {
  const desc::Density described = density();
  const DensityField field(described);
  Rng rng(3);
  for (int i = 0; i < 1000; ++i) {
    Vec3d p;
    described.to_world.multVecMatrix(
        Vec3d(double{rng.next()}, double{rng.next()}, double{rng.next()}), p);
    EXPECT_NEAR(field.at(Vec3(p)), density_at(described, p), 1e-4) << i;
  }
  EXPECT_GT(field.at(Vec3(1e9F, 0.F, 0.F)), 0.F) << "paths are divided by it";
}

TEST_P(DensityFields, AreTheSameForwardsAndBackwards) {
  const DensityField field(density());
  Rng rng(4);
  for (int i = 0; i < 500; ++i) {
    const Ray ray = random_ray(rng);
    const Ray back{ray.origin + ray.direction * 6.F, -ray.direction};
    EXPECT_NEAR(field.along(ray, 6.F, kForEver).density, field.along(back, 6.F, kForEver).density,
                1e-5F);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, DensityFields,
    ::testing::Values(Kind{DensityGrid::Points::Centers, DensityGrid::Border::Zero},
                      Kind{DensityGrid::Points::Centers, DensityGrid::Border::Clamp},
                      Kind{DensityGrid::Points::Corners, DensityGrid::Border::Zero}));

TEST(DensityField, OfOneEverywhereIsHomogeneousInItsBox) {
  for (const int n : {1, 2, 3, 30}) {
    const desc::Density density{
        std::make_shared<const DensityGrid>(DensityGrid{
            desc::Vec3i(n), std::vector<float>(static_cast<std::size_t>(n * n * n), 1.F),
            DensityGrid::Points::Centers, DensityGrid::Border::Clamp}),
        Mat4()};
    const DensityField field(density);
    const Ray ray{{-1.F, 0.3F, 0.4F}, {1.F, 0.F, 0.F}};
    EXPECT_NEAR(field.along(ray, kForEver, kForEver).density, 1.F, 1e-6F) << n;
    EXPECT_NEAR(field.along(ray, 1.25F, kForEver).density, 0.25F, 1e-6F) << n;
    EXPECT_NEAR(field.along(ray, kForEver, 0.5F).distance, 1.5F, 1e-6F) << n;
    EXPECT_EQ(field.along({{-1.F, 2.F, 0.F}, {1.F, 0.F, 0.F}}, kForEver, 0.F).reached, false) << n;
  }
}

TEST(DensityField, SamplesDistancesByTheirDensity) {
  const Medium medium(
      "smoke", Spectrum(0.5F), Spectrum(1.5F), 0.F,
      std::make_unique<const DensityField>(random_density(
          {20, 23, 18}, DensityGrid::Points::Centers, DensityGrid::Border::Zero, skewed())));
  const Ray ray{{-2.F, -1.F, -0.5F}, normalize(Vec3(1.F, 0.55F, 0.3F))};
  constexpr int kBins = 25;
  constexpr float kLength = 5.F;
  std::array<double, kBins> expected{};
  constexpr int kPoints = 400;
  for (int bin = 0; bin < kBins; ++bin) {
    for (int i = 0; i < kPoints; ++i) {
      const float t =
          kLength * (static_cast<float>(bin) + (static_cast<float>(i) + 0.5F) / kPoints) / kBins;
      const float depth = medium.along(ray, t).depth[0];
      const bool is_inside = medium.along(ray, t + 1e-3F).depth[0] > depth;
      if (!is_inside) continue;
      expected[static_cast<std::size_t>(bin)] +=
          static_cast<double>(std::exp(-depth) *
                              medium.sigma_t(ray.origin + ray.direction * t)[0]) *
          static_cast<double>(kLength / kBins / kPoints);
    }
  }
  constexpr int kSamples = 200000;
  std::array<double, kBins> found{};
  Rng rng(5);
  for (int i = 0; i < kSamples; ++i) {
    const Crossing crossing = medium.along(ray, kForEver, 0, -std::log(1.F - rng.next()));
    if (!crossing.reached) continue;
    found[static_cast<std::size_t>(crossing.distance / kLength * kBins)] += 1.0 / kSamples;
  }
  double sum = 0.0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    sum += expected[bin];
    EXPECT_NEAR(found[bin], expected[bin],
                5.0 * std::sqrt((expected[bin] + 1e-5) / kSamples) + 1e-4)
        << bin;
  }
  EXPECT_GT(sum, 0.5);
}

TEST(DensityGrids, AreValidated) {
  const auto complaint_of = [](const desc::Vec3i& resolution, std::vector<float> values,
                               DensityGrid::Points points, const Mat4& to_world) {
    return desc::complaint({std::make_shared<const DensityGrid>(
                                DensityGrid{resolution, std::move(values), points}),
                            to_world})
        .value_or("none");
  };
  const Mat4 unit;
  Mat4 flat;
  flat[1][1] = 0.0;
  constexpr auto kCenters = DensityGrid::Points::Centers;
  EXPECT_EQ(complaint_of({1, 1, 2}, {1, 0}, kCenters, unit), "none");
  EXPECT_EQ(complaint_of({2, 2, 2}, {1, 0}, kCenters, unit),
            "has 2 values of density, not 2 × 2 × 2");
  EXPECT_NE(complaint_of({1, 0, 2}, {}, kCenters, unit).find("fewer than 1"), std::string::npos);
  EXPECT_NE(
      complaint_of({1, 1, 2}, {1, 0}, DensityGrid::Points::Corners, unit).find("fewer than 2"),
      std::string::npos);
  EXPECT_NE(complaint_of({65536, 65536, 65536}, {}, kCenters, unit).find("has 0 values"),
            std::string::npos);
  EXPECT_NE(complaint_of({1, 1, 2}, {1, -1}, kCenters, unit).find("negative"), std::string::npos);
  EXPECT_NE(complaint_of({1, 1, 2}, {1, 0}, kCenters, flat).find("without volume"),
            std::string::npos);
}

TEST(DensityGrids, OfColorsAreValidated) {
  const auto complaint_of = [](std::vector<float> values, std::vector<Vec3> absorption,
                               std::vector<Vec3> scattering) {
    DensityGrid grid{{1, 1, 2}, std::move(values)};
    grid.absorption = std::move(absorption);
    grid.scattering = std::move(scattering);
    return desc::complaint({std::make_shared<const DensityGrid>(std::move(grid)), Mat4()})
        .value_or("none");
  };
  const Vec3 red(1, 0, 0);
  EXPECT_EQ(complaint_of({}, {red, red}, {red, red}), "none");
  EXPECT_EQ(complaint_of({}, {}, {red, red}), "none");
  EXPECT_EQ(complaint_of({}, {red, red}, {}), "none");
  EXPECT_EQ(complaint_of({1, 1}, {red, red}, {}), "has both densities and colours");
  EXPECT_EQ(complaint_of({}, {red}, {red, red}), "has 1 colours of absorption, not 1 × 1 × 2");
  EXPECT_EQ(complaint_of({}, {red, red}, {red}), "has 1 colours of scattering, not 1 × 1 × 2");
  EXPECT_EQ(complaint_of({}, {red, {0, 0, -1}}, {}),
            "has an absorption that is negative or no number");
  EXPECT_EQ(complaint_of({}, {red, red}, {red, {0, std::nanf(""), 1}}),
            "has a scattering that is negative or no number");
}

}  // namespace
}  // namespace ajar
