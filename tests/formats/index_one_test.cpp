#include <gtest/gtest.h>

#include "support/render.h"

/// Glass of the index around it reflects and bends nothing: there is no surface.
namespace ajar::test {
namespace {

std::string lamp_in(const std::string& shell) {
  return pbrt_scene("LookAt 0 1 -5 0 1 0 0 1 0 Camera \"perspective\"", 8, 6, shell + R"(
Material "matte" "rgb Kd" [.5 .5 .5]
AttributeBegin Rotate -90 1 0 0 Shape "disk" "float radius" 4 "float height" 0 AttributeEnd
AttributeBegin Translate 0 2 0
AreaLightSource "diffuse" "rgb L" [9 9 9] Shape "sphere" "float radius" .2
AttributeEnd
LightSource "point" "point from" [0 2.5 0] "rgb I" [3 3 3])");
}

TEST(GlassOfIndexOne, IsInvisible) {
  const std::string ball = " Translate 0 2 0 Shape \"sphere\" \"float radius\" 1 Translate 0 -2 0";
  const auto picture = [](const std::string& shell, const std::string& method) {
    // Lamp, floor, lens: paths of two edges, and no chance to meet a point.
    return render(*scene_from(lamp_in(shell)),
                  {.integrator = method, .samples = 16, .max_depth = 2})
        .mean();
  };
  for (const char* const method : {"pt", "bdpt"}) {
    const double usual = picture("", method);
    EXPECT_GT(usual, 0.0);
    for (const char* const glass : {"Material \"glass\" \"float eta\" 1",
                                    "Material \"glass\" \"float eta\" 1 \"float uroughness\" .2"}) {
      EXPECT_NEAR(picture(glass + ball, method), usual, 0.02 * usual) << method << ": " << glass;
    }
    EXPECT_LT(picture("Material \"glass\" \"float eta\" 1.01" + ball, method), 0.7 * usual);
    // A filter is a surface.
    EXPECT_LT(picture("Material \"glass\" \"float eta\" 1 \"rgb Kt\" [.9 .9 .9]" + ball, method),
              0.7 * usual);
  }
}

TEST(GlassOfIndexOne, WithEmissionIsALamp) {
  const auto scene = scene_from(pbrt_scene("Camera \"perspective\"", 4, 4, R"(
AttributeBegin Translate 0 0 3 Material "glass" "float eta" 1
AreaLightSource "diffuse" "rgb L" [2 2 2] Shape "sphere"
AttributeEnd)"));
  EXPECT_GT(render(*scene, {.samples = 16}).mean(), 0.1);
}

}  // namespace
}  // namespace ajar::test
