#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "import/pbrt/pbrt_import.h"
#include "scene/testing/transforms.h"
#include "session/scenes/scene_file.h"
#include "support/methods.h"
#include "support/render.h"
#include "support/small_scenes.h"

/// No length is built in: a scene of any size has the same picture.
namespace ajar::test {
namespace {

/// Scales the scene by `size`, with equal lighting.
void scale(desc::SceneDesc& scene, double size) {
  const Mat4 larger = testing::scaling(size, size, size);
  const auto factor = static_cast<float>(size);
  for (desc::Shape& shape : scene.shapes) shape.to_world = shape.to_world * larger;
  for (desc::Instance& instance : scene.instances) instance.to_world = instance.to_world * larger;
  for (desc::Light& light : scene.lights) {
    light.to_world = light.to_world * larger;
    if (!light.node.has("intensity")) continue;
    light.node.set("intensity", light.node.color("intensity") * (factor * factor));
  }
  for (desc::Medium& medium : scene.media) {
    medium.sigma_a /= factor;
    medium.sigma_s /= factor;
    if (medium.density) medium.density->to_world = medium.density->to_world * larger;
  }
  scene.camera.to_world = scene.camera.to_world * larger;
}

std::vector<float> picture(desc::SceneDesc description, const std::string& method, int samples) {
  Warnings warnings;
  const Scene scene(std::move(description), BuildOptions{Vec2i(16, 12)}, warnings);
  return render(scene, {.integrator = method, .samples = samples, .replicates = 2, .max_depth = 8})
      .image();
}

/// Lengths that differ by a power of two have the same digits, so not a bit of a picture differs.
void expect_same_bits(const desc::SceneDesc& scene, const std::string& method) {
  const std::vector<float> usual = picture(scene, method, 4);
  for (const double size : {0x1p-13, 0x1p-3, 0x1p16}) {
    desc::SceneDesc scaled = scene;
    scale(scaled, size);
    EXPECT_EQ(picture(std::move(scaled), method, 4), usual) << method << " at " << size;
  }
}

desc::SceneDesc small_desc(const std::string& name) {
  Warnings warnings;
  return import_pbrt_text(small_scene(name).text, "test.pbrt", ".", warnings);
}

TEST(ScaledScenes, HaveTheSameBitsAtPowersOfTwo) {
  for (const SmallScene& scene : small_scenes()) {
    SCOPED_TRACE(scene.name);
    expect_same_bits(small_desc(scene.name), "bdpt");
  }
}

TEST(ScaledScenes, HaveTheSameBitsByEveryMethod) {
  for (const std::string& method :
       methods_but({{"mlt", "logarithms of lengths have other digits"},
                    {"erpt", "logarithms of lengths have other digits"}})) {
    for (const char* const name : {"GlassAndMetal", "MilkBall"}) {
      SCOPED_TRACE(name);
      expect_same_bits(small_desc(name), method);
    }
  }
}

double mean_of(const std::string& text) {
  return render(*scene_from(text), {.samples = 64, .max_depth = 8}).mean();
}

/// A table under a square lamp, and objects on it: in files, each of its numbers is rounded.
std::string table(double size, double shift, const std::string& standing) {
  const auto numbers = [&](std::initializer_list<double> all) {
    std::string text;
    for (const double x : all) text += fmt::format("{:.17g} ", x * size);
    return text;
  };
  return fmt::format("LookAt {} Camera \"perspective\" \"float fov\" 42\n",
                     numbers({shift, 2, -6}) + numbers({shift, 0.6, 0}) + "0 1 0") +
         "Film \"image\" \"integer xresolution\" 32 \"integer yresolution\" 24\nWorldBegin\n" +
         fmt::format("Translate {} Scale {} {} {}\n", numbers({shift, 0, 0}), size, size, size) +
         R"(AttributeBegin Translate 0 3 0 Rotate 90 1 0 0 AreaLightSource "diffuse" "rgb L" [10 10 10]
Shape "trianglemesh" "point P" [-.5 -.5 0 .5 -.5 0 .5 .5 0 -.5 .5 0] "integer indices" [0 1 2 0 2 3]
AttributeEnd
Material "matte" "rgb Kd" [.5 .5 .5]
AttributeBegin Rotate 3 1 0 2
Shape "trianglemesh" "point P" [-3 0 -3 3 0 -3 3 0 3 -3 0 3] "integer indices" [0 1 2 0 2 3]
AttributeEnd
)" + standing +
         "\nWorldEnd\n";
}

std::vector<std::pair<std::string, std::string>> standing() {
  const std::string ball = "Translate 0 .7 0 Rotate 50 1 2 3 Shape ";
  return {
      {"nothing", ""},
      {"sphere", ball + "\"sphere\" \"float radius\" .7"},
      {"part of a sphere", ball + "\"sphere\" \"float radius\" .7 \"float phimax\" 250"},
      {"disk", ball + "\"disk\" \"float radius\" .9"},
      {"cylinder", ball + "\"cylinder\" \"float radius\" .5"},
      {"cone", ball + "\"cone\" \"float radius\" .5"},
      {"paraboloid", ball + "\"paraboloid\" \"float radius\" .5"},
      {"hyperboloid", ball + "\"hyperboloid\" \"point p1\" [.6 0 -.6] \"point p2\" [.4 .3 .6]"},
      {"glass", "Material \"glass\" " + ball + "\"sphere\" \"float radius\" .7"},
      {"flat curve",
       ball + "\"curve\" \"point P\" [-1 0 0 -.4 .5 0 .4 -.5 0 1 0 0] \"float width\" .4"},
      {"round curve", ball +
                          "\"curve\" \"string type\" \"cylinder\" \"point P\" [-1 0 0 -.4 .5 0 .4 "
                          "-.5 0 1 0 0] \"float width\" .4"},
      {"ribbon",
       ball + "\"curve\" \"string type\" \"ribbon\" \"normal N\" [0 0 1 0 .6 .8] \"point P\" "
              "[-1 0 0 -.4 .5 0 .4 -.5 0 1 0 0] \"float width\" .4"},
      {"subdivision",
       ball + "\"loopsubdiv\" \"integer levels\" 3 \"point P\" [.9 .9 .9 -.9 -.9 .9 -.9 "
              ".9 -.9 .9 -.9 -.9] \"integer indices\" [0 2 1 0 1 3 0 3 2 1 2 3]"},
      {"small instance", "ObjectBegin \"a\" Identity Scale 1000 1000 1000 " + ball +
                             "\"sphere\" \"float radius\" .7 ObjectEnd Scale .001 .001 .001 "
                             "ObjectInstance \"a\""},
      {"large instance of what is far from its own origin",
       "ObjectBegin \"a\" Identity Scale .001 .001 .001 Translate 5000 4000 3000 " + ball +
           "\"loopsubdiv\" \"integer levels\" 2 \"point P\" [.9 .9 .9 -.9 -.9 .9 -.9 .9 -.9 .9 -.9 "
           "-.9] \"integer indices\" [0 2 1 0 1 3 0 3 2 1 2 3] ObjectEnd Scale 1000 1000 1000 "
           "Translate -5 -4 -3 ObjectInstance \"a\""},
  };
}

TEST(ScaledScenes, AreEqualWithAnyContent) {
  for (const auto& [name, text] : standing()) {
    SCOPED_TRACE(name);
    const double usual = mean_of(table(1.0, 0.0, text));
    ASSERT_GT(usual, 0.02);
    // Numbers of paths are equal: differences are roundings, and edges that samples fall on.
    for (const double size : {1e-7, 1e-5, 1e-3, 1e3, 1e5}) {
      EXPECT_NEAR(mean_of(table(size, 0.0, text)) / usual, 1.0, 0.01) << size;
    }
    EXPECT_NEAR(mean_of(table(1e-3, 1e3, text)) / usual, 1.0, 0.01) << "far from the origin";
  }
}

TEST(ScaledScenes, TooSmallOnesForTrianglesGetAWarning) {
  const auto warnings_of = [](double size) {
    Warnings warnings;
    const Scene scene(import_pbrt_text(table(size, 0.0, ""), "test.pbrt", ".", warnings), {},
                      warnings);
    return warnings.messages();
  };
  EXPECT_TRUE(warnings_of(1e-8).empty());
  ASSERT_EQ(warnings_of(1e-9).size(), 1U);
  EXPECT_NE(warnings_of(1e-9).front().find("triangles lose digits; scale it up"),
            std::string::npos);
}

}  // namespace
}  // namespace ajar::test
