// The scenes that others made, if they are here: AJAR_SHARED names the folder.
#include <gtest/gtest.h>

#include <filesystem>

#include "import/format.h"
#include "import/import.h"
#include "import/pbrt/pbrt_writer.h"
#include "import/shared_scenes_test_support.h"
#include "import/testing/temporary_folder.h"
#include "scene/desc/models.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

struct Expected {
  const char* file;
  std::size_t shapes;
  std::size_t lights;  ///< area lights included
};
void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.file; }

class SharedScene : public ::testing::TestWithParam<Expected> {
 protected:
  void SetUp() override {
    if (!fs::exists(shared_scenes_folder())) GTEST_SKIP() << kNoSharedScenes;
  }
};

TEST_P(SharedScene, LoadsWithoutWarningsThatMatterAndSurvivesWriting) {
  Warnings warnings;
  const desc::SceneDesc scene =
      import_scene((shared_scenes_folder() / GetParam().file).string(), warnings);
  for (const std::string& message : warnings.messages()) {
    // Two meshes of staircase2 come with many triangles of three equal corners.
    EXPECT_NE(message.find("triangles have no area"), std::string::npos) << message;
  }
  EXPECT_EQ(scene.shapes.size(), GetParam().shapes);
  std::size_t lights = scene.lights.size();
  for (const desc::Shape& shape : scene.shapes) lights += shape.emission ? 1 : 0;
  EXPECT_EQ(lights, GetParam().lights);

  const TemporaryFolder folder;
  write_pbrt(scene, (folder.path() / "copy.pbrt").string());
  Warnings of_copy;
  EXPECT_EQ(desc::hash(import_scene((folder.path() / "copy.pbrt").string(), of_copy)),
            desc::hash(scene));
  EXPECT_EQ(of_copy.count(), 0U);
}

INSTANTIATE_TEST_SUITE_P(
    All, SharedScene,
    ::testing::Values(
        Expected{"cornell-box/pbrt/scene.pbrt", 8, 1},
        Expected{"veach-bidir/pbrt/scene.pbrt", 14, 2},
        Expected{"veach-bidir/pbrt/scene-v4.pbrt", 14, 2},
        Expected{"veach-mis/pbrt/scene-v4.pbrt", 9, 3},
        Expected{"staircase2/pbrt/scene-v4.pbrt", 32, 13},
        Expected{"water-caustic/scene-v4.pbrt", 10, 1}, Expected{"veach-mis/pbrt/scene.pbrt", 9, 3},
        Expected{"staircase2/pbrt/scene.pbrt", 32, 13}, Expected{"water-caustic/scene.pbrt", 10, 1},
        Expected{"teapot-full/scene.pbrt", 5, 1}, Expected{"caustic-glass/f16-9a.pbrt", 2, 2},
        Expected{"caustic-glass/f16-9b.pbrt", 2, 2}, Expected{"caustic-glass/f16-9c.pbrt", 2, 2},
        Expected{"caustic-glass/f16-11a.pbrt", 2, 2}, Expected{"caustic-glass/f16-11b.pbrt", 2, 2},
        Expected{"caustic-glass/glass.pbrt", 2, 2}, Expected{"volume-caustic/caustic.pbrt", 3, 2},
        Expected{"volume-caustic/f16-22a.pbrt", 3, 2},
        Expected{"volume-caustic/f16-22b.pbrt", 3, 2}));

class SharedMesh : public ::testing::TestWithParam<const char*> {};

TEST_P(SharedMesh, OpensBareInAStudio) {
  const fs::path file = shared_scenes_folder() / GetParam();
  if (!fs::exists(file)) GTEST_SKIP() << kNoSharedScenes;
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
                         ::testing::Values("cbox-with-bulb/meshes/bulb_shell.obj",
                                           "veach-bidir/models/Mesh002.obj",
                                           "teapot-full/models/Mesh001.ply",
                                           "water-caustic/models/Mesh001.ply"));

TEST(SharedScenes, LoadInEitherVersion) {
  if (!fs::exists(shared_scenes_folder())) GTEST_SKIP() << kNoSharedScenes;
  int loaded = 0;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(shared_scenes_folder())) {
    if (entry.path().extension() != ".pbrt") continue;
    Warnings warnings;
    EXPECT_NO_THROW(import_scene(entry.path().string(), warnings)) << entry.path();
    ++loaded;
  }
  EXPECT_GT(loaded, 0);
}

/// Without the parts that differ between the two versions of a scene: coats, and the name of the
/// picture.
desc::SceneDesc without_version(desc::SceneDesc scene) {
  for (desc::Material& material : scene.materials) {
    if (material.node.is("coated_diffuse")) material.node = desc::material_node("mirror");
  }
  scene.film.filename.clear();
  return scene;
}

TEST(SharedScenes, OfBothVersionsAreTheSame) {
  if (!fs::exists(shared_scenes_folder())) GTEST_SKIP() << kNoSharedScenes;
  for (const char* folder :
       {"veach-bidir/pbrt", "veach-mis/pbrt", "staircase2/pbrt", "water-caustic"}) {
    Warnings warnings;
    const auto hash_of = [&](const char* file) {
      return desc::hash(without_version(
          import_scene((shared_scenes_folder() / folder / file).string(), warnings)));
    };
    EXPECT_EQ(hash_of("scene.pbrt"), hash_of("scene-v4.pbrt")) << folder;
  }
}

TEST(ImportScene, RefusesUnknownKindsOfFiles) {
  Warnings warnings;
  try {
    import_scene("scene.blend", warnings);
    ADD_FAILURE();
  } catch (const SceneError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find("scene.blend: unknown kind of scene file \".blend\". Valid: "), 0U)
        << message;
    for (const Format& format : formats()) {
      for (const std::string& extension : format.extensions) {
        EXPECT_NE(message.find(extension), std::string::npos) << message;
      }
    }
  }
  EXPECT_THROW(import_scene("does-not-exist.pbrt", warnings), IoError);
}

}  // namespace
}  // namespace ajar
