// The scenes that others made, if they are here: AJAR_SHARED names the folder.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "import/import.h"
#include "import/pbrt/pbrt_writer.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

fs::path scenes_folder() {
  // Nothing in the tests changes the environment.
  const char* shared = std::getenv("AJAR_SHARED");  // NOLINT(concurrency-mt-unsafe)
  if (shared != nullptr) return fs::path(shared) / "scenes";
#ifdef AJAR_SOURCE_DIR
  return fs::path(AJAR_SOURCE_DIR) / "../shared/scenes";
#else
  return "../shared/scenes";
#endif
}

struct Expected {
  const char* file;
  std::size_t shapes;
  std::size_t lights;  ///< area lights included
};
void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.file; }

class SharedScene : public testing::TestWithParam<Expected> {
 protected:
  void SetUp() override {
    if (!fs::exists(scenes_folder()))
      GTEST_SKIP() << "no shared scenes; set AJAR_SHARED to their folder";
  }
};

TEST_P(SharedScene, LoadsWithoutWarningsThatMatterAndSurvivesWriting) {
  Warnings warnings;
  const desc::SceneDesc scene =
      import_scene((scenes_folder() / GetParam().file).string(), warnings);
  for (const std::string& message : warnings.messages()) {
    // Two meshes of staircase2 come with many triangles of three equal corners.
    EXPECT_NE(message.find("triangles have no area"), std::string::npos) << message;
  }
  EXPECT_EQ(scene.shapes.size(), GetParam().shapes);
  std::size_t lights = scene.lights.size();
  for (const desc::Shape& shape : scene.shapes) lights += shape.emission ? 1 : 0;
  EXPECT_EQ(lights, GetParam().lights);

  std::string pattern = (fs::temp_directory_path() / "ajar_shared_XXXXXX").string();
  const fs::path folder = mkdtemp(pattern.data());
  write_pbrt(scene, (folder / "copy.pbrt").string());
  Warnings of_copy;
  EXPECT_EQ(desc::hash(import_scene((folder / "copy.pbrt").string(), of_copy)), desc::hash(scene));
  EXPECT_EQ(of_copy.count(), 0U);
  fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(
    All, SharedScene,
    testing::Values(
        Expected{"cornell-box/pbrt/scene.pbrt", 8, 1},
        Expected{"veach-bidir/pbrt/scene.pbrt", 14, 2}, Expected{"veach-mis/pbrt/scene.pbrt", 9, 3},
        Expected{"staircase2/pbrt/scene.pbrt", 32, 13}, Expected{"water-caustic/scene.pbrt", 10, 1},
        Expected{"teapot-full/scene.pbrt", 5, 1}, Expected{"caustic-glass/f16-9a.pbrt", 2, 2},
        Expected{"caustic-glass/f16-9b.pbrt", 2, 2}, Expected{"caustic-glass/f16-9c.pbrt", 2, 2},
        Expected{"caustic-glass/f16-11a.pbrt", 2, 2}, Expected{"caustic-glass/f16-11b.pbrt", 2, 2},
        Expected{"caustic-glass/glass.pbrt", 2, 2}, Expected{"volume-caustic/caustic.pbrt", 3, 2},
        Expected{"volume-caustic/f16-22a.pbrt", 3, 2},
        Expected{"volume-caustic/f16-22b.pbrt", 3, 2}));

class SharedMesh : public testing::TestWithParam<const char*> {};

TEST_P(SharedMesh, OpensBareInAStudio) {
  const fs::path file = scenes_folder() / GetParam();
  if (!fs::exists(file)) GTEST_SKIP() << "no shared scenes; set AJAR_SHARED to their folder";
  Warnings warnings;
  const desc::SceneDesc scene = import_scene(file.string(), warnings);
  for (const std::string& message : warnings.messages()) {
    const bool is_expected = message.find("cannot read these materials") != std::string::npos ||
                             message.find("unknown material") != std::string::npos;
    EXPECT_TRUE(is_expected) << message;
  }
  ASSERT_EQ(scene.shapes.size(), 4U) << "the mesh, two softboxes and the table";
  EXPECT_GT(scene.shapes.front().node.mesh("mesh")->indices.size(), 100U);
  EXPECT_EQ(scene.lights.size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(All, SharedMesh,
                         testing::Values("cbox-with-bulb/meshes/bulb_shell.obj",
                                         "veach-bidir/models/Mesh002.obj",
                                         "teapot-full/models/Mesh001.ply",
                                         "water-caustic/models/Mesh001.ply"));

TEST(SharedScenes, OfPbrt4SaySo) {
  if (!fs::exists(scenes_folder()))
    GTEST_SKIP() << "no shared scenes; set AJAR_SHARED to their folder";
  for (const char* file : {"veach-bidir/pbrt/scene-v4.pbrt", "veach-mis/pbrt/scene-v4.pbrt",
                           "staircase2/pbrt/scene-v4.pbrt", "water-caustic/scene-v4.pbrt"}) {
    Warnings warnings;
    try {
      import_scene((scenes_folder() / file).string(), warnings);
      ADD_FAILURE() << file << " loads";
    } catch (const SceneError& error) {
      EXPECT_NE(std::string(error.what()).find("pbrt-v4"), std::string::npos) << error.what();
    }
  }
}

TEST(ImportScene, RefusesUnknownKindsOfFiles) {
  Warnings warnings;
  try {
    import_scene("scene.blend", warnings);
    ADD_FAILURE();
  } catch (const SceneError& error) {
    EXPECT_EQ(
        std::string(error.what()).rfind("scene.blend: unknown kind of scene file \".blend\"", 0),
        0U)
        << error.what();
  }
  EXPECT_THROW(import_scene("does-not-exist.pbrt", warnings), IoError);
}

}  // namespace
}  // namespace ajar
