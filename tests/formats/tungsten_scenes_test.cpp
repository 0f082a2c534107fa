// Scenes of Tungsten whose pictures are known in closed form: its units, sides and directions.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "import/tungsten/tungsten_import.h"
#include "support/tiny_picture.h"

namespace ajar {
namespace {

using test::expect_color;
using test::FourColors;
using test::MayWarn;
using test::TinyPicture;

/// Picture of a scene that is written with ' in place of ".
TinyPicture picture_of(const std::string& text, int samples, MayWarn may_warn = MayWarn::No) {
  return test::picture_of(
      [&](Warnings& warnings) {
        return import_tungsten_text(test::with_quotes(text), "test.json", ".", warnings);
      },
      samples, may_warn);
}

/// `camera` looks at the origin from `distance` along +z, and sees `width` there.
std::string camera_at(float distance, float width, const std::string& rest = "") {
  const float fov = 2.F * std::atan(0.5F * width / distance) * 180.F / kPi;
  return "'camera': {'resolution': 16, 'reconstruction_filter': 'box', 'fov': " +
         std::to_string(fov) + ", 'transform': {'position': [0, 0, " + std::to_string(distance) +
         "], 'look_at': [0, 0, 0], 'up': [0, 1, 0]}" + rest + "}";
}

/// A square that faces the camera and fills its picture; images on it are upside down.
std::string wall(float width, const std::string& members) {
  return "{'type': 'quad', 'transform': {'rotation': [90, 0, 0], 'scale': " +
         std::to_string(width) + "}, " + members + "}";
}

TEST(TungstenScenes, ClosedFurnaceSumsAllBounces) {
  // Within walls that emit L and reflect ρ everything has the radiance L / (1 − ρ).
  std::string walls;
  for (const char* rotation :
       {"[0, 0, 0]", "[180, 0, 0]", "[90, 0, 0]", "[-90, 0, 0]", "[0, 0, 90]", "[0, 0, -90]"}) {
    const std::string text(rotation);
    const Vec3 out = text == "[0, 0, 0]"     ? Vec3(0, -1, 0)
                     : text == "[180, 0, 0]" ? Vec3(0, 1, 0)
                     : text == "[90, 0, 0]"  ? Vec3(0, 0, -1)
                     : text == "[-90, 0, 0]" ? Vec3(0, 0, 1)
                     : text == "[0, 0, 90]"  ? Vec3(1, 0, 0)
                                             : Vec3(-1, 0, 0);
    walls += std::string(walls.empty() ? "" : ",") +
             "{'type': 'quad', 'bsdf': 'half', 'emission': [1, 2, 3], 'transform': {'scale': 2, "
             "'rotation': " +
             text + ", 'position': [" + std::to_string(out.x) + "," + std::to_string(out.y) + "," +
             std::to_string(out.z) + "]}}";
  }
  const TinyPicture picture = picture_of(
      "{'bsdfs': [{'name': 'half', 'type': 'lambert', 'albedo': 0.5}], 'primitives': [" + walls +
          "], 'camera': {'resolution': 8, 'fov': 90, 'transform': {'rotation': [10, 20, 30]}}}",
      256);
  expect_color(picture.mean(), {2, 4, 6}, 0.02F);
}

TEST(TungstenScenes, EmissionIsRadianceAndPowerIsFlux) {
  const std::string wall_of_light = wall(4.F, "'emission': [1, 2, 3], 'bsdf': {'type': 'null'}");
  expect_color(
      picture_of("{" + camera_at(5.F, 2.F) + ", 'primitives': [" + wall_of_light + "]}", 1).mean(),
      {1, 2, 3}, 1e-4F);
  // Φ = π A L.
  const std::string flux = wall(4.F, "'power': 16, 'bsdf': {'type': 'null'}");
  expect_color(picture_of("{" + camera_at(5.F, 2.F) + ", 'primitives': [" + flux + "]}", 1).mean(),
               Vec3(1.F / kPi), 1e-4F);
}

/// A tube of the radius 1/2 across the picture, in Tungsten's file of curves.
std::string file_of_tube() {
  std::string bytes =
      "\x80\xBF\x80"
      "FIBER";
  const auto add = [&](auto value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  const auto attribute = [&](std::string name, std::uint16_t of_curves, std::uint8_t type,
                             std::uint8_t lanes, std::uint64_t size) {
    name += '\0';
    add(std::uint64_t{20 + name.size()});
    add(size);
    add(of_curves);
    add(type);
    add(lanes);
    bytes += name;
  };
  add(std::uint32_t{1});  // version 1.0
  add(std::uint32_t{0});
  for (const std::uint64_t number : {40, 4, 1}) add(number);
  attribute("num_vertices", 1, 3, 1, 2);
  add(std::uint16_t{4});
  attribute("position", 0, 8, 3, 48);
  for (const float y : {-9.F, -3.F, 3.F, 9.F}) {
    for (const float value : {0.F, y, 0.F}) add(value);
  }
  attribute("width", 0, 8, 1, 4);
  add(0.5F);
  add(std::uint64_t{0});
  return bytes;
}

TEST(TungstenScenes, CurvesAreTubesOfTheirWidthAsRadius) {
  const std::string file = file_of_tube();
  const TinyPicture picture = test::picture_of(
      [&](Warnings& warnings) {
        return import_tungsten_text(
            test::with_quotes("{" + camera_at(5.F, 2.F) +
                              ", 'bsdfs': [{'name': 'm', 'type': 'lambert', 'albedo': 0.5}], "
                              "'primitives': [{'type': 'curves', 'file': 'tube.fiber', 'bsdf': "
                              "'m'}, {'type': 'infinite_sphere', 'emission': 1}]}"),
            "test.json", ".", warnings,
            [&](const std::string& path) -> std::optional<std::string_view> {
              if (path.ends_with("tube.fiber")) return file;
              return std::nullopt;
            });
      },
      256);
  // Nothing else hides the sky from a tube. Its outline is at r / √(d² − r²) of the distance.
  const float share = 5.F * 0.5F / std::sqrt(25.F - 0.25F);
  expect_color(picture.mean(0.3F, 0.7F), Vec3(0.5F), 0.01F);
  expect_color(picture.mean(0.F, 0.2F), Vec3(1.F), 1e-4F);
  expect_color(picture.mean(), Vec3(1.F - 0.5F * share), 0.01F);
}

TEST(TungstenScenes, ShapesEmitFromTheirOutsideOnly) {
  for (const char* shape : {"'type': 'sphere'", "'type': 'cube'", "'type': 'cylinder'",
                            "'type': 'sphere', 'transform': {'scale': [-1, 1, 1]}",
                            "'type': 'cube', 'transform': {'scale': [-1, 1, 1]}",
                            "'type': 'disk', 'transform': {'rotation': [90, 0, 0]}"}) {
    const std::string primitive = "{" + std::string(shape) +
                                  ", 'emission': 3, 'bsdf': {'type': "
                                  "'null'}}";
    const TinyPicture front =
        picture_of("{" + camera_at(5.F, 0.5F) + ", 'primitives': [" + primitive + "]}", 1);
    expect_color(front.mean(), Vec3(3.F), 1e-4F);
    const TinyPicture inside = picture_of(
        "{'camera': {'resolution': 16, 'fov': 5, 'transform': {'position': [0, 0, -0.1], "
        "'look_at': "
        "[0, 0, -1]}}, 'primitives': [" +
            primitive + "]}",
        1);
    expect_color(inside.mean(), Vec3(0.F), 1e-4F);
  }
}

TEST(TungstenScenes, PointLightLightsAWallByTheInverseSquare) {
  // E = I / d² below a lamp of power Φ = 4π I.
  const TinyPicture picture =
      picture_of("{" + camera_at(5.F, 0.05F) + ", 'primitives': [" +
                     wall(4.F, "'bsdf': {'type': 'lambert', 'albedo': 0.5}") +
                     ", {'type': 'point', 'power': 100, 'transform': {'position': [0, 0, 2]}}]}",
                 4);
  const float intensity = 100.F / (4.F * kPi);
  expect_color(picture.mean(), Vec3(0.5F / kPi * intensity / 4.F), 1e-3F);
}

TEST(TungstenScenes, ASquareLampLightsAFloor) {
  // Form factor of a square of side 2a, seen from below its middle at the distance d: four times
  // that of a quarter, of which we stand below a corner.
  const float a = 0.5F;
  const float d = 1.F;
  const float h = std::sqrt(a * a + d * d);
  const float corner = a / h * std::atan(a / h) / kPi;
  const float form_factor = 4.F * corner;
  const TinyPicture picture = picture_of(
      "{'camera': {'resolution': 8, 'reconstruction_filter': 'box', 'fov': 1, 'transform': "
      "{'position': [3, 3, 0], 'look_at': [0, 0, 0], 'up': [0, 1, 0]}}, 'primitives': ["
      "{'type': 'quad', 'transform': {'scale': 4}, 'bsdf': {'type': 'lambert', 'albedo': 0.5}},"
      "{'type': 'quad', 'transform': {'position': [0, 1, 0], 'rotation': [180, 0, 0]}, 'emission': "
      "10, 'bsdf': {'type': 'null'}}]}",
      256);
  expect_color(picture.mean(), Vec3(0.5F * 10.F * form_factor), 0.02F);
}

TEST(TungstenScenes, PicturesAreNotMirrored) {
  // Red at +x, green at −x, blue at +y: seen from +z, +x is to the right.
  const auto at = [](const char* place, const char* color) {
    return std::string("{'type': 'sphere', 'emission': ") + color +
           ", 'bsdf': {'type': 'null'}, 'transform': {'scale': 0.4, 'position': " + place + "}}";
  };
  const TinyPicture picture = picture_of(
      "{" + camera_at(20.F, 4.F) + ", 'primitives': [" + at("[1, 0, 0]", "[1, 0, 0]") + "," +
          at("[-1, 0, 0]", "[0, 1, 0]") + "," + at("[0, 1, 0]", "[0, 0, 1]") + "]}",
      4);
  EXPECT_GT(picture.mean(0.5F, 1.F).x, 0.05F);
  EXPECT_LT(picture.mean(0.F, 0.45F).x, 1e-6F);
  EXPECT_GT(picture.mean(0.F, 0.5F).y, 0.05F);
  EXPECT_GT(picture.mean(0.F, 1.F, 0.F, 0.5F).z, 0.05F);
  EXPECT_LT(picture.mean(0.F, 1.F, 0.55F, 1.F).z, 1e-6F);
}

TEST(TungstenScenes, ColorsOfImagesAreDecodedByAPowerUnlessTheySayNo) {
  const test::CodedGray image(188);
  const auto mean_with = [&](const std::string& member) {
    return picture_of("{" + camera_at(5.F, 2.F) + ", 'primitives': [" +
                          wall(4.F, "'bsdf': {'type': 'null'}, 'emission': {'type': 'bitmap', " +
                                        member + "'scale': 2, 'file': '" + image.path() + "'}") +
                          "]}",
                      1)
        .mean();
  };
  expect_color(mean_with(""), Vec3(2.F * std::pow(image.undecoded(), 2.2F)));
  expect_color(mean_with("'gamma_correct': false, "), Vec3(2.F * image.undecoded()));
}

TEST(TungstenScenes, ImagesOnSquaresRiseAlongZ) {
  const FourColors image;
  const TinyPicture picture = picture_of(
      "{" + camera_at(20.F, 2.F) + ", 'primitives': [" +
          wall(2.F,
               "'bsdf': {'type': 'null'}, 'emission': {'type': 'bitmap', 'interpolate': false, "
               "'file': '" +
                   image.path() + "'}") +
          "]}",
      1);
  // v runs along z, which is down here.
  expect_color(picture.lower_left(), {1, 0, 0});
  expect_color(picture.lower_right(), {0, 1, 0});
  expect_color(picture.upper_left(), {0, 0, 1});
  expect_color(picture.upper_right(), {1, 1, 1});
}

TEST(TungstenScenes, CheckersAreOffAtTheOriginOfTheTexture) {
  // The upper left of a square whose z is down.
  const TinyPicture picture = picture_of(
      "{" + camera_at(20.F, 2.F) + ", 'primitives': [" +
          wall(2.F,
               "'bsdf': {'type': 'null'}, 'emission': {'type': 'checker', 'res_u': 2, 'res_v': "
               "2, 'on_color': [1, 0, 0], 'off_color': [0, 0, 1]}") +
          "]}",
      1);
  expect_color(picture.upper_left(), {0, 0, 1});
  expect_color(picture.upper_right(), {1, 0, 0});
}

TEST(TungstenScenes, EnvironmentsHaveTheirColumnsWhereTungstenHasThem) {
  // u = atan2(z, x) / 2π + 1/2: the left half of the image is at z < 0, its upper half at y > 0.
  const FourColors image;
  const auto towards = [&](const char* place) {
    return picture_of("{'camera': {'resolution': 4, 'fov': 0.01, 'transform': {'look_at': " +
                          std::string(place) +
                          "}}, 'primitives': [{'type': 'infinite_sphere', 'emission': '" +
                          image.path() + "'}]}",
                      1, MayWarn::Yes)
        .mean();
  };
  expect_color(towards("[0, 1, -1]"), {1, 0, 0}, 1e-2F);
  expect_color(towards("[0, 1, 1]"), {0, 1, 0}, 1e-2F);
  expect_color(towards("[0, -1, -1]"), {0, 0, 1}, 1e-2F);
  expect_color(towards("[0, -1, 1]"), {1, 1, 1}, 1e-2F);
}

TEST(TungstenScenes, SpheresHaveTheirTexturesWhereTungstenHasThem) {
  // u = atan2(y, x) / 2π + 1/2 and v = acos(z) / π: with v from the bottom of the image, its lower
  // half is at z > 0, its right half at y > 0.
  const FourColors image;
  const TinyPicture picture = picture_of(
      "{'camera': {'resolution': 32, 'fov': 3, 'reconstruction_filter': 'box', 'transform': "
      "{'position': [20, 0, 0], 'look_at': [0, 0, 0], 'up': [0, 1, 0]}}, 'primitives': ["
      "{'type': 'sphere', 'bsdf': {'type': 'null'}, 'emission': {'type': 'bitmap', 'interpolate': "
      "false, 'file': '" +
          image.path() + "'}}]}",
      1);
  // Seen from +x, −z is to the right.
  expect_color(picture.upper_left(), {1, 1, 1});
  expect_color(picture.upper_right(), {0, 1, 0});
  expect_color(picture.lower_left(), {0, 0, 1});
  expect_color(picture.lower_right(), {1, 0, 0});
}

TEST(TungstenScenes, MetalsReflectByTheirIndices) {
  const Vec3 gold(test::normal_reflectance(0.143119F, 3.98316F),
                  test::normal_reflectance(0.374957F, 2.38572F),
                  test::normal_reflectance(1.44248F, 1.60322F));
  const TinyPicture picture =
      picture_of("{" + camera_at(5.F, 0.02F) + ", 'primitives': [" +
                     wall(4.F, "'bsdf': {'type': 'conductor', 'material': 'Au'}") +
                     ", {'type': 'infinite_sphere', 'emission': 1}]}",
                 16);
  expect_color(picture.mean(), gold, 5e-3F);
}

TEST(TungstenScenes, SurfacesLookTheSameFromBehind) {
  for (const char* rotation : {"[90, 0, 0]", "[-90, 0, 0]"}) {
    const TinyPicture picture =
        picture_of("{" + camera_at(5.F, 1.F) +
                       ", 'primitives': [{'type': 'quad', 'transform': {'scale': 4, "
                       "'rotation': " +
                       rotation +
                       "}, 'bsdf': {'type': 'lambert', 'albedo': 0.5}}, "
                       "{'type': 'infinite_sphere', 'emission': 1}]}",
                   64);
    expect_color(picture.mean(), Vec3(0.5F), 0.01F);
  }
}

TEST(TungstenScenes, CoatsAndPlasticsKeepTheirMeanAlbedo) {
  // A convex body in an even environment reflects its mean albedo, seen from all sides: a sphere
  // shows each angle with the weight of its cosine.
  const auto mean_albedo = [](const std::string& bsdf) {
    const TinyPicture picture = picture_of(
        "{" + camera_at(200.F, 2.F) + ", 'primitives': [{'type': 'sphere', 'bsdf': " + bsdf +
            "}, {'type': 'infinite_sphere', 'emission': 1}]}",
        256, MayWarn::Yes);
    const Vec3 all = picture.mean();
    const float disk = kPi / 4.F;
    return (all.x - (1.F - disk)) / disk;
  };
  // Diffuse part of the plastic by its series, and the reflection of the layer: for an index of 1.5
  // 0.2612 + 0.0918.
  EXPECT_NEAR(mean_albedo("{'type': 'plastic', 'albedo': 0.5}"), 0.353F, 0.01F);
  EXPECT_NEAR(mean_albedo("{'type': 'rough_plastic', 'albedo': 0.5, 'roughness': 0.05}"), 0.353F,
              0.015F);
  // A white mirror under a layer without absorption: the outer reflection, and light that goes in
  // and out, (1 − F)² on average.
  EXPECT_NEAR(mean_albedo("{'type': 'smooth_coat', 'ior': 1.5, 'substrate': {'type': 'mirror'}}"),
              0.0918F + 0.837F, 0.015F);
}

}  // namespace
}  // namespace ajar
