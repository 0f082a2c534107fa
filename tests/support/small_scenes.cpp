#include "support/small_scenes.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "support/render.h"

namespace ajar::test {

namespace {

const std::string kRoom = R"(
AttributeBegin
  AreaLightSource "diffuse" "rgb L" [8 7 6]
  Shape "trianglemesh" "point P" [-0.4 1.9 -0.4  0.4 1.9 -0.4  0.4 1.9 0.4  -0.4 1.9 0.4]
    "integer indices" [0 1 2 0 2 3] "normal N" [0 -1 0  0 -1 0  0 -1 0  0 -1 0]
AttributeEnd
Material "matte" "rgb Kd" [0.7 0.6 0.5]
Shape "trianglemesh" "point P" [-2 0 -2  2 0 -2  2 0 2  -2 0 2] "integer indices" [0 2 1 0 3 2]
Shape "trianglemesh" "point P" [-2 0 2  2 0 2  2 4 2  -2 4 2] "integer indices" [0 2 1 0 3 2]
)";

const std::string kMetalBall = R"(
AttributeBegin
  Material "metal" "float roughness" [0.1] "bool remaproughness" "false"
  Translate 0.6 0.4 0.2
  Shape "sphere" "float radius" [0.4]
AttributeEnd
)";

const std::string kTiltedNormals = R"(
AttributeBegin
  Material "matte"
  Shape "trianglemesh" "point P" [-1 0 0  1 0 0  0 1.5 0.4] "normal N" [-0.5 0.3 -1  0.5 0.3 -1  0 0.8 -1]
    "integer indices" [0 1 2]
AttributeEnd
)";

const std::string kFog = R"(
MakeNamedMedium "fog" "string type" "homogeneous" "rgb sigma_a" [0.05 0.1 0.1] "rgb sigma_s" [0.3 0.2 0.4] "float g" [0.4]
MediumInterface "" "fog"
)";

const std::string kMilk = R"(
MakeNamedMedium "milk" "string type" "homogeneous" "rgb sigma_a" [0.1 0.2 0.3] "rgb sigma_s" [3 2 1]
)";

/// A cloud that is dense in the middle of its box and empty in the corners.
std::string smoke() {
  constexpr int kSide = 5;
  std::string values;
  for (int i = 0; i < kSide * kSide * kSide; ++i) {
    const auto away = [](int at) { return std::abs(at - kSide / 2) / (0.5 * kSide); };
    const double x = away(i % kSide);
    const double y = away(i / kSide % kSide);
    const double z = away(i / kSide / kSide);
    values += " " + std::to_string(std::max(0.0, 1.0 - x * x - y * y - z * z));
  }
  return "MakeNamedMedium \"smoke\" \"string type\" \"heterogeneous\" \"rgb sigma_a\" [0.5 1 2] "
         "\"rgb sigma_s\" [6 4 5] \"float g\" [0.3] \"integer nx\" 5 \"integer ny\" 5 \"integer "
         "nz\" 5 "
         "\"point p0\" [-0.6 0 -0.3] \"point p1\" [0.6 1.2 0.9] \"float density\" [" +
         values + "]\n";
}

/// A cloud that turns from red to blue from left to right: the rest is absorption.
std::string colored_smoke() {
  constexpr int kSide = 3;
  std::string absorption;
  std::string scattering;
  for (int i = 0; i < kSide * kSide * kSide; ++i) {
    const char* const kColors[] = {" 0.5 4 6", " 1 2 1", " 6 3 0"};
    const char* const kOpposites[] = {" 6 2 0.5", " 3 5 3", " 0.5 3 7"};
    absorption += kColors[i % kSide];
    scattering += kOpposites[i % kSide];
  }
  return "MakeNamedMedium \"smoke\" \"string type\" \"rgbgrid\" \"rgb sigma_a\" [" + absorption +
         "] \"rgb sigma_s\" [" + scattering +
         "] \"float g\" [0.3] \"integer nx\" 3 \"integer ny\" 3 \"integer nz\" 3 "
         "\"point p0\" [-0.6 0 -0.3] \"point p1\" [0.6 1.2 0.9]\n";
}

const std::string kSun =
    "LightSource \"distant\" \"rgb L\" [0.4 0.4 0.5] \"point from\" [1 3 -1] \"point to\" [0 0 "
    "0]\n";

const std::string kView = "LookAt 0 1 -4  0 0.8 0  0 1 0\n";
const std::string kPinhole = kView + "Camera \"perspective\" \"float fov\" [45]";

/// A sphere that stands on the floor, with the given material and more.
std::string ball(const std::string& material, float radius, float x) {
  return "AttributeBegin " + material + " Translate " + std::to_string(x) + " " +
         std::to_string(radius) + " 0.3 Shape \"sphere\" \"float radius\" [" +
         std::to_string(radius) + "] AttributeEnd\n";
}

/// Lamps of many colours and sizes all over the room, and a spot. Balls and disks by turns, disks
/// shine to one side, down or up.
std::string many_lamps() {
  std::string text =
      "LightSource \"spot\" \"rgb I\" [4 3 2] \"point from\" [-1 3 -1] \"point to\" [0 0 0]\n";
  for (int i = 0; i < 40; ++i) {
    // Kronecker sequences: evenly spread without a table.
    const auto spread = [i](double step, double low, double high) {
      const double x = (i + 0.5) * step;
      return std::to_string(low + (high - low) * (x - std::floor(x)));
    };
    const std::string radius = spread(0.37, 0.03, 0.1);
    text += "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [" + spread(0.29, 1.0, 9.0) +
            " " + spread(0.53, 1.0, 7.0) + " " + spread(0.71, 1.0, 8.0) + "]\nTranslate " +
            spread(0.8192, -1.8, 1.8) + " " + spread(0.6710, 0.2, 1.8) + " " +
            spread(0.5497, -1.5, 1.8) + "\n";
    if (i % 2 == 0) {
      text += "Shape \"sphere\" \"float radius\" [" + radius + "] AttributeEnd\n";
    } else {
      text += std::string("Rotate ") + (i % 4 == 1 ? "90" : "-90") +
              " 1 0 0 Shape \"disk\" \"float radius\" [" + radius + "] AttributeEnd\n";
    }
  }
  return text;
}

}  // namespace

