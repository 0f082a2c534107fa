#include <gtest/gtest.h>

#include <fstream>
#include <optional>

#include "import/import.h"
#include "import/testing/import_checks.h"
#include "import/testing/temporary_folder.h"

namespace ajar::ply {
namespace {

/// A triangle whose header has `remarks`, with texture coordinates and colours or without.
std::string file_with(const std::string& remarks, bool has_uvs = true, bool has_colors = false) {
  const std::string uvs = has_uvs ? "property float s\nproperty float t\n" : "";
  const std::string colors =
      has_colors ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "";
  const std::string rest = std::string(has_uvs ? " 0 1" : "") + (has_colors ? " 9 9 9" : "") + "\n";
  return "ply\nformat ascii 1.0\n" + remarks +
         "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n" + uvs + colors +
         "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0" + rest +
         "1 0 0" + rest + "0 1 0" + rest + "3 0 1 2\n";
}

class PlyImages : public ::testing::Test {
 protected:
  PlyImages() { std::ofstream(folder_.path() / "a cat.png") << "an image"; }
  desc::SceneDesc scene_of(const std::string& text) {
    const std::string path = (folder_.path() / "m.ply").string();
    std::ofstream(path) << text;
    warnings_.emplace();
    return import_scene(path, *warnings_);
  }
  static bool has_image(const desc::SceneDesc& scene) {
    const auto material = static_cast<std::size_t>(scene.shapes.at(0).material);
    return std::holds_alternative<desc::TextureRef>(
        scene.materials.at(material).node.get("base_color"));
  }
  TemporaryFolder folder_;
  std::optional<Warnings> warnings_;  ///< warnings of the last scene
};

TEST_F(PlyImages, OfTheHeaderAreOnTheMesh) {
  const desc::SceneDesc scene = scene_of(file_with("comment TextureFile a cat.png \n"));
  expect_none(*warnings_);
  ASSERT_TRUE(has_image(scene));
  EXPECT_EQ(scene.textures.at(0).node.text("file"), (folder_.path() / "a cat.png").string());
  EXPECT_TRUE(scene.textures[0].node.flag("decode_srgb"));
  EXPECT_TRUE(scene.files.contains((folder_.path() / "a cat.png").string()));
}

TEST_F(PlyImages, ForbiddenOnesAreWarningsWithTheirLine) {
  const auto remark_on = [&](const std::string& text) {
    EXPECT_FALSE(has_image(scene_of(text)));
    return lines_of(*warnings_);
  };
  EXPECT_TRUE(contains(remark_on(file_with("comment TextureFile dog.png\n")),
                       "m.ply:3: this image is left out: there is no \"dog.png\""))
      << lines_of(*warnings_);
  EXPECT_TRUE(contains(remark_on(file_with("comment TextureFile ../dog.png\n")),
                       "m.ply:3: this image is left out: "))
      << lines_of(*warnings_);
  EXPECT_TRUE(contains(remark_on(file_with("comment TextureFile a cat.png\n", false)),
                       "the vertices have no texture coordinates"));
}

TEST_F(PlyImages, TakePrecedenceOverOthersAndColours) {
  const desc::SceneDesc scene = scene_of(file_with(
      "comment a\ncomment TextureFile a cat.png\ncomment TextureFile b.png\n", true, true));
  EXPECT_TRUE(has_image(scene));
  EXPECT_TRUE(contains(lines_of(*warnings_), "m.ply:4: the mesh has more images than one"));
  EXPECT_TRUE(contains(lines_of(*warnings_), "m.ply:4: the image counts: the colours"));
}

}  // namespace
}  // namespace ajar::ply
