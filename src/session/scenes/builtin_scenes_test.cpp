#include "session/scenes/builtin_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "session/scenes/scene_file.h"

namespace ajar {
namespace {

TEST(BuiltinScenes, AreByteForByteTheFilesOfTheRepository) {
  ASSERT_FALSE(embedded_files().empty());
  for (const EmbeddedFile& file : embedded_files()) {
    const std::string path = std::string(AJAR_SOURCE_DIR) + "/scenes/" + std::string(file.scene) +
                             "/" + std::string(file.path);
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream content;
    content << stream.rdbuf();
    EXPECT_TRUE(content.str() == file.bytes) << path;
  }
}

TEST(BuiltinScenes, HaveASummary) {
  const std::vector<std::string> names = builtin_scene_names();
  EXPECT_TRUE(std::find(names.begin(), names.end(), "cornell") != names.end());
  for (const std::string& name : names) {
    const std::string summary = builtin_scene_summary(name);
    EXPECT_GT(summary.size(), 10U) << name;
    EXPECT_LT(summary.size(), 160U) << summary;
    EXPECT_EQ(summary.find(name + ":"), std::string::npos) << summary;
  }
}

TEST(BuiltinScenes, FilesAreFoundByAnySpellingOfTheirPath) {
  const auto bytes = builtin_file("cornell", "scene.pbrt");
  ASSERT_TRUE(bytes.has_value());
  EXPECT_EQ(builtin_file("cornell", "./scene.pbrt"), bytes);
  EXPECT_EQ(builtin_file("cornell", "meshes/../scene.pbrt"), bytes);
  EXPECT_EQ(builtin_file("cornell", "builtin:cornell/scene.pbrt"), bytes);
  EXPECT_FALSE(builtin_file("cornell", "absent.ply").has_value());
  EXPECT_FALSE(builtin_file("absent", "scene.pbrt").has_value());
}

TEST(SceneStem, NamesPicturesAfterTheScene) {
  EXPECT_EQ(scene_stem("builtin:cornell"), "cornell");
  EXPECT_EQ(scene_stem("/scenes/room.pbrt"), "room");
  EXPECT_EQ(scene_stem("/scenes/kitchen/scene.pbrt"), "kitchen");
}

TEST(LoadScene, BuiltinScenesLeaveTheMethodToTheProgram) {
  Warnings warnings;
  for (const std::string& name : builtin_scene_names()) {
    const desc::SceneDesc scene = load_scene("builtin:" + name, warnings);
    EXPECT_EQ(scene.hints.integrator, "") << name;
    EXPECT_GT(scene.hints.max_depth.value_or(0), 10) << name;
  }
}

TEST(LoadScene, SaysWhatIsWrongWithTheName) {
  Warnings warnings;
  EXPECT_THROW(load_scene("builtin:cornel", warnings), UsageError);
  EXPECT_THROW(load_scene("/no/such/file.pbrt", warnings), IoError);
  EXPECT_THROW(load_scene("/", warnings), IoError);
}

}  // namespace
}  // namespace ajar
