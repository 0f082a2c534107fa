// The scenes that others made for Mitsuba, if they are here: AJAR_SHARED names the folder.
#include <gtest/gtest.h>

#include <filesystem>

#include "import/import.h"
#include "import/pbrt/pbrt_writer.h"
#include "import/shared_scenes_test_support.h"
#include "import/testing/temporary_folder.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

struct Expected {
  const char* file;
  std::size_t shapes;
  std::size_t lights;  ///< area lights included
  std::size_t warnings;
  /// Number of those with more than a slight effect.
  std::size_t that_matter = 0;
};
void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.file; }

class SharedMitsubaScene : public ::testing::TestWithParam<Expected> {};

TEST_P(SharedMitsubaScene, LoadsAndSurvivesWriting) {
  if (!fs::exists(shared_scenes_folder())) GTEST_SKIP() << kNoSharedScenes;
  const Expected& expected = GetParam();
  Warnings warnings;
  const desc::SceneDesc scene =
      import_scene((shared_scenes_folder() / expected.file).string(), warnings);
  EXPECT_EQ(scene.shapes.size(), expected.shapes);
  std::size_t lights = scene.lights.size();
  for (const desc::Shape& shape : scene.shapes) lights += shape.emission ? 1 : 0;
  EXPECT_EQ(lights, expected.lights);
  EXPECT_EQ(warnings.count() + scene.warnings_if_seen.size(), expected.warnings);
  EXPECT_EQ(warnings.count(Effect::Light) + warnings.count(Effect::Geometry) +
                warnings.count(Effect::Surface),
            expected.that_matter);

  const TemporaryFolder folder;
  write_pbrt(scene, (folder.path() / "copy.pbrt").string());
  Warnings of_copy;
  EXPECT_EQ(desc::hash(import_scene((folder.path() / "copy.pbrt").string(), of_copy)),
            desc::hash(scene));
  EXPECT_EQ(of_copy.count(), 0U);
}

INSTANTIATE_TEST_SUITE_P(All, SharedMitsubaScene,
                         ::testing::Values(Expected{"cornell-box/scene.xml", 8, 1, 8},
                                           Expected{"cornell-box/scene-mitsuba3.xml", 8, 1, 1},
                                           Expected{"veach-bidir/scene.xml", 14, 2, 7},
                                           Expected{"veach-bidir/scene-mitsuba3.xml", 14, 2, 1},
                                           Expected{"veach-mis/scene.xml", 9, 3, 5},
                                           Expected{"veach-mis/scene-mitsuba3.xml", 9, 3, 1},
                                           Expected{"staircase2/scene.xml", 32, 13, 2},
                                           Expected{"water-caustic/scene.xml", 10, 1, 12},
                                           Expected{"volumetric-caustic/scene.xml", 8, 1, 10},
                                           Expected{"cbox-with-bulb/scene-nosphere.xml", 9, 1, 9},
                                           // A mesh is not there.
                                           Expected{"cbox-with-bulb/scene.xml", 9, 1, 10, 1},
                                           Expected{"cbox-with-bulb/simple.xml", 9, 1, 11, 1},
                                           Expected{"sms-ring/ring.xml", 3, 1, 5},
                                           Expected{"sms-ring/ring_notebook_simple.xml", 3, 1, 3},
                                           Expected{"sms-ring/ring_notebook_normalmapped.xml", 3, 1,
                                                    3},
                                           Expected{"sms-ring/ring_paths.xml", 9, 7, 2}));

}  // namespace
}  // namespace ajar