std::vector<SmallScene> small_scenes() {
  const std::string glass = ball("Material \"glass\"", 0.5F, -0.5F);
  const std::string gaussian =
      "PixelFilter \"gaussian\" \"float xwidth\" [1.5] \"float ywidth\" [2]";
  const std::string mitchell = "PixelFilter \"mitchell\"";
  return {
      {.name = "Room", .text = pbrt_scene(kPinhole, 40, 24, kRoom, gaussian)},
      {.name = "GlassAndMetal",
       .text = pbrt_scene(kPinhole, 40, 24, kRoom + glass + kMetalBall),
       .light_tracing_works = false},
      {.name = "Mirror",
       .text = pbrt_scene(kPinhole, 24, 24, kRoom + ball("Material \"mirror\"", 0.6F, 0.F)),
       .light_tracing_works = false},
      {.name = "NestedDielectrics",
       .text = pbrt_scene(kPinhole, 24, 24,
                          kRoom + ball("Material \"glass\" \"float index\" [1.5]", 0.6F, 0.F) +
                              "AttributeBegin Material \"glass\" \"float index\" [0.9] Translate 0 "
                              "0.6 0.3 Shape \"sphere\" "
                              "\"float radius\" [0.4] AttributeEnd\n"),
       .light_tracing_works = false},
      {.name = "RoughGlass",
       .text = pbrt_scene(kPinhole, 24, 24,
                          kRoom + ball("Material \"glass\" \"float uroughness\" [0.3] \"float "
                                       "vroughness\" [0.3] \"bool "
                                       "remaproughness\" \"false\"",
                                       0.5F, 0.F))},
      {.name = "ThinLens",
       .text = pbrt_scene(
           kView + "Camera \"perspective\" \"float fov\" [45] \"float lensradius\" [0.1] \"float "
                   "focaldistance\" [4]",
           40, 24, kRoom + kMetalBall)},
      {.name = "Environment",
       .text = pbrt_scene(kPinhole, 40, 24,
                          "LightSource \"infinite\" \"rgb L\" [1 1.2 1.5]\n" + kRoom + glass),
       .light_tracing_works = false},
      {.name = "Distant",
       .text = pbrt_scene(kPinhole, 40, 24,
                          "LightSource \"distant\" \"point from\" [1 3 -1] \"point to\" [0 0 0]\n" +
                              kRoom + kMetalBall)},
      {.name = "PointAndSpot",
       .text = pbrt_scene(kPinhole, 40, 24,
                          "LightSource \"point\" \"point from\" [1 1.5 -1]\n"
                          "LightSource \"spot\" \"point from\" [-1 3 -1] \"point to\" [0 0 0]\n" +
                              kRoom + kMetalBall)},
      {.name = "ManyLamps",
       .text = pbrt_scene(kPinhole, 40, 24, kSun + many_lamps() + kRoom + kMetalBall)},
      {.name = "ManyLampsInFog",
       .text = pbrt_scene(kFog + kPinhole, 24, 24,
                          "MediumInterface \"fog\" \"fog\"\n" + many_lamps() + kRoom),
       .light_tracing_works = false,
       .samples = 512},
      {.name = "ShadingNormals", .text = pbrt_scene(kPinhole, 40, 24, kRoom + kTiltedNormals)},
      {.name = "Orthographic",
       .text = pbrt_scene(kView + "Camera \"orthographic\"", 40, 24, kRoom + kMetalBall)},
      {.name = "EnvironmentCamera",
       .text = pbrt_scene("LookAt 0 1 -1  0 0.8 0  0 1 0\nCamera \"environment\"", 40, 24,
                          kRoom + kMetalBall)},
      {.name = "CroppedMitchell",
       .text = pbrt_scene(kPinhole, 64, 40, kRoom + kMetalBall, mitchell),
       .samples = 256,
       .crop = Box2i(Vec2i(21, 9), Vec2i(52, 32))},
      {.name = "Fog",
       .text = pbrt_scene(kFog + kPinhole, 24, 24, "MediumInterface \"fog\" \"fog\"\n" + kRoom),
       .light_tracing_works = false,
       .samples = 512},
      {.name = "MilkBall",
       .text = pbrt_scene(kMilk + kPinhole, 24, 24,
                          kRoom + ball("MediumInterface \"milk\" \"\" Material \"\"", 0.6F, 0.F))},
      {.name = "Smoke",
       .text = pbrt_scene(smoke() + kPinhole, 24, 24,
                          kRoom + ball("MediumInterface \"smoke\" \"\" Material \"\"", 0.6F, 0.F))},
      {.name = "ColoredSmoke",
       .text = pbrt_scene(colored_smoke() + kPinhole, 24, 24,
                          kRoom + ball("MediumInterface \"smoke\" \"\" Material \"\"", 0.6F, 0.F))},
  };
}

SmallScene small_scene(const std::string& name) {
  std::vector<SmallScene> scenes = small_scenes();
  for (SmallScene& scene : scenes) {
    if (scene.name == name) return std::move(scene);
  }
  throw std::logic_error("no small scene " + name);
}

}  // namespace ajar::test
