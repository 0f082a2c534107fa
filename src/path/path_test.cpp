#include "path/path.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/archive.h"
#include "path/inversion.h"
#include "path/path_archive.h"
#include "path/replay.h"
#include "path/testing/plain_scene.h"
#include "path/visibility.h"

namespace ajar {
namespace {

using testing::plain_scene;
using testing::recorded;

TEST(Path, DirectionsPointAlongItsEdges) {
  const auto scene = plain_scene();
  for (const auto& [path, technique] : recorded(*scene, testing::all_techniques(), 50)) {
    for (int x = 0; x < path.depth(); ++x) {
      const Vec3 w = normalize(path.position(x + 1) - path.position(x));
      EXPECT_EQ(path.toward_camera(*scene, x), w);
      EXPECT_EQ(path.toward_light(*scene, x + 1), -w);
    }
  }
}

TEST(Path, CopiesOverOneAsLongWithoutAllocation) {
  const auto scene = plain_scene();
  const auto paths = recorded(*scene, testing::all_techniques(), 50);
  Path copy = paths.front().first;
  for (const auto& [path, technique] : paths) {
    if (path.depth() > paths.front().first.depth()) continue;
    const InnerVertex* before = copy.vertices.data();
    copy = path;
    EXPECT_EQ(copy.vertices.data(), before);
  }
}

TEST(Path, EdgesAreInterruptedByInsertedVertices) {
  const auto scene = plain_scene();
  RayCounts rays;
  int checked = 0;
  for (const auto& [recorded_path, technique] : recorded(*scene, testing::all_techniques(), 500)) {
    Path path = recorded_path;
    for (int edge = 0; edge < path.depth(); ++edge) {
      EXPECT_TRUE(look_along(*scene, path, edge, rays));
    }
    // From the disk beside the camera to behind the one before it.
    path.light_point.surface.p = Vec3(0.F, 0.F, 4.F);
    if (path.vertex(1).hit.shape != 1) continue;
    EXPECT_FALSE(look_along(*scene, path, 0, rays));
    EXPECT_TRUE(look_along(*scene, path, 1, rays));
    EXPECT_FALSE(look_along_all(*scene, path, rays));
    ++checked;
  }
  EXPECT_GT(checked, 10);
  EXPECT_GT(rays.rays, 50U);
}

TEST(PathInversion, IsEmptyWhereTheTechniqueCannotMakeThePath) {
  const auto scene = plain_scene();
  const PathSamplerSettings settings = testing::all_techniques();
  PathSamplerSettings without_light = settings;
  without_light.techniques = TechniqueSet::pt();
  for (const auto& [path, technique] : recorded(*scene, settings, 50)) {
    const int k = path.depth();
    IndependentSource fresh({1, 2, 3, 4});
    EXPECT_TRUE(invert(*scene, settings, path, technique, fresh));
    EXPECT_FALSE(invert(*scene, settings, path, {0, k + 1}, fresh)) << "into a point light";
    EXPECT_FALSE(invert(*scene, settings, path, {k + 1, 0}, fresh));
    EXPECT_FALSE(invert(*scene, without_light, path, {k, 1}, fresh)) << "not in the set";
  }
}

TEST(PathInversion, DrawsLostNumbersAfresh) {
  const auto scene = plain_scene();
  const PathSamplerSettings settings = testing::all_techniques();
  for (const auto& [path, technique] : recorded(*scene, settings, 50)) {
    IndependentSource fresh({1, 2, 3, 4});
    auto inversion = invert(*scene, settings, path, technique, fresh);
    ASSERT_TRUE(inversion);
    PathPrimaries& numbers = inversion->numbers;
    EXPECT_EQ(numbers.blocks(Stream::Camera).size(), static_cast<std::size_t>(technique.t));
    EXPECT_EQ(numbers.blocks(Stream::Light).size(), static_cast<std::size_t>(technique.s));
    // A pinhole has no place, matte surfaces have one lobe, and there are no numbers beyond the
    // path.
    for (const SampleAddress address : {SampleAddress(Stream::Camera, 0, kEmissionPosition),
                                        SampleAddress(Stream::Light, 9, Slot::LightPositionX)}) {
      EXPECT_EQ(numbers.get_pair(address), fresh.get_pair(address));
    }
    const SampleAddress beyond(Stream::Camera, 7, Slot::BsdfLobe, 3);
    EXPECT_EQ(numbers.get(beyond), fresh.get(beyond));
  }
}

TEST(PathArchive, RefusesUnknownIds) {
  const auto scene = plain_scene();
  const Path path = recorded(*scene, testing::all_techniques(), 50).front().first;
  const auto load = [&](const std::string& bytes) {
    unarchive(bytes, [&](InputArchive& from) { load_path(from, *scene); });
  };
  const auto saved = [&](const Path& changed) {
    return archived([&](OutputArchive& to) { save_path(to, *scene, changed); });
  };
  EXPECT_NO_THROW(load(saved(path)));
  Path elsewhere = path;
  elsewhere.vertices[0].hit.shape = 2;
  EXPECT_THROW(load(saved(elsewhere)), std::runtime_error);
  Path no_number = path;
  no_number.vertices[0].hit.point.ns.y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(load(saved(no_number)), std::runtime_error);
  Path no_lobe = path;
  no_lobe.vertices[0].event.lobe = 8;
  EXPECT_THROW(load(saved(no_lobe)), std::runtime_error);
  Path no_medium = path;
  no_medium.vertices[0].in_medium = true;
  EXPECT_THROW(load(saved(no_medium)), std::runtime_error);
  Path no_primitive = path;
  no_primitive.light_point.surface.primitive = 1;
  EXPECT_THROW(load(saved(no_primitive)), std::runtime_error);
}

}  // namespace
}  // namespace ajar
