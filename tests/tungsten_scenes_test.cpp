// Scenes of Tungsten whose pictures are known in closed form: its units, sides and directions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "import/tungsten/tungsten_import.h"
#include "support/render.h"
#include "support/temporary_file.h"

namespace ajar {
namespace {

/// A picture of a scene that is written with ' in place of ".
struct Picture {
  std::vector<float> pixels;
  Vec2i size;

  /// Mean over the part of the picture between these shares of its width and height.
  Vec3 mean(float x0 = 0.F, float x1 = 1.F, float y0 = 0.F, float y1 = 1.F) const {
    Vec3 sum(0.F);
    float count = 0.F;
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) {
        const Vec2 at((static_cast<float>(x) + 0.5F) / static_cast<float>(size.x),
                      (static_cast<float>(y) + 0.5F) / static_cast<float>(size.y));
        if (at.x < x0 || at.x > x1 || at.y < y0 || at.y > y1) continue;
        const std::size_t i = 3 * static_cast<std::size_t>(y * size.x + x);
        sum += Vec3(pixels[i], pixels[i + 1], pixels[i + 2]);
        count += 1.F;
      }
    }
    return sum / count;
  }
};

Picture picture_of(std::string text, int samples, bool may_warn = false) {
  std::replace(text.begin(), text.end(), '\'', '"');
  Warnings warnings;
  desc::SceneDesc description = import_tungsten_text(text, "test.json", ".", warnings);
  const Scene scene(std::move(description), BuildOptions{}, warnings);
  if (!may_warn) {
    for (const std::string& message : warnings.messages()) ADD_FAILURE() << message;
  }
  test::RenderOptions options;
  options.samples = samples;
  return {test::render(scene, options).image(), scene.camera().resolution()};
}

void expect_color(const Vec3& actual, const Vec3& expected, float relative) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(actual[i], expected[i], relative * expected[i] + 1e-4F) << "lane " << i;
  }
}

/// `camera` looks at the origin from `distance` along +z, and sees `width` there.
std::string camera(float distance, float width, const std::string& rest = "") {
  const float fov = 2.F * std::atan(0.5F * width / distance) * 180.F / kPi;
  return "'camera': {'resolution': 16, 'reconstruction_filter': 'box', 'fov': " +
         std::to_string(fov) + ", 'transform': {'position': [0, 0, " + std::to_string(distance) +
         "], 'look_at': [0, 0, 0], 'up': [0, 1, 0]}" + rest + "}";
}

/// A square that faces the camera and fills its picture; images are upright on it.
std::string wall(float width, const std::string& members) {
  return "{'type': 'quad', 'transform': {'rotation': [90, 0, 0], 'scale': " +
         std::to_string(width) + "}, " + members + "}";
}

/// Red and green above, blue and white below.
class FourColors {
 public:
  explicit FourColors(const std::string& extension) : file_("colors." + extension) {
    std::ofstream out(file_.path(), std::ios::binary);
    // Portable float maps begin with the lowest row.
    const float texels[] = {0, 0, 1, 1, 1, 1, 1, 0, 0, 0, 1, 0};
    out << "PF\n2 2\n-1.0\n";
    out.write(reinterpret_cast<const char*>(texels), sizeof(texels));
  }
  const std::string& path() const { return file_.path(); }

 private:
  test::TemporaryFile file_;
};

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
  const Picture picture = picture_of(
      "{'bsdfs': [{'name': 'half', 'type': 'lambert', 'albedo': 0.5}], 'primitives': [" + walls +
          "], 'camera': {'resolution': 8, 'fov': 90, 'transform': {'rotation': [10, 20, 30]}}}",
      256);
  expect_color(picture.mean(), {2, 4, 6}, 0.02F);
}

TEST(TungstenScenes, EmissionIsRadianceAndPowerIsFlux) {
  const std::string wall_of_light = wall(4.F, "'emission': [1, 2, 3], 'bsdf': {'type': 'null'}");
  expect_color(
      picture_of("{" + camera(5.F, 2.F) + ", 'primitives': [" + wall_of_light + "]}", 1).mean(),
      {1, 2, 3}, 1e-4F);
  // Φ = π A L.
  const std::string flux = wall(4.F, "'power': 16, 'bsdf': {'type': 'null'}");
  expect_color(picture_of("{" + camera(5.F, 2.F) + ", 'primitives': [" + flux + "]}", 1).mean(),
               Vec3(1.F / kPi), 1e-4F);
}

