#include "transport/segment.h"

#include <gtest/gtest.h>

#include "scene/desc/models.h"
#include "scene/testing/inverse_checks.h"
#include "scene/testing/quadrics.h"
#include "transport/sources.h"

namespace ajar {
namespace {

/// A ball at the origin, and in the second scene an interface around it.
std::unique_ptr<Scene> ball(bool with_interface) {
  desc::SceneDesc scene;
  scene.shapes.emplace_back().node = testing::sphere_node();
  if (with_interface) {
    scene.materials.emplace_back().node = desc::material_node("interface");
    scene.shapes.emplace_back().node = testing::sphere_node(2, -2, 2, 360);
    scene.shapes.back().material = 0;
  }
  Warnings warnings;
  return std::make_unique<Scene>(std::move(scene), BuildOptions{}, warnings);
}

TEST(Segments, RaysThatCannotBeTracedAreLostAndCounted) {
  const Medium fog("fog", Spectrum(0.F), Spectrum(1e-30F), 0.F);
  const Ray far_away{{0, 0, 1e30F}, {0, 0, -1}};
  for (const bool with_interface : {false, true}) {
    SCOPED_TRACE(with_interface);
    const auto scene = ball(with_interface);
    RayCounts rays;
    SobolSource source({1, 0, 2, 0});
    const DistanceSource numbers(source, Stream::Camera, 0, 0);
    for (const Medium* medium : {static_cast<const Medium*>(nullptr), &fog}) {
      const SegmentEnd end = trace_segment(*scene, far_away, medium, kAnyLane, numbers, rays);
      EXPECT_TRUE(end.lost);
      EXPECT_FALSE(end.hit);
      EXPECT_FALSE(end.scattered);
    }
    EXPECT_FALSE(connect(*scene, far_away, nullptr, rays)) << "not visible";
    EXPECT_TRUE(is_blocked(*scene, far_away, rays));
    EXPECT_EQ(rays.rays, 4U);
    EXPECT_EQ(rays.rays_out_of_range, 4U);

    const SegmentEnd hit =
        trace_segment(*scene, {{0, 0, 1e10F}, {0, 0, -1}}, nullptr, kAnyLane, numbers, rays);
    EXPECT_TRUE(hit.hit);
    EXPECT_FALSE(hit.lost);
    const SegmentEnd miss =
        trace_segment(*scene, {{0, 0, 1e10F}, {0, 0, 1}}, nullptr, kAnyLane, numbers, rays);
    EXPECT_FALSE(miss.hit);
    EXPECT_FALSE(miss.lost);
    EXPECT_FALSE(is_blocked(*scene, {{0, 0, 0.5F}, {0, 0, 1}, -1.F}, rays)) << "of no length";
    EXPECT_EQ(rays.rays_out_of_range, 4U);
  }
}

/// Two numbers, for any address.
struct TwoNumbers final : SampleSource {
  explicit TwoNumbers(const Vec2& n) : numbers(n) {}
  float get(SampleAddress address) override {
    return address == kLaneChoice ? numbers.x : numbers.y;
  }
  Vec2 get_pair(SampleAddress) override { return numbers; }
  Vec2 numbers;
};

/// Smoke in a box larger than the cube around the ball, denser to one side and empty in a corner.
desc::Density smoke() {
  desc::DensityGrid grid{{3, 2, 3}, {}, desc::DensityGrid::Points::Centers, {}};
  for (int i = 0; i < 18; ++i) grid.values.push_back(i < 3 ? 0.F : 0.1F * static_cast<float>(i));
  Mat4 to_world;
  to_world.setScale(Vec3d(3.5));
  to_world[3][0] = to_world[3][1] = to_world[3][2] = -1.75;
  return {std::make_shared<const desc::DensityGrid>(std::move(grid)), to_world};
}

/// Red where the other is thin, blue where it is dense.
desc::Density colored_smoke() {
  const desc::Density plain = smoke();
  desc::DensityGrid grid = *plain.grid;
  for (const float value : grid.values) {
    grid.absorption.emplace_back(value, 1.8F - value, 0.5F);
    grid.scattering.emplace_back(1.8F - value, value, value);
  }
  grid.values.clear();
  return {std::make_shared<const desc::DensityGrid>(std::move(grid)), plain.to_world};
}

/// Weights of distances that each choose a lane of their own would grow without bound.
TEST(FreeFlights, AreWorthTransmittanceOverTheMeanOfTheDensitiesByLane) {
  const Medium medium("m", Spectrum(0.1F, 0.F, 0.3F), Spectrum(1.F, 2.F, 4.F), 0.F);
  IndependentSource numbers({1, 2, 3, 4});
  ByLane lanes = kAnyLane;
  Spectrum worth(1.F);
  ByLane f(1.0);
  ByLane pdf(1.0);
  for (int i = 0; i < 30; ++i) {
    SCOPED_TRACE(i);
    const float distance = 2.F * numbers.get({Stream::Camera, i, Slot::MediumDistance});
    Segment segment;
    segment.scattering_depth = medium.sigma_t(Vec3(0.F)) * distance;
    segment.transmittance = exp(segment.scattering_depth * -1.F);
    const bool scatters = i % 3 != 2;
    const FreeFlight flight(segment, lanes, {scatters ? &medium : nullptr, Vec3(0.F)});
    worth *= flight.weight;
    lanes = flight.lanes;
    f *= by_lane(segment.transmittance);
    pdf *= by_lane(segment.transmittance);
    if (scatters) {
      f *= by_lane(medium.sigma_s(Vec3(0.F)));
      pdf *= by_lane(medium.sigma_t(Vec3(0.F)));
    }
    EXPECT_NEAR(mean(lanes), 1.0, 1e-5);
    for (int lane = 0; lane < 3; ++lane) {
      const double expected = f[lane] / mean(pdf);
      EXPECT_NEAR(double{worth[lane]}, expected, 1e-4 * expected + 1e-30);
      EXPECT_LE(worth[lane], 3.001F);
    }
  }
}

TEST(FreeFlights, OfGreyMediaHaveNoLane) {
  const Medium medium("m", Spectrum(0.1F), Spectrum(0.3F), 0.F);
  Segment segment;
  segment.scattering_depth = Spectrum(0.7F);
  segment.transmittance = exp(segment.scattering_depth * -1.F);
  const FreeFlight flight(segment, kAnyLane, {&medium, Vec3(0.F)});
  EXPECT_EQ(flight.lanes, kAnyLane);
  EXPECT_NEAR(flight.weight[0], 0.75F, 1e-6F);
}

class SegmentsThrough : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Media, SegmentsThrough, ::testing::Values("fog", "smoke", "colours"));

TEST_P(SegmentsThrough, DistancesAreInverted) {
  // From fog through an interface into thicker fog or smoke, up to a ball; or past it, to
  // infinity.
  desc::SceneDesc description;
  description.shapes.emplace_back().node = testing::sphere_node();
  description.materials.emplace_back().node = desc::material_node("interface");
  description.media.emplace_back().sigma_s = {0.7F, 0.5F, 0.2F};
  description.media.emplace_back().sigma_s = {2.F, 1.F, 0.F};
  description.media.back().sigma_a = {0.F, 0.3F, 0.1F};
  if (GetParam() == std::string("smoke")) description.media.back().density = smoke();
  if (GetParam() == std::string("colours")) description.media.back().density = colored_smoke();
  desc::Shape& around = description.shapes.emplace_back();
  around.node = testing::sphere_node(2, -2, 2, 360);
  around.material = 0;
  around.has_medium_interface = true;
  around.outside = 0;
  around.inside = 1;
  Warnings warnings;
  const Scene scene(std::move(description), BuildOptions{}, warnings);
  for (const bool hits : {false, true}) {
    const Ray ray{{hits ? 0.F : 1.5F, 0, 4}, {0, 0, -1}};
    const auto trace = [&](const Vec2& u) {
      TwoNumbers source(u);
      RayCounts rays;
      return trace_segment(scene, ray, scene.medium(0), kAnyLane, {source, Stream::Camera, 0, 0},
                           rays);
    };
    testing::check_inverse(
        {hits ? "to a ball" : "to infinity", 2, 1e-4,
         [&](const testing::InverseNumbers& u,
             const testing::InverseNumbers& v) -> std::optional<testing::RoundTrip> {
           const SegmentEnd end = trace({u[0], u[1]});
           const MediumPoint place{end.scattered ? end.medium : nullptr,
                                   ray.origin + ray.direction * end.distance};
           const auto lane = invert_lane(by_lane(end.segment.distance_pdf(place)), v[0]);
           if (!lane) return testing::RoundTrip{};
           const float distance = invert_distance(end.segment, place, lane_of(*lane), v[1]);
           const SegmentEnd again = trace({*lane, distance});
           const bool same = again.scattered == end.scattered && again.medium == end.medium;
           const bool finite = std::isfinite(end.distance);
           return testing::RoundTrip{
               same,
               {*lane, distance},
               same && finite ? std::abs(double{again.distance} - double{end.distance}) : 0.0};
         }});
  }
}

}  // namespace
}  // namespace ajar
