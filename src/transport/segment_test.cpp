#include "transport/segment.h"

#include <gtest/gtest.h>

#include "scene/desc/models.h"
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
      const SegmentEnd end = trace_segment(*scene, far_away, medium, numbers, rays);
      EXPECT_TRUE(end.lost);
      EXPECT_FALSE(end.hit);
      EXPECT_FALSE(end.scattered);
    }
    EXPECT_FALSE(connect(*scene, far_away, nullptr, rays)) << "not visible";
    EXPECT_TRUE(is_blocked(*scene, far_away, rays));
    EXPECT_EQ(rays.rays, 4U);
    EXPECT_EQ(rays.rays_out_of_range, 4U);

    const SegmentEnd hit =
        trace_segment(*scene, {{0, 0, 1e10F}, {0, 0, -1}}, nullptr, numbers, rays);
    EXPECT_TRUE(hit.hit);
    EXPECT_FALSE(hit.lost);
    const SegmentEnd miss =
        trace_segment(*scene, {{0, 0, 1e10F}, {0, 0, 1}}, nullptr, numbers, rays);
    EXPECT_FALSE(miss.hit);
    EXPECT_FALSE(miss.lost);
    EXPECT_FALSE(is_blocked(*scene, {{0, 0, 0.5F}, {0, 0, 1}, -1.F}, rays)) << "of no length";
    EXPECT_EQ(rays.rays_out_of_range, 4U);
  }
}

}  // namespace
}  // namespace ajar
