#include "scene/light/sphere_projection.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "core/warp.h"
#include "scene/light/light_test_support.h"
#include "scene/light/sphere_map.h"
#include "scene/testing/image_file.h"

namespace ajar {
namespace {

using namespace testing;

TEST(EqualAreaProjection, DirectionsAndCoordinatesAreInverse) {
  Rng rng(1);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 w = warp::uniform_sphere(next_pair(rng));
    const Vec2 uv = equal_area::to_uv(w);
    EXPECT_TRUE(uv.x >= 0.F && uv.x < 1.F && uv.y >= 0.F && uv.y < 1.F);
    EXPECT_LT(length(equal_area::to_direction(uv) - w), 2e-5F);
    EXPECT_LT(length(equal_area::to_direction(equal_area::to_uv(w * 7.F)) - w), 2e-5F);
  }
}

TEST(EqualAreaProjection, HasThePolesWherePbrtHasThem) {
  const auto near = [](const Vec2& a, const Vec2& b) { return (a - b).length() < 1e-5F; };
  EXPECT_TRUE(near(equal_area::to_uv({0.F, 0.F, 1.F}), {0.5F, 0.5F}));
  EXPECT_TRUE(near(equal_area::to_uv({1.F, 0.F, 0.F}), {1.F, 0.5F}));
  EXPECT_TRUE(near(equal_area::to_uv({-1.F, 0.F, 0.F}), {0.F, 0.5F}));
  EXPECT_TRUE(near(equal_area::to_uv({0.F, 1.F, 0.F}), {0.5F, 1.F}));
  EXPECT_TRUE(near(equal_area::to_uv({0.F, -1.F, 0.F}), {0.5F, 0.F}));
  const Vec2 corner = equal_area::to_uv(normalize(Vec3(1.F, 1.F, -1e4F)));
  EXPECT_NEAR(corner.x, 1.F, 1e-3F);
  EXPECT_NEAR(corner.y, 1.F, 1e-3F);
  // On the diagonal between x and y, half-way along the square's edge from the middle.
  const Vec2 between = equal_area::to_uv(normalize(Vec3(1.F, 1.F, 0.F)));
  EXPECT_NEAR(between.x, 0.75F, 1e-5F);
  EXPECT_NEAR(between.y, 0.75F, 1e-5F);
}

TEST(EqualAreaProjection, GivesEqualSquaresEqualSolidAngles) {
  // Uniform directions fill the cells of a grid alike: chi-square with 63 degrees of freedom.
  constexpr int kSide = 8;
  constexpr int kSamples = 64000;
  std::array<int, kSide * kSide> counts{};
  Rng rng(2);
  for (int i = 0; i < kSamples; ++i) {
    const Vec2 uv = equal_area::to_uv(warp::uniform_sphere(next_pair(rng)));
    ++counts[static_cast<std::size_t>(uv.y * kSide) * kSide +
             static_cast<std::size_t>(uv.x * kSide)];
  }
  const double expected = static_cast<double>(kSamples) / (kSide * kSide);
  double chi_square = 0.0;
  for (const int count : counts) chi_square += (count - expected) * (count - expected) / expected;
  EXPECT_LT(chi_square, 112.3);  // exceeded once in 10000 times
}

std::vector<float> square_with_bright(int x, int y) {
  std::vector<float> rgb(3 * 64, 0.F);
  for (std::size_t c = 0; c < 3; ++c) rgb[3 * static_cast<std::size_t>(8 * y + x) + c] = 100.F;
  return rgb;
}

desc::Node square_sky(const std::string& path) {
  desc::Node node = environment_node({1, 1, 1}, path);
  node.set("projection", std::string("equal_area"));
  return node;
}

TEST(SquareEnvironment, BrightTexelShinesFromItsDirection) {
  // Row 0 is at −y, column 0 at −x; the middle is +z.
  const ImageFile file(8, 8, square_with_bright(4, 1));
  const auto light = light_of(square_sky(file.path()), Mat4());
  const Vec3 toward = equal_area::to_direction({4.5F / 8.F, 1.5F / 8.F});
  EXPECT_LT(toward.y, -0.5F);
  EXPECT_NEAR(light->emitted(light->at_direction(toward), -toward)[0], 100.F, 1e-3F);
  const Vec3 mirrored(toward.x, -toward.y, toward.z);
  EXPECT_EQ(light->emitted(light->at_direction(mirrored), -mirrored)[0], 0.F);
}

TEST(SquareEnvironment, IsOneOfLatitudesWhereItIsNotSquare) {
  std::vector<float> rgb(std::size_t{3} * 16 * 8, 0.F);
  for (std::size_t c = 0; c < 3; ++c) rgb[3 * (16 * 2 + 5) + c] = 100.F;
  const ImageFile file(16, 8, rgb);
  Warnings warnings;
  desc::Light description;
  description.node = square_sky(file.path());
  const auto light = make_light(description, kBounds, warnings);
  EXPECT_EQ(warnings.count(), 1U);
  const Vec3 toward = lat_long::to_direction({5.5F / 16.F, 2.5F / 8.F});
  EXPECT_NEAR(light->emitted(light->at_direction(toward), -toward)[0], 100.F, 1e-2F);
}

TEST(SquareEnvironment, IsSampledByItsTexels) {
  const ImageFile file(8, 8, square_with_bright(6, 6));
  const auto light = light_of(square_sky(file.path()), Mat4());
  Rng rng(3);
  for (int i = 0; i < 100; ++i) {
    ConnectionUniforms u{};
    u.position = next_pair(rng);
    const auto sample = light->sample_connection(Vec3(0.F), u);
    ASSERT_TRUE(sample);
    EXPECT_NEAR(sample->pdf.value(), 64.F / (4.F * kPi), 1e-3F);
    EXPECT_NEAR(sample->weight[0], 100.F * 4.F * kPi / 64.F, 1e-2F);
  }
}

TEST(SquareEnvironment, IsScaledToItsIrradiance) {
  std::vector<float> white(3 * 64, 2.F);
  const ImageFile file(8, 8, white);
  desc::Node node = square_sky(file.path());
  node.set("irradiance", 10.F);
  const auto light = light_of(node, Mat4());
  const Vec3 up(0.F, 0.F, 1.F);
  EXPECT_NEAR(light->emitted(light->at_direction(up), -up)[0], 10.F / kPi, 2e-2F);
}

}  // namespace
}  // namespace ajar
