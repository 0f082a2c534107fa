// Scenes of pbrt-v3 and pbrt-v4 whose pictures are known in closed form: units, sides, directions,
// colours.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/IO.h>

#include <cmath>
#include <string>

#include "import/pbrt/pbrt_import.h"
#include "support/tiny_picture.h"

namespace ajar {
namespace {

using test::expect_color;
using test::FourColors;
using test::MayWarn;
using test::TinyPicture;

/// Names in each version.
struct PbrtVersion {
  const char* name;
  const char* film;
  const char* end;
  const char* diffuse;  ///< diffuse material, opened: "Material …" up to the value of its
                        ///< reflectance
};
const PbrtVersion kV3{"v3", "image", "WorldEnd", "Material 'matte' 'rgb Kd' "};
const PbrtVersion kV4{"v4", "rgb", "", "Material 'diffuse' 'rgb reflectance' "};
void PrintTo(const PbrtVersion& version, std::ostream* out) { *out << version.name; }

/// A scene that is written with ' in place of ".
TinyPicture picture_of(const PbrtVersion& version, const std::string& camera,
                       const std::string& world, int samples = 1, MayWarn may_warn = MayWarn::No) {
  const std::string text = fmt::format(
      "{}\nFilm '{}' 'integer xresolution' [16] 'integer yresolution' [16]\nPixelFilter 'box'\n"
      "Integrator 'volpath' 'integer maxdepth' 99\n"
      "WorldBegin\n{}\n{}\n",
      camera, version.film, world, version.end);
  return test::picture_of(
      [&](Warnings& warnings) {
        return import_pbrt_text(test::with_quotes(text), "test.pbrt", ".", warnings);
      },
      samples, may_warn);
}

/// Looks along +z at the origin from `distance`, and sees `width` there; +x is to the right.
std::string camera(float distance, float width) {
  return fmt::format("LookAt 0 0 {} 0 0 0 0 1 0 Camera 'perspective' 'float fov' {}", -distance,
                     2.F * std::atan(0.5F * width / distance) * 180.F / kPi);
}

/// Looks from the origin at a point.
std::string towards(const std::string& place) {
  return "LookAt 0 0 0 " + place + " 0.1 1 0.2 Camera 'perspective' 'float fov' 0.01";
}

/// A scene needs a shape.
const char* const kAside = "Translate 9 0 0 Shape 'sphere' 'float radius' 0.01\n";

/// A square of 4 × 4 in the plane z = 0 that faces the camera; images are upright on it.
const char* const kWall =
    "Shape 'trianglemesh' 'integer indices' [0 2 1 0 3 2] 'point P' [-2 -2 0 2 -2 0 2 2 0 -2 2 0] "
    "'float uv' [0 0 1 0 1 1 0 1]\n";
/// The wall for pbrt-v4.
const char* const kWall4 =
    "Shape 'trianglemesh' 'integer indices' [0 2 1 0 3 2] 'point3 P' [-2 -2 0 2 -2 0 2 2 0 -2 2 0] "
    "'point2 uv' [0 0 1 0 1 1 0 1]\n";

class Pbrt : public ::testing::TestWithParam<PbrtVersion> {
 protected:
  const PbrtVersion& version() const { return GetParam(); }
  bool is_v4() const { return &version() == &kV4 || std::string(version().name) == "v4"; }
  std::string wall() const { return is_v4() ? kWall4 : kWall; }
  std::string matte(const std::string& rgb) const { return version().diffuse + rgb + "\n"; }
  TinyPicture picture(const std::string& camera, const std::string& world, int samples = 1,
                      MayWarn may_warn = MayWarn::No) const {
    return picture_of(version(), camera, world, samples, may_warn);
  }
};
INSTANTIATE_TEST_SUITE_P(Versions, Pbrt, ::testing::Values(kV3, kV4));

TEST_P(Pbrt, SmokeAbsorbsByTheIntegralOfItsDensity) {
  // From 0.5 to 1 in a quarter of the box, to 3 in half of it, to 1.5 in the last quarter.
  const float integral = 0.25F * 0.75F + 0.5F * 2.F + 0.25F * 2.25F;
  const std::string medium = fmt::format(
      "AttributeBegin Translate 0.5 0 0 Scale 0.5 0.5 0.5\nMakeNamedMedium 'smoke' 'string type' "
      "'{}' "
      "'rgb sigma_a' [0.4 1 2] 'rgb sigma_s' [0 0 0] 'float scale' 0.5 'integer nz' 2\n"
      "'{} p0' [-2 -1 -1] '{} p1' [0 1 1] 'float density' [1 3] AttributeEnd\n",
      is_v4() ? "uniformgrid" : "heterogeneous", is_v4() ? "point3" : "point",
      is_v4() ? "point3" : "point");
  const TinyPicture picture = this->picture(
      camera(6, 0.001F), medium + "LightSource 'infinite' 'rgb L' [1 1 1]\nMaterial '" +
                             (is_v4() ? "interface" : "") +
                             "'\nMediumInterface 'smoke' '' Shape 'sphere' 'float radius' 2\n");
  expect_color(picture.mean(),
               {std::exp(-0.2F * integral), std::exp(-0.5F * integral), std::exp(-1.F * integral)});
}

TEST(Pbrt4Scenes, ColorsOfSmokeVaryAlongTheWay) {
  // The first point of the box absorbs red, the second one blue; green is not absorbed.
  const float integral = 0.25F * 0.75F + 0.5F * 0.5F;
  const TinyPicture picture = picture_of(
      kV4, camera(6, 0.001F),
      "MakeNamedMedium 'smoke' 'string type' 'rgbgrid' 'rgb sigma_a' [3 0 0 0 0 2] 'rgb sigma_s' "
      "[0 0 0 0 0 0] 'float scale' 0.5 'integer nz' 2 'point3 p0' [-1 -1 -1] 'point3 p1' [1 1 1]\n"
      "LightSource 'infinite' 'rgb L' [1 1 1]\nMaterial 'interface'\nMediumInterface 'smoke' '' "
      "Shape 'sphere' 'float radius' 2\n");
  expect_color(picture.mean(), {std::exp(-3.F * integral), 1.F, std::exp(-2.F * integral)});
}

TEST_P(Pbrt, ClosedFurnaceSumsAllBounces) {
  // Within walls that emit L and reflect ρ everything has the radiance L / (1 − ρ).
  const TinyPicture inside =
      picture("LookAt 0 0 0 1 2 3 0 1 0 Camera 'perspective' 'float fov' 90",
              matte("[0.5 0.25 0]") +
                  "ReverseOrientation AreaLightSource 'diffuse' 'rgb L' [1 2 3] Shape 'sphere'",
              256);
  expect_color(inside.mean(), {2, 8.F / 3, 3}, 0.02F);
}

TEST_P(Pbrt, EmissionIsRadiance) {
  const std::string lamp = "AreaLightSource 'diffuse' 'rgb L' [1 2 3] ";
  expect_color(picture(camera(5, 2), lamp + wall()).mean(), {1, 2, 3}, 1e-4F);
  const std::string scale = is_v4() ? "'float scale' 2\n" : "'rgb scale' [2 2 2]\n";
  expect_color(
      picture(camera(5, 2), "AreaLightSource 'diffuse' 'rgb L' [1 2 3] " + scale + wall()).mean(),
      {2, 4, 6}, 1e-4F);
}

TEST_P(Pbrt, SurfacesEmitToTheSideOfTheirNormal) {
  const std::string lamp = "AreaLightSource 'diffuse' 'rgb L' [3 3 3] ";
  const std::string both = "AreaLightSource 'diffuse' 'rgb L' [3 3 3] 'bool twosided' 'true' ";
  // A disk faces +z, and the camera is at -z.
  EXPECT_EQ(picture(camera(5, 0.5F), lamp + "Shape 'disk'").mean().x, 0.F);
  expect_color(picture(camera(5, 0.5F), both + "Shape 'disk'").mean(), Vec3(3), 1e-4F);
  expect_color(picture(camera(5, 0.5F), lamp + "ReverseOrientation Shape 'disk'").mean(), Vec3(3),
               1e-4F);
  expect_color(picture(camera(5, 0.5F), lamp + "Rotate 180 0 1 0 Shape 'disk'").mean(), Vec3(3),
               1e-4F);
  // The order of corners decides: clockwise seen from the front, as transforms that mirror do.
  expect_color(picture(camera(5, 0.5F), lamp + wall()).mean(), Vec3(3), 1e-4F);
  EXPECT_EQ(picture(camera(5, 0.5F), lamp + "Rotate 180 0 1 0 " + wall()).mean().x, 0.F);
  // Bodies shine outward.
  for (const char* mirror : {"", "Scale -1 1 1 "}) {
    expect_color(picture(camera(5, 0.5F), lamp + mirror + "Shape 'sphere'").mean(), Vec3(3), 1e-4F);
    EXPECT_EQ(picture("LookAt 0 0 0 0 0 1 0 1 0 Camera 'perspective' 'float fov' 5",
                      lamp + mirror + "Shape 'sphere'")
                  .mean()
                  .x,
              0.F);
  }
}

TEST_P(Pbrt, PicturesAreNotMirrored) {
  // Space is left-handed to the camera: seen along +z with +y up, +x is to the right.
  const auto at = [](const char* place, const char* color) {
    return fmt::format(
        "AttributeBegin Translate {} AreaLightSource 'diffuse' 'rgb L' {} Shape 'sphere' 'float "
        "radius' 0.4 AttributeEnd\n",
        place, color);
  };
  const TinyPicture seen = picture(
      camera(20, 4), at("1 0 0", "[1 0 0]") + at("-1 0 0", "[0 1 0]") + at("0 1 0", "[0 0 1]"), 4);
  EXPECT_GT(seen.mean(0.5F, 1.F).x, 0.05F);
  EXPECT_LT(seen.mean(0.F, 0.45F).x, 1e-3F);
  EXPECT_GT(seen.mean(0.F, 0.5F).y, 0.05F);
  EXPECT_GT(seen.mean(0.F, 1.F, 0.F, 0.5F).z, 0.05F);
  EXPECT_LT(seen.mean(0.F, 1.F, 0.55F, 1.F).z, 1e-3F);
}

TEST_P(Pbrt, FieldOfViewIsThatOfTheShorterSide) {
  // A disk of radius tan(fov / 2) at the distance 1 just touches the shorter side.
  const std::string film = fmt::format(
      "LookAt 0 0 -1 0 0 0 0 1 0 Camera 'perspective' 'float fov' 60 Film '{}' 'integer "
      "xresolution' [32] 'integer yresolution' [16] PixelFilter 'box' WorldBegin "
      "AreaLightSource 'diffuse' 'rgb L' [1 1 1] 'bool twosided' 'true' Shape 'disk' 'float "
      "radius' {} {}",
      version().film, std::tan(kPi / 6.F), version().end);
  const TinyPicture seen = test::picture_of(
      [&](Warnings& warnings) {
        return import_pbrt_text(test::with_quotes(film), "test.pbrt", ".", warnings);
      },
      256);
  expect_color(seen.mean(), Vec3(kPi / 8.F), 0.01F);
}

TEST_P(Pbrt, PointLightLightsAWallByTheInverseSquare) {
  // E = I / d².
  const TinyPicture seen =
      picture(camera(5, 0.05F),
              "LightSource 'point' 'rgb I' [10 20 40] 'rgb scale' [1 1 1] 'point from' [0 0 -2]\n" +
                  matte("[0.5 0.5 0.5]") + wall(),
              4, is_v4() ? MayWarn::Yes : MayWarn::No);
  expect_color(seen.mean(), Vec3(10, 20, 40) * (0.5F / kPi / 4.F));
}

TEST_P(Pbrt, DistantLightGivesItsIrradianceFromWhereItIs) {
  const std::string world = matte("[0.5 0.5 0.5]") + wall();
  const std::string from = is_v4() ? "'point3 from' [0 3 -4] 'point3 to' [0 0 0]\n"
                                   : "'point from' [0 3 -4] 'point to' [0 0 0]\n";
  expect_color(
      picture(camera(5, 1), "LightSource 'distant' 'rgb L' [1 2 3] " + from + world).mean(),
      Vec3(1, 2, 3) * (0.5F / kPi * 0.8F));
}

TEST_P(Pbrt, SpotLightsShineAlongTheirAxis) {
  const std::string from = is_v4() ? "'point3 from' [0 0 -2] 'point3 to' [0 0 0] "
                                   : "'point from' [0 0 -2] 'point to' [0 0 0] ";
  const TinyPicture seen =
      picture(camera(5, 4),
              "LightSource 'spot' 'rgb I' [8 8 8] 'float coneangle' 30 'float conedeltaangle' 10 " +
                  from + matte("[1 1 1]") + wall(),
              16);
  // Straight below I / d² / π, and beyond 2 tan 30° = 1.15 nothing.
  EXPECT_NEAR(seen.mean(0.45F, 0.55F, 0.45F, 0.55F).x, 8.F / 4.F / kPi, 0.02F);
  EXPECT_EQ(seen.mean(0.F, 0.15F).x, 0.F);
}

TEST_P(Pbrt, ImagesAreUprightWithVUpward) {
  const FourColors image;
  const std::string world =
      "Texture 'colors' 'spectrum' 'imagemap' 'string filename' '" + image.path() +
      (is_v4() ? "' 'string filter' 'point'\n Material 'diffuse' 'texture reflectance' 'colors'\n"
               : "'\n Material 'matte' 'texture Kd' 'colors'\n") +
      wall() + "LightSource 'infinite' 'rgb L' [1 1 1]\n";
  const TinyPicture seen = picture(camera(20, 4), world, 256);
  // Where a texel is alone: bilinear filters begin to mix at its middle.
  const auto corner = [&](float x, float y) { return seen.mean(x, x + 0.1F, y, y + 0.1F); };
  const float a = 0.22F;
  const float b = 0.72F;
  EXPECT_GT(corner(a, a).x, 0.8F);
  EXPECT_LT(corner(a, a).z, 0.2F);
  EXPECT_GT(corner(b, a).y, 0.8F);
  EXPECT_LT(corner(b, a).x, 0.2F);
  EXPECT_GT(corner(a, b).z, 0.8F);
  EXPECT_LT(corner(a, b).y, 0.2F);
  EXPECT_GT(corner(b, b).y, 0.8F);
  EXPECT_GT(corner(b, b).z, 0.8F);
}

TEST_P(Pbrt, CodedImagesAreDecodedUnlessTheFileSaysOtherwise) {
  const test::CodedGray image(188);
  const auto reflected = [&](const std::string& parameters) {
    return picture(camera(5, 1), "Texture 'gray' 'spectrum' 'imagemap' 'string filename' '" +
                                     image.path() + "' " + parameters +
                                     (is_v4() ? " Material 'diffuse' 'texture reflectance' 'gray'\n"
                                              : " Material 'matte' 'texture Kd' 'gray'\n") +
                                     "LightSource 'distant' 'rgb L' [1 1 1]\nScale 1 1 -1 " +
                                     wall())
               .mean() *
           kPi;
  };
  expect_color(reflected(""), Vec3(image.decoded()));
  if (!is_v4()) {
    expect_color(reflected("'bool gamma' 'false'"), Vec3(image.undecoded()));
    expect_color(reflected("'float scale' 0.5"), Vec3(0.5F * image.decoded()));
    return;
  }
  expect_color(reflected("'string encoding' 'sRGB'"), Vec3(image.decoded()));
  expect_color(reflected("'string encoding' 'linear'"), Vec3(image.undecoded()));
  expect_color(reflected("'string encoding' 'gamma 3'"), Vec3(std::pow(image.undecoded(), 3.F)));
  expect_color(reflected("'bool invert' 'true'"), Vec3(1.F - image.decoded()));
  expect_color(reflected("'float scale' 0.5"), Vec3(0.5F * image.decoded()));
}

TEST_P(Pbrt, SurfacesLookTheSameFromBehind) {
  for (const char* turn : {"", "Rotate 180 0 1 0 ", "ReverseOrientation "}) {
    expect_color(picture(camera(5, 1),
                         "LightSource 'infinite' 'rgb L' [1 1 1]\n" + matte("[0.25 0.5 0.75]") +
                             turn + wall(),
                         64)
                     .mean(),
                 {0.25F, 0.5F, 0.75F}, 0.01F);
  }
}

TEST(PbrtV3Scenes, EnvironmentsHaveTheirColumnsWherePbrtHasThem) {
  // u = φ / 2π from +x toward +y, v = θ / π from +z, the top row.
  const FourColors image;
  const auto seen = [&](const std::string& place) {
    return picture_of(kV3, towards(place),
                      "LightSource 'infinite' 'string mapname' '" + image.path() + "'\n" + kAside)
        .mean();
  };
  expect_color(seen("0 1 1"), {1, 0, 0}, 1e-2F);
  expect_color(seen("0 -1 1"), {0, 1, 0}, 1e-2F);
  expect_color(seen("0 1 -1"), {0, 0, 1}, 1e-2F);
  expect_color(seen("0 -1 -1"), {1, 1, 1}, 1e-2F);
}

TEST(PbrtV4Scenes, EnvironmentsAreSquaresOfEqualArea) {
  // Clarberg's octahedron, +z in the middle: a quarter of the square is a quarter of the
  // directions, the first row that of −y.
  const FourColors image;
  const auto seen = [&](const std::string& place) {
    return picture_of(kV4, towards(place),
                      "LightSource 'infinite' 'string filename' '" + image.path() + "'\n" + kAside)
        .mean();
  };
  expect_color(seen("-1 -1 0"), {1, 0, 0}, 1e-2F);
  expect_color(seen("1 -1 0"), {0, 1, 0}, 1e-2F);
  expect_color(seen("-1 1 0"), {0, 0, 1}, 1e-2F);
  expect_color(seen("1 1 0"), {1, 1, 1}, 1e-2F);
}

TEST(PbrtV4Scenes, PowerIsFlux) {
  // Φ = π A L for a surface, 4π I for a point.
  const TinyPicture disk = picture_of(kV4, camera(5, 0.5F),
                                      "AreaLightSource 'diffuse' 'rgb L' [1 1 1] 'float power' 20\n"
                                      "ReverseOrientation Shape 'disk' 'float radius' 2");
  expect_color(disk.mean(), Vec3(20.F / (kPi * kPi * 4.F)));
  const TinyPicture both = picture_of(kV4, camera(5, 0.5F),
                                      "AreaLightSource 'diffuse' 'rgb L' [1 1 1] 'float power' 20 "
                                      "'bool twosided' 'true'\nShape 'disk' 'float radius' 2");
  expect_color(both.mean(), Vec3(10.F / (kPi * kPi * 4.F)));
  const TinyPicture point =
      picture_of(kV4, camera(5, 0.05F),
                 "LightSource 'point' 'rgb I' [1 1 1] 'float power' 100 'point3 from' [0 0 -2]\n"
                 "Material 'diffuse' 'rgb reflectance' [0.5 0.5 0.5]\n" +
                     std::string(kWall4),
                 4);
  expect_color(point.mean(), Vec3(100.F / (4.F * kPi) / 4.F * 0.5F / kPi));
}

TEST(PbrtV4Scenes, IlluminanceIsThatOfASurfaceThatFacesTheLight) {
  const TinyPicture seen = picture_of(
      kV4, camera(5, 1),
      "LightSource 'distant' 'rgb L' [1 1 1] 'float illuminance' 7 'point3 from' [0 0 -1] "
      "'point3 to' [0 0 0]\nMaterial 'diffuse' 'rgb reflectance' [0.5 0.5 0.5]\n" +
          std::string(kWall4));
  expect_color(seen.mean(), Vec3(7.F * 0.5F / kPi));
}

TEST(PbrtV4Scenes, ExposureIsThatOfTheSensor) {
  // Imaging ratio: exposure time × ISO / 100.
  const TinyPicture seen = test::picture_of(
      [&](Warnings& warnings) {
        return import_pbrt_text(
            test::with_quotes(camera(5, 2) +
                              " 'float shutteropen' 0.25 'float shutterclose' 0.75\n"
                              "Film 'rgb' 'integer xresolution' 4 'integer yresolution' 4 'float "
                              "iso' 400\nWorldBegin\nAreaLightSource 'diffuse' 'rgb L' [1 2 3] " +
                              kWall4),
            "test.pbrt", ".", warnings);
      },
      1);
  expect_color(seen.mean(), {2, 4, 6});
}

TEST(PbrtV4Scenes, BlackBodiesHaveTheirColorAndLuminanceOne) {
  // On the Planckian locus at 6500 K: x = 0.3135, y = 0.3237 (Wyszecki and Stiles 1982, table
  // 1(3.11)); linear Rec. 709 by its matrix.
  const Vec3 xyz(0.3135F / 0.3237F, 1.F, (1.F - 0.3135F - 0.3237F) / 0.3237F);
  const Vec3 rgb(3.2406F * xyz.x - 1.5372F * xyz.y - 0.4986F * xyz.z,
                 -0.9689F * xyz.x + 1.8758F * xyz.y + 0.0415F * xyz.z,
                 0.0557F * xyz.x - 0.2040F * xyz.y + 1.0570F * xyz.z);
  const TinyPicture seen = picture_of(
      kV4, camera(5, 2), "AreaLightSource 'diffuse' 'blackbody L' 6500\n" + std::string(kWall4));
  expect_color(seen.mean(), rgb, 3e-3F);
}

TEST(PbrtV3Scenes, BlackBodiesAreBrightestByTheirScale) {
  // Planck's law divided by its maximum: at 6500 K between 0.9 and 1 over all that is seen.
  const TinyPicture seen = picture_of(
      kV3, camera(5, 2), "AreaLightSource 'diffuse' 'blackbody L' [6500 2]\n" + std::string(kWall));
  for (int i = 0; i < 3; ++i) {
    EXPECT_GT(seen.mean()[i], 1.6F);
    EXPECT_LT(seen.mean()[i], 2.1F);
  }
}

TEST(PbrtV4Scenes, MetalsReflectByTheirIndices) {
  const auto reflected = [](const std::string& metal) {
    return picture_of(kV4, camera(5, 0.02F),
                      "LightSource 'infinite' 'rgb L' [1 1 1]\nMaterial 'conductor' " + metal +
                          " 'float roughness' 0\n" + kWall4,
                      16)
        .mean();
  };
  expect_color(reflected("'spectrum eta' [400 0.5 700 0.5] 'spectrum k' [400 3 700 3]"),
               Vec3(test::normal_reflectance(0.5F, 3.F)), 5e-3F);
  // Values of Tungsten's tables, which average the same measurements (Johnson and Christy 1972) by
  // the eye in other light. Another metal, or another order of lanes, would differ by more than a
  // tenth.
  expect_color(
      reflected("'spectrum eta' 'metal-Au-eta' 'spectrum k' 'metal-Au-k'"),
      {test::normal_reflectance(0.143119F, 3.98316F), test::normal_reflectance(0.374957F, 2.38572F),
       test::normal_reflectance(1.44248F, 1.60322F)},
      0.1F);
  expect_color(reflected("'rgb reflectance' [0.9 0.5 0.1]"), {0.9F, 0.5F, 0.1F}, 5e-3F);
}

TEST(PbrtV3Scenes, MetalsReflectByTheirIndices) {
  const auto reflected = [](const std::string& metal) {
    return picture_of(kV3, camera(5, 0.02F),
                      "LightSource 'infinite' 'rgb L' [1 1 1]\nMaterial 'metal' 'float roughness' "
                      "0.0001 'bool remaproughness' 'false' " +
                          metal + "\n" + kWall,
                      64)
        .mean();
  };
  // pbrt-v3 shows light of equal energy as it is: by the matrix of Rec. 709.
  const Vec3 even(1.2048F, 0.9483F, 0.9089F);
  expect_color(reflected("'spectrum eta' [300 0.5 900 0.5] 'spectrum k' [300 3 900 3]"),
               {test::normal_reflectance(0.5F * even.x, 3.F * even.x),
                test::normal_reflectance(0.5F * even.y, 3.F * even.y),
                test::normal_reflectance(0.5F * even.z, 3.F * even.z)},
               0.01F);
  // Without indices it is copper.
  expect_color(
      reflected(""),
      {test::normal_reflectance(0.200438F, 3.91295F), test::normal_reflectance(0.924033F, 2.45285F),
       test::normal_reflectance(1.10221F, 2.14219F)},
      0.03F);
}

TEST(PbrtV3Scenes, ReflectancesAreAsTheyAreNamed) {
  const std::string front = "LightSource 'infinite' 'rgb L' [1 1 1]\n";
  const auto reflected = [&](const std::string& material) {
    return picture_of(kV3, camera(5, 0.02F), front + material + kWall, 256).mean();
  };
  expect_color(reflected("Material 'mirror' 'rgb Kr' [0.9 0.5 0.1]\n"), {0.9F, 0.5F, 0.1F});
  expect_color(reflected("Material 'uber' 'rgb Kd' [0.25 0.5 0.75] 'rgb Ks' [0 0 0]\n"),
               {0.25F, 0.5F, 0.75F}, 0.02F);
  // Half of the light passes.
  expect_color(reflected("Material 'uber' 'rgb Kd' [1 1 1] 'rgb Ks' [0 0 0] 'rgb opacity' "
                         "[0.5 0.5 0.5]\n"),
               Vec3(1.F), 0.02F);
}

TEST(Pbrt4, NanoVdbAbsorbsByTheIntegralOfItsVoxels) {
  // Along z from 0.5 to 1 in the first unit and to 0 in the second.
  const float integral = 0.75F + 0.5F;
  nanovdb::GridBuilder<float> builder(0.F);
  auto voxels = builder.getAccessor();
  for (int i = 0; i < 4; ++i) {
    voxels.setValue(nanovdb::Coord(i % 2, i / 2, 0), 0.5F);
    voxels.setValue(nanovdb::Coord(i % 2, i / 2, 1), 1.F);
  }
  const test::TemporaryFile file("smoke.nvdb");
  nanovdb::io::writeGrid(file.path(),
                         builder.getHandle<>(1.0, nanovdb::Vec3d(-0.5, -0.5, 0), "density"));
  const TinyPicture seen = picture_of(
      kV4, camera(6, 0.001F),
      "MakeNamedMedium 'smoke' 'string type' 'nanovdb' 'string filename' '" + file.path() +
          "' 'rgb sigma_a' [0.4 1 2] 'rgb sigma_s' [0 0 0]\nLightSource 'infinite' 'rgb L' [1 1 "
          "1]\n"
          "Material 'interface' MediumInterface 'smoke' '' Shape 'sphere' 'float radius' 4\n");
  expect_color(seen.mean(),
               {std::exp(-0.4F * integral), std::exp(-integral), std::exp(-2.F * integral)}, 0.01F);
}

TEST(PbrtV4Scenes, LampsThatShouldNotBeSeenShineAndLetLightPass) {
  const auto wall = [](int radiance, float z) {
    return fmt::format(
        "AttributeBegin Translate 0 0 {} AreaLightSource 'diffuse' 'rgb L' [{} {} {}]\n{}", z,
        radiance, radiance, radiance, kWall4);
  };
  const TinyPicture seen =
      picture_of(kV4, camera(4, 1),
                 wall(1, 0) + "'float alpha' 0 AttributeEnd\n" + wall(2, 1) + "AttributeEnd\n", 4,
                 MayWarn::Yes);
  expect_color(seen.mean(), {3, 3, 3}, 1e-4F);
}

/// Cut-outs are no intersections; thin glass is one.
TEST(Pbrt4, AlphaAndInterfacesAddNothingToTheDepth) {
  const auto seen = [](const std::string& material, const std::string& alpha, int depth) {
    std::string text = camera(5, 0.5F) +
                       " Film 'rgb' 'integer xresolution' [16] 'integer yresolution' [16]\n"
                       "PixelFilter 'box' Integrator 'volpath' 'integer maxdepth' " +
                       std::to_string(depth) +
                       "\nWorldBegin LightSource 'infinite' 'rgb L' [1 1 1]\n" + material;
    for (int i = 0; i < 3; ++i) text += " Translate 0 0 0.1 " + std::string(kWall4) + alpha + "\n";
    return test::picture_of(
               [&](Warnings& warnings) {
                 return import_pbrt_text(test::with_quotes(text), "test.pbrt", ".", warnings);
               },
               256)
        .mean()
        .x;
  };
  const std::string black = "Material 'diffuse' 'rgb reflectance' [0 0 0]";
  EXPECT_NEAR(seen(black, "'float alpha' 0.5", 0), 0.125F, 0.008F);
  EXPECT_NEAR(seen("Material 'interface'", "", 0), 1.F, 1e-4F);
  EXPECT_NEAR(seen("Material 'thindielectric'", "", 0), 0.F, 1e-6F);
}

TEST(Pbrt4, AlphaIsOpacity) {
  // A quarter of the wall's emission, and three quarters of the background.
  for (const std::string alpha : {"'float alpha' 0.25", "'texture alpha' 'quarter'"}) {
    const TinyPicture seen = picture_of(
        kV4, camera(5, 1),
        "LightSource 'infinite' 'rgb L' [4 8 12]\nTexture 'quarter' 'float' 'constant' 'float "
        "value' 0.25\nMaterial 'diffuse' 'rgb reflectance' [0 0 0]\n" +
            std::string(kWall4) + alpha,
        256);
    expect_color(seen.mean(), {3, 6, 9}, 0.02F);
  }
}

}  // namespace
}  // namespace ajar
