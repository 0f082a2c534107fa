// Meshes alone whose pictures are known in closed form: units, sides, directions, colours. A camera
// and a light of the test take the place of the studio.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "import/import.h"
#include "scene/desc/models.h"
#include "support/tiny_picture.h"

namespace ajar {
namespace {

using test::CodedGray;
using test::expect_color;
using test::FourColors;
using test::TinyPicture;

enum class MeshLight { None, EvenSky };

/// Where the camera of `mesh_picture` is on the axis z, from where it sees a width of 2 of z = 0.
enum class MeshView { Front, Back };

struct MeshStage {
  MeshLight light = MeshLight::None;
  MeshView view = MeshView::Front;
  /// Makes the mesh shine with its base color, from its front alone: so sides and colours show.
  bool shines = false;
};

/// Picture of a mesh in the file `name`, which is one of `files`. Images beside it are in the
/// folder of `image`, if there is one.
TinyPicture mesh_picture(const std::string& name, const std::map<std::string, std::string>& files,
                         const MeshStage& stage, int samples = 1, const std::string& image = {}) {
  const std::filesystem::path folder =
      image.empty() ? "/nonexistent" : std::filesystem::path(image).parent_path();
  const auto provider = [&](const std::string& path) -> std::optional<std::string_view> {
    const std::filesystem::path asked(path);
    const auto found = files.find(asked.filename().string());
    if (asked.parent_path() != folder || found == files.end()) return std::nullopt;
    return found->second;
  };
  return test::picture_of(
      [&](Warnings& warnings) {
        desc::SceneDesc scene = import_scene((folder / name).string(), warnings, provider);
        // The first shape is the mesh; the studio is behind it.
        scene.shapes.resize(1);
        scene.lights.clear();
        if (stage.light == MeshLight::EvenSky) {
          scene.lights.push_back(
              {{}, Mat4(), desc::light_node("environment", {{"radiance", Vec3(1.F)}})});
        }
        if (stage.shines) {
          const auto id = static_cast<std::size_t>(scene.shapes[0].material);
          scene.shapes[0].emission = desc::Emission{
              {},
              desc::emission_node("area",
                                  {{"radiance", scene.materials.at(id).node.get("base_color")}})};
          // Emission alone.
          scene.materials[id].node = desc::material_node("diffuse", {{"reflectance", Vec3(0.F)}});
        }
        // Texels as squares.
        for (desc::Texture& texture : scene.textures) {
          if (texture.node.is("image")) texture.node.set("filter", std::string("nearest"));
        }
        constexpr double kDistance = 20.0;
        const double side = stage.view == MeshView::Front ? 1.0 : -1.0;
        desc::PerspectiveCamera camera;
        camera.fov = static_cast<float>(2.0 * std::atan(1.0 / kDistance) * 180.0 / M_PI);
        scene.camera.node = camera;
        scene.camera.to_world =
            Mat4(side, 0, 0, 0, 0, 1, 0, 0, 0, 0, -side, 0, 0, 0, side * kDistance, 1);
        scene.film.resolution = Vec2i(16, 16);
        scene.film.filter = {};
        return scene;
      },
      samples);
}

/// A square of 2 × 2 that faces +z, images upright on it.
const std::string kUprightSquare =
    "mtllib a.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
    "vt 0 1\nf 1/1 2/2 3/3 4/4\n";

/// The square with a material.
TinyPicture obj_picture(const std::string& material, const MeshStage& stage, int samples = 1,
                        const std::string& image = {}) {
  return mesh_picture("a.obj", {{"a.obj", kUprightSquare}, {"a.mtl", "newmtl m\n" + material}},
                      stage, samples, image);
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

TEST(MeshScenes, KeIsRadianceOfTheFront) {
  const std::string lamp = "Kd 0 0 0\nKe 1 2 3\n";
  expect_color(obj_picture(lamp, {}).mean(), {1, 2, 3});
  EXPECT_LT(obj_picture(lamp, {.view = MeshView::Back}).mean().x, 1e-6F);
}

TEST(MeshScenes, KdIsTheShareThatBothSidesReflect) {
  for (const MeshView view : {MeshView::Front, MeshView::Back}) {
    expect_color(
        obj_picture("Kd .25 .5 .75\n", {.light = MeshLight::EvenSky, .view = view}, 64).mean(),
        {0.25F, 0.5F, 0.75F}, 0.01F);
  }
}

TEST(MeshScenes, ImagesOfObjRiseAlongV) {
  const FourColors image;
  const std::string lamp = "Kd 0 0 0\nKe 1 1 1\nmap_Ke " + file_name(image.path()) + "\n";
  test::expect_four_colors(obj_picture(lamp, {}, 1, image.path()));
}

TEST(MeshScenes, ColorsOfImagesAreDecodedAndFactorsAreLinear) {
  const CodedGray image(188);
  const std::string name = file_name(image.path());
  expect_color(
      obj_picture("Kd 0 0 0\nKe .5 1 2\nmap_Ke " + name + "\n", {}, 1, image.path()).mean(),
      Vec3(0.5F, 1.F, 2.F) * image.decoded());
  expect_color(obj_picture("Kd .5 1 1\nmap_Kd " + name + "\n", {.light = MeshLight::EvenSky}, 64,
                           image.path())
                   .mean(),
               Vec3(0.5F, 1.F, 1.F) * image.decoded(), 0.01F);
}

TEST(MeshScenes, DissolveIsOpacity) {
  // Black before a sky.
  expect_color(obj_picture("Kd 0 0 0\nd .25\n", {.light = MeshLight::EvenSky}, 1024).mean(),
               Vec3(0.75F), 0.02F);
}

/// The square as a PLY file with texture coordinates, whose names are `s t`.
std::string ply_square(const std::string& comment) {
  return "ply\nformat ascii 1.0\n" + comment +
         "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
         "property float s\nproperty float t\nelement face 1\n"
         "property list uchar int vertex_indices\nend_header\n"
         "-1 -1 0 0 0\n1 -1 0 1 0\n1 1 0 1 1\n-1 1 0 0 1\n4 0 1 2 3\n";
}

TEST(MeshScenes, ImagesOfPlyRiseAlongVOnTheSideOfTheWinding) {
  const FourColors image;
  const std::map<std::string, std::string> files = {
      {"a.ply", ply_square("comment TextureFile " + file_name(image.path()) + "\n")}};
  test::expect_four_colors(mesh_picture("a.ply", files, {.shines = true}, 1, image.path()));
  EXPECT_LT(mesh_picture("a.ply", files, {.view = MeshView::Back, .shines = true}, 1, image.path())
                .mean()
                .x,
            1e-6F);
}

/// The bytes of a triangle of a binary STL file, with a colour as VisCAM writes it.
std::string stl_triangle(std::initializer_list<float> corners, std::uint16_t color) {
  std::string bytes(12, '\0');  // a normal, which is not read
  for (const float number : corners) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
  }
  return bytes.append(reinterpret_cast<const char*>(&color), sizeof(color));
}

TEST(MeshScenes, ColorsOfStlAreThoseOfADisplayOnTheSideOfTheWinding) {
  // Seen from +z: the camera of the test does not care which axis is up.
  constexpr std::uint16_t kCounts = 1U << 15U;
  const std::uint16_t gray = kCounts | 15U << 10U | 15U << 5U | 15U;
  const std::uint16_t red = kCounts | 31U << 10U;
  std::string bytes(80, ' ');
  const std::uint32_t count = 2;
  bytes.append(reinterpret_cast<const char*>(&count), sizeof(count));
  bytes += stl_triangle({-1, -1, 0, 1, -1, 0, -1, 1, 0}, gray);
  bytes += stl_triangle({1, -1, 0, 1, 1, 0, -1, 1, 0}, red);
  const TinyPicture picture = mesh_picture("a.stl", {{"a.stl", bytes}}, {.shines = true});
  const float coded = 15.F / 31.F;
  expect_color(picture.lower_left(), Vec3(std::pow((coded + 0.055F) / 1.055F, 2.4F)), 0.01F);
  expect_color(picture.upper_right(), {1, 0, 0}, 0.01F);
  EXPECT_LT(
      mesh_picture("a.stl", {{"a.stl", bytes}}, {.view = MeshView::Back, .shines = true}).mean().x,
      1e-6F);
}

}  // namespace
}  // namespace ajar
