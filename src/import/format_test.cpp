#include "import/format.h"

#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "import/testing/import_checks.h"
#include "import/testing/temporary_folder.h"
#include "scene/desc/models.h"
#include "scene/testing/another_value.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

TEST(Formats, AreRecognisedByTheirExtensions) {
  ASSERT_FALSE(formats().empty());
  std::set<std::string> names;
  std::set<std::string> extensions;
  for (const Format& format : formats()) {
    EXPECT_TRUE(names.insert(format.name).second) << format.name;
    EXPECT_FALSE(format.summary.empty()) << format.name;
    EXPECT_NE(format.read, nullptr) << format.name;
    ASSERT_FALSE(format.extensions.empty()) << format.name;
    for (const std::string& extension : format.extensions) {
      EXPECT_TRUE(extensions.insert(extension).second) << extension;
      EXPECT_EQ(&format_of("A.B/scene" + extension), &format);
      if (format.write != nullptr) {
        EXPECT_EQ(&format_to_write("scene" + extension), &format);
      }
      EXPECT_EQ(contains(writable_formats(), extension), format.write != nullptr);
    }
  }
}

TEST(Formats, MessagesListTheExtensionsAndNameTheNearest) {
  const auto written_one = std::find_if(formats().begin(), formats().end(),
                                        [](const Format& one) { return one.write != nullptr; });
  ASSERT_NE(written_one, formats().end());
  const std::string usual = written_one->extensions.front();
  const std::string mistyped = usual.substr(0, usual.size() - 1);
  std::string read;
  std::string written;
  try {
    format_of("room" + mistyped);
  } catch (const SceneError& error) {
    read = error.what();
  }
  try {
    format_to_write("room" + mistyped);
  } catch (const UsageError& error) {
    written = error.what();
  }
  EXPECT_TRUE(contains(read, "room" + mistyped + ": ")) << read;
  try {
    format_to_write("room");
    ADD_FAILURE() << "has no extension";
  } catch (const UsageError& error) {
    EXPECT_TRUE(contains(error.what(), "no extension")) << error.what();
  }
  for (const std::string& message : {read, written}) {
    EXPECT_TRUE(contains(message, "unknown kind of scene file")) << message;
    EXPECT_TRUE(contains(message, "did you mean \"" + usual + "\"?")) << message;
  }
  for (const Format& format : formats()) {
    for (const std::string& extension : format.extensions) {
      EXPECT_TRUE(contains(read, extension)) << read;
      EXPECT_EQ(contains(written, extension), format.write != nullptr) << written;
    }
  }
}

/// A textured mesh that shines, a quadric, a lamp.
desc::SceneDesc small_scene() {
  desc::SceneDesc scene;
  scene.textures.emplace_back().node = desc::texture_node("checkerboard");
  scene.materials.emplace_back().node =
      desc::material_node("diffuse", {{"reflectance", desc::TextureRef{0}}});
  scene.materials.emplace_back().node = desc::material_node("mirror");
  scene.shapes.emplace_back().node = desc::shape_node("sphere", {{"radius", 0.3F}});
  scene.shapes.back().material = 1;
  const desc::Model& mesh = *desc::find_model(desc::ModelKind::Shape, "mesh");
  scene.shapes.emplace_back().node =
      desc::mesh_node(std::get<desc::MeshPointer>(testing::another_value(mesh.parameters.front())));
  scene.shapes.back().material = 0;
  scene.shapes.back().to_world.setTranslation(Vec3d(1.0, 2.0, 0.1));
  scene.shapes.back().emission = desc::Emission{{}, desc::emission_node("area")};
  scene.lights.emplace_back().node = desc::light_node("spot", {{"intensity", Vec3(1, 2, 3)}});
  scene.film.resolution = Vec2i(64, 48);
  return scene;
}

TEST(Formats, RoundTripTheSameScene) {
  const TemporaryFolder folder;
  const desc::SceneDesc scene = small_scene();
  for (const Format& format : formats()) {
    if (format.write == nullptr) continue;
    const std::string file = (folder.path() / ("scene" + format.extensions.front())).string();
    format.write(scene, file);
    Warnings warnings;
    const desc::SceneDesc back = format.read(file, warnings, {});
    EXPECT_EQ(warnings.count(), 0U) << format.name;
    EXPECT_EQ(desc::hash(back), desc::hash(scene)) << format.name;
    EXPECT_TRUE(back.files.contains(file)) << format.name;
  }
}

}  // namespace
}  // namespace ajar