TEST(TungstenScenes, ShapesEmitFromTheirOutsideOnly) {
  for (const char* shape : {"'type': 'sphere'", "'type': 'cube'", "'type': 'cylinder'",
                            "'type': 'sphere', 'transform': {'scale': [-1, 1, 1]}",
                            "'type': 'cube', 'transform': {'scale': [-1, 1, 1]}",
                            "'type': 'disk', 'transform': {'rotation': [90, 0, 0]}"}) {
    const std::string primitive = "{" + std::string(shape) +
                                  ", 'emission': 3, 'bsdf': {'type': "
                                  "'null'}}";
    const Picture front =
        picture_of("{" + camera(5.F, 0.5F) + ", 'primitives': [" + primitive + "]}", 1);
    expect_color(front.mean(), Vec3(3.F), 1e-4F);
    const Picture inside = picture_of(
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
  const Picture picture =
      picture_of("{" + camera(5.F, 0.05F) + ", 'primitives': [" +
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
  const Picture picture = picture_of(
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
  const Picture picture = picture_of(
      "{" + camera(20.F, 4.F) + ", 'primitives': [" + at("[1, 0, 0]", "[1, 0, 0]") + "," +
          at("[-1, 0, 0]", "[0, 1, 0]") + "," + at("[0, 1, 0]", "[0, 0, 1]") + "]}",
      4);
  EXPECT_GT(picture.mean(0.5F, 1.F).x, 0.05F);
  EXPECT_LT(picture.mean(0.F, 0.45F).x, 1e-6F);
  EXPECT_GT(picture.mean(0.F, 0.5F).y, 0.05F);
  EXPECT_GT(picture.mean(0.F, 1.F, 0.F, 0.5F).z, 0.05F);
  EXPECT_LT(picture.mean(0.F, 1.F, 0.55F, 1.F).z, 1e-6F);
}

TEST(TungstenScenes, ImagesAreUprightOnSquares) {
  const FourColors image("pfm");
  const Picture picture = picture_of(
      "{" + camera(20.F, 2.F) + ", 'primitives': [" +
          wall(2.F,
               "'bsdf': {'type': 'null'}, 'emission': {'type': 'bitmap', 'interpolate': false, "
               "'file': '" +
                   image.path() + "'}") +
          "]}",
      1);
  expect_color(picture.mean(0.1F, 0.4F, 0.1F, 0.4F), {1, 0, 0}, 1e-3F);
  expect_color(picture.mean(0.6F, 0.9F, 0.1F, 0.4F), {0, 1, 0}, 1e-3F);
  expect_color(picture.mean(0.1F, 0.4F, 0.6F, 0.9F), {0, 0, 1}, 1e-3F);
  expect_color(picture.mean(0.6F, 0.9F, 0.6F, 0.9F), {1, 1, 1}, 1e-3F);
}

TEST(TungstenScenes, CheckersAreOffAtTheOriginOfTheTexture) {
  // The lower left of a square that is seen upright.
  const Picture picture = picture_of(
      "{" + camera(20.F, 2.F) + ", 'primitives': [" +
          wall(2.F,
               "'bsdf': {'type': 'null'}, 'emission': {'type': 'checker', 'res_u': 2, 'res_v': "
               "2, 'on_color': [1, 0, 0], 'off_color': [0, 0, 1]}") +
          "]}",
      1);
  expect_color(picture.mean(0.1F, 0.4F, 0.6F, 0.9F), {0, 0, 1}, 1e-3F);
  expect_color(picture.mean(0.6F, 0.9F, 0.6F, 0.9F), {1, 0, 0}, 1e-3F);
}

TEST(TungstenScenes, EnvironmentsHaveTheirColumnsWhereTungstenHasThem) {
  // u = atan2(z, x) / 2π + 1/2: the left half of the image is at z < 0, its upper half at y > 0.
  const FourColors image("pfm");
  const auto towards = [&](const char* place) {
    return picture_of("{'camera': {'resolution': 4, 'fov': 0.01, 'transform': {'look_at': " +
                          std::string(place) +
                          "}}, 'primitives': [{'type': 'infinite_sphere', 'emission': '" +
                          image.path() + "'}]}",
                      1, true)
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
  const FourColors image("pfm");
  const Picture picture = picture_of(
      "{'camera': {'resolution': 32, 'fov': 3, 'reconstruction_filter': 'box', 'transform': "
      "{'position': [20, 0, 0], 'look_at': [0, 0, 0], 'up': [0, 1, 0]}}, 'primitives': ["
      "{'type': 'sphere', 'bsdf': {'type': 'null'}, 'emission': {'type': 'bitmap', 'interpolate': "
      "false, 'file': '" +
          image.path() + "'}}]}",
      1);
  // Seen from +x, −z is to the right.
  expect_color(picture.mean(0.1F, 0.4F, 0.1F, 0.4F), {1, 1, 1}, 1e-3F);
  expect_color(picture.mean(0.6F, 0.9F, 0.1F, 0.4F), {0, 1, 0}, 1e-3F);
  expect_color(picture.mean(0.1F, 0.4F, 0.6F, 0.9F), {0, 0, 1}, 1e-3F);
  expect_color(picture.mean(0.6F, 0.9F, 0.6F, 0.9F), {1, 0, 0}, 1e-3F);
}

TEST(TungstenScenes, MetalsReflectByTheirIndices) {
  // Fresnel at normal incidence: ((n − 1)² + k²) / ((n + 1)² + k²).
  const float n[] = {0.143119F, 0.374957F, 1.44248F};
  const float k[] = {3.98316F, 2.38572F, 1.60322F};
  Vec3 expected;
  for (int i = 0; i < 3; ++i) {
    expected[i] =
        ((n[i] - 1.F) * (n[i] - 1.F) + k[i] * k[i]) / ((n[i] + 1.F) * (n[i] + 1.F) + k[i] * k[i]);
  }
  const Picture picture =
      picture_of("{" + camera(5.F, 0.02F) + ", 'primitives': [" +
                     wall(4.F, "'bsdf': {'type': 'conductor', 'material': 'Au'}") +
                     ", {'type': 'infinite_sphere', 'emission': 1}]}",
                 16);
  expect_color(picture.mean(), expected, 5e-3F);
}

TEST(TungstenScenes, SurfacesLookTheSameFromBehind) {
  for (const char* rotation : {"[90, 0, 0]", "[-90, 0, 0]"}) {
    const Picture picture =
        picture_of("{" + camera(5.F, 1.F) +
                       ", 'primitives': [{'type': 'quad', 'transform': {'scale': 4, "
                       "'rotation': " +
                       rotation +
                       "}, 'bsdf': {'type': 'lambert', 'albedo': 0.5}}, "
                       "{'type': 'infinite_sphere', 'emission': 1}]}",
                   64);
    expect_color(picture.mean(), Vec3(0.5F), 0.01F);
  }
}

TEST(TungstenScenes, CoatsAndPlasticsKeepTheLightThatTheyReflectOnAverage) {
  // A convex body in an even environment reflects its mean albedo, seen from all sides: a sphere
  // shows each angle with the weight of its cosine.
  const auto mean_albedo = [](const std::string& bsdf) {
    const Picture picture = picture_of("{" + camera(200.F, 2.F) +
                                           ", 'primitives': [{'type': 'sphere', 'bsdf': " + bsdf +
                                           "}, {'type': 'infinite_sphere', 'emission': 1}]}",
                                       256, true);
    const Vec3 all = picture.mean();
    const float disk = kPi / 4.F;
    return (all.x - (1.F - disk)) / disk;
  };
  // Diffuse part of the plastic by its series, and what the layer reflects: for an index of 1.5
  // 0.2612 + 0.0918.
  EXPECT_NEAR(mean_albedo("{'type': 'plastic', 'albedo': 0.5}"), 0.353F, 0.01F);
  EXPECT_NEAR(mean_albedo("{'type': 'rough_plastic', 'albedo': 0.5, 'roughness': 0.05}"), 0.353F,
              0.015F);
  // A white mirror under a layer without absorption: what is reflected at once, and what goes in
  // and out, (1 − F)² on average.
  EXPECT_NEAR(mean_albedo("{'type': 'smooth_coat', 'ior': 1.5, 'substrate': {'type': 'mirror'}}"),
              0.0918F + 0.837F, 0.015F);
}

}  // namespace
}  // namespace ajar
