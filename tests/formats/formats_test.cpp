// Equal scenes in several formats give equal pictures: units, sides, directions and images.
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "import/import.h"
#include "import/pbrt/pbrt_writer.h"
#include "import/shared_scenes_test_support.h"
#include "import/testing/temporary_folder.h"
#include "support/render.h"
#include "support/room_formats.h"
#include "support/same_picture.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;
using test::RoomSurface;

/// A folder that is gone after the test.
class Formats : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
};

/// At 96×72 pixels through a box, which formats have by default, or not.
std::unique_ptr<Scene> scene_of(const std::string& path, bool may_warn) {
  Warnings warnings;
  desc::SceneDesc description = import_scene(path, warnings);
  description.film.filter = {};
  auto scene =
      std::make_unique<Scene>(std::move(description), BuildOptions{Vec2i(96, 72)}, warnings);
  if (!may_warn) {
    for (const std::string& message : warnings.messages()) ADD_FAILURE() << message;
  }
  return scene;
}

test::Render render(const std::string& path, std::uint64_t seed, int samples,
                    bool may_warn = false) {
  test::RenderOptions options;
  options.samples = samples;
  options.replicates = 16;
  options.max_depth = 4;
  options.seed = seed;
  return test::render(*scene_of(path, may_warn), options);
}

/// Blocks of 8×8 pixels differ by less than about a tenth, the mean by less than a fiftieth: a wall
/// or a light of another size, side, colour or strength would show.
void expect_same_room(const test::Render& truth, const std::vector<std::string>& others) {
  std::uint64_t seed = 2;
  for (const std::string& path : others) {
    const test::Render other = render(path, seed++, 64);
    test::expect_same(test::replicates_of(other), test::replicates_of(truth), *other.film, 0.02,
                      path);
  }
}

TEST_F(Formats, HaveTheSameDiffuseRoom) {
  const test::Render truth =
      render(test::write_pbrt3_room(folder_.path(), RoomSurface::Diffuse), 1, 64);
  expect_same_room(
      truth, {test::write_pbrt4_room(folder_.path()),
              test::write_mitsuba_room(folder_.path(), "0.6.0", RoomSurface::Diffuse),
              test::write_mitsuba_room(folder_.path(), "3.0.0", RoomSurface::Diffuse),
              test::write_tungsten_room(folder_.path()), test::write_gltf_room(folder_.path())});
}

TEST_F(Formats, HaveTheSamePrincipledRoom) {
  const test::Render truth =
      render(test::write_pbrt3_room(folder_.path(), RoomSurface::Principled), 1, 64);
  expect_same_room(truth,
                   {test::write_mitsuba_room(folder_.path(), "3.0.0", RoomSurface::Principled)});
}

TEST_F(Formats, AreConvertedToTheSameScene) {
  for (const std::string& path :
       {test::write_pbrt4_room(folder_.path()), test::write_tungsten_room(folder_.path()),
        test::write_mitsuba_room(folder_.path(), "3.0.0", RoomSurface::Principled),
        test::write_gltf_room(folder_.path())}) {
    Warnings warnings;
    const desc::SceneDesc scene = import_scene(path, warnings);
    const std::string copy = (folder_.path() / "copy" / "scene.pbrt").string();
    fs::create_directories(folder_.path() / "copy");
    write_pbrt(scene, copy);
    EXPECT_EQ(desc::hash(import_scene(copy, warnings)), desc::hash(scene)) << path;
    EXPECT_EQ(warnings.count(), 0U) << path;
  }
}

/// pbrt opens no JPEG: it is written as PNG, with the same bits.
TEST_F(Formats, AreConvertedWithTheImagesInside) {
  Warnings warnings;
  const std::string room = test::write_glb_room(folder_.path());
  const desc::SceneDesc scene = import_scene(room, warnings);
  ASSERT_EQ(scene.embedded_files.size(), 1U);
  const fs::path copy = folder_.path() / "copy.pbrt";
  write_pbrt(scene, copy.string());
  EXPECT_EQ(warnings.count(), 0U);
  const std::vector<float> picture = render(room, 1, 16).image();
  fs::remove(room);
  EXPECT_EQ(render(copy.string(), 1, 16).image(), picture);
}

/// Scenes that others made, in more than one format.
struct SharedPair {
  const char* first;
  const char* second;
};
void PrintTo(const SharedPair& pair, std::ostream* out) { *out << pair.second; }

class SharedFormats : public ::testing::TestWithParam<SharedPair> {};

TEST_P(SharedFormats, AreTheSamePicture) {
  const fs::path first = shared_scenes_folder() / GetParam().first;
  const fs::path second = shared_scenes_folder() / GetParam().second;
  if (!fs::exists(first)) GTEST_SKIP() << kNoSharedScenes;
  const test::Render a = render(first.string(), 1, 48, true);
  const test::Render b = render(second.string(), 2, 48, true);
  test::expect_same(test::replicates_of(b), test::replicates_of(a), *b.film, 0.3,
                    GetParam().second);
}

INSTANTIATE_TEST_SUITE_P(
    All, SharedFormats,
    ::testing::Values(SharedPair{"cornell-box/pbrt/scene.pbrt", "cornell-box/scene.xml"},
                      SharedPair{"cornell-box/pbrt/scene.pbrt", "cornell-box/scene-mitsuba3.xml"},
                      SharedPair{"veach-mis/pbrt/scene.pbrt", "veach-mis/pbrt/scene-v4.pbrt"},
                      // Metals of these scenes reflect 0.3 of those of the pbrt files.
                      SharedPair{"veach-mis/scene.xml", "veach-mis/scene-mitsuba3.xml"}));

}  // namespace
}  // namespace ajar
