// Scenes of Mitsuba whose pictures are known in closed form: units, sides, directions, colours.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "import/mitsuba/mitsuba_import.h"
#include "support/temporary_file.h"
#include "support/tiny_picture.h"

namespace ajar {
namespace {

using test::expect_color;
using test::FourColors;
using test::MayWarn;
using test::TinyPicture;

/// Names in each version.
struct MitsubaVersion {
  const char* number;
  const char* to_world;
};
const MitsubaVersion kOld{"0.6.0", "toWorld"};
const MitsubaVersion kNew{"3.0.0", "to_world"};
void PrintTo(const MitsubaVersion& version, std::ostream* out) { *out << version.number; }

class Mitsuba : public ::testing::TestWithParam<MitsubaVersion> {
 protected:
  /// Picture of a scene that is written with ' in place of ".
  TinyPicture picture(const std::string& body, int samples = 1,
                      MayWarn may_warn = MayWarn::No) const {
    const std::string text =
        fmt::format("<scene version='{}'>\n{}\n</scene>", GetParam().number, body);
    return test::picture_of(
        [&](Warnings& warnings) {
          return import_mitsuba_text(test::with_quotes(text), "test.xml", ".", warnings);
        },
        samples, may_warn);
  }
  std::string placed(const std::string& steps) const {
    return fmt::format("<transform name='{}'>{}</transform>", GetParam().to_world, steps);
  }
  std::string view(float fov, const std::string& origin, const std::string& target,
                   const std::string& rest = "") const {
    return fmt::format(
        "<sensor type='perspective'><float name='fov' value='{}'/>{}<film type='hdrfilm'>"
        "<integer name='width' value='16'/><integer name='height' value='16'/><rfilter "
        "type='box'/></film>{}</sensor>\n",
        fov,
        placed(fmt::format("<lookat origin='{}' target='{}' up='0.1, 1, 0.1'/>", origin, target)),
        rest);
  }
  /// Looks along −z at the origin from `distance`, and sees `width` there.
  std::string camera(float distance, float width) const {
    return fmt::format(
        "<sensor type='perspective'><float name='fov' value='{}'/>{}<film type='hdrfilm'>"
        "<integer name='width' value='16'/><integer name='height' value='16'/><rfilter "
        "type='box'/></film></sensor>\n",
        2.F * std::atan(0.5F * width / distance) * 180.F / kPi,
        placed(fmt::format("<lookat origin='0, 0, {}' target='0, 0, 0' up='0, 1, 0'/>", distance)));
  }
  std::string towards(const std::string& place) const { return view(0.01F, "0, 0, 0", place); }
  /// A square of 4 × 4 in the plane z = 0 that faces +z.
  std::string wall(const std::string& inside) const {
    return "<shape type='rectangle'>" + placed("<scale x='2' y='2'/>") + inside + "</shape>\n";
  }
  std::string matt(const std::string& color) const {
    return "<bsdf type='twosided'><bsdf type='diffuse'>" + color + "</bsdf></bsdf>";
  }
  /// Reflectance of a wall of this in even light, seen from the front.
  Vec3 reflected(const std::string& bsdf, int samples = 64) const {
    return picture(camera(5, 0.02F) + wall(bsdf) + kEvenLight, samples, MayWarn::Yes).mean();
  }
  static constexpr const char* kEvenLight =
      "<emitter type='constant'><rgb name='radiance' value='1'/></emitter>";
};
INSTANTIATE_TEST_SUITE_P(Versions, Mitsuba, ::testing::Values(kOld, kNew));

std::string lamp(const std::string& rgb) {
  return "<emitter type='area'><rgb name='radiance' value='" + rgb + "'/></emitter>";
}

TEST_P(Mitsuba, ClosedFurnaceSumsAllBounces) {
  // Within walls that emit L and reflect ρ everything has the radiance L / (1 − ρ).
  const std::string flip = GetParam().number[0] == '0' ? "flipNormals" : "flip_normals";
  const TinyPicture inside =
      picture(view(90, "0, 0, 0", "1, 2, 3") + "<shape type='sphere'><boolean name='" + flip +
                  "' value='true'/>" + matt("<rgb name='reflectance' value='0.5, 0.25, 0'/>") +
                  lamp("1, 2, 3") + "</shape>",
              128);
  expect_color(inside.mean(), {2, 8.F / 3, 3}, 0.02F);
}

TEST_P(Mitsuba, EmissionIsRadianceToTheSideOfTheNormal) {
  expect_color(picture(camera(5, 2) + wall(lamp("1, 2, 3"))).mean(), {1, 2, 3}, 1e-4F);
  // A rectangle, a disk: from +z only.
  for (const char* shape : {"rectangle", "disk"}) {
    const auto seen = [&](const char* steps) {
      return picture(camera(5, 0.2F) + "<shape type='" + shape + "'>" + placed(steps) +
                     lamp("3, 3, 3") + "</shape>")
          .mean()
          .x;
    };
    EXPECT_FLOAT_EQ(seen(""), 3.F) << shape;
    EXPECT_EQ(seen("<rotate y='1' angle='180'/>"), 0.F) << shape;
    EXPECT_FLOAT_EQ(seen("<scale x='-1'/>"), 3.F) << shape;
  }
  // Bodies: outward.
  for (const char* shape : {"sphere", "cube"}) {
    const std::string body = "<shape type='" + std::string(shape) + "'>" +
                             placed("<scale x='-1'/>") + lamp("3, 3, 3") + "</shape>";
    // A mirrored sphere is inside out since version 2.
    const bool is_inside_out = shape[0] == 's' && GetParam().number[0] != '0';
    EXPECT_FLOAT_EQ(picture(camera(5, 0.2F) + body).mean().x, is_inside_out ? 0.F : 3.F) << shape;
    EXPECT_FLOAT_EQ(picture(view(5, "0, 0, 0", "0, 0, 1") + body).mean().x,
                    is_inside_out ? 3.F : 0.F)
        << shape;
  }
}

TEST_P(Mitsuba, SurfacesWithOneSideAreTheSameFromBehind) {
  // In Mitsuba they are black there, which a warning says.
  const std::string one_sided =
      wall("<bsdf type='diffuse'><rgb name='reflectance' value='0.5, 0.25, 0.125'/></bsdf>");
  for (const char* eye : {"0, 0, 5", "0, 0, -5"}) {
    const TinyPicture seen =
        picture(view(0.2F, eye, "0, 0, 0") + one_sided + kEvenLight, 64, MayWarn::Yes);
    expect_color(seen.mean(), {0.5F, 0.25F, 0.125F}, 0.01F);
  }
}

TEST_P(Mitsuba, ConstantLightIsItsRadianceInAllDirections) {
  for (const char* place : {"0, 0, 1", "1, -2, 3", "-1, 0, -1"}) {
    const TinyPicture seen =
        picture(towards(place) +
                    "<emitter type='constant'><rgb name='radiance' value='1, 2, 3'/></emitter>",
                1, MayWarn::Yes);
    expect_color(seen.mean(), {1, 2, 3}, 1e-4F);
  }
}

TEST_P(Mitsuba, PicturesAreNotMirrored) {
  // Space is right-handed: seen along −z with +y up, +x is to the right.
  const auto at = [&](const char* place, const char* color) {
    return fmt::format(
        "<shape type='sphere'><point name='center' {}/><float name='radius' value='0.4'/>{}"
        "</shape>",
        place, lamp(color));
  };
  const TinyPicture seen =
      picture(camera(20, 4) + at("x='1' y='0' z='0'", "1, 0, 0") +
                  at("x='-1' y='0' z='0'", "0, 1, 0") + at("x='0' y='1' z='0'", "0, 0, 1"),
              4);
  EXPECT_GT(seen.mean(0.5F, 1.F).x, 0.05F);
  EXPECT_EQ(seen.mean(0.F, 0.45F).x, 0.F);
  EXPECT_GT(seen.mean(0.F, 0.5F).y, 0.05F);
  EXPECT_GT(seen.mean(0.F, 1.F, 0.F, 0.5F).z, 0.05F);
  EXPECT_EQ(seen.mean(0.F, 1.F, 0.55F, 1.F).z, 0.F);
}

TEST_P(Mitsuba, PointLightLightsAWallByTheInverseSquare) {
  // E = I / d².
  const std::string position = GetParam().number[0] == '0'
                                   ? "<point name='position' x='0' y='0' z='2'/>"
                                   : "<point name='position' value='0, 0, 2'/>";
  const TinyPicture seen =
      picture(camera(5, 0.05F) + wall(matt("<rgb name='reflectance' value='0.5'/>")) +
                  "<emitter type='point'><rgb name='intensity' value='10, 20, 40'/>" + position +
                  "</emitter>",
              4);
  expect_color(seen.mean(), Vec3(10, 20, 40) * (0.5F / kPi / 4.F));
}

TEST_P(Mitsuba, DirectionalLightGivesItsIrradianceAcrossItsDirection) {
  // "direction" is where it goes to.
  const auto seen = [&](const char* z) {
    return picture(camera(5, 1) + wall(matt("<rgb name='reflectance' value='0.5'/>")) +
                   "<emitter type='directional'><vector name='direction' x='0' y='3' z='" + z +
                   "'/><rgb name='irradiance' value='1, 2, 3'/></emitter>")
        .mean();
  };
  expect_color(seen("-4"), Vec3(1, 2, 3) * (0.5F / kPi * 0.8F));
}

TEST_P(Mitsuba, SpotsShineAlongTheirAxis) {
  const bool is_old = GetParam().number[0] == '0';
  const TinyPicture seen = picture(
      camera(5, 4) + wall(matt("<rgb name='reflectance' value='1'/>")) +
          fmt::format("<emitter type='spot'>{}<rgb name='intensity' value='8'/><float name='{}' "
                      "value='30'/><float name='{}' value='30'/></emitter>",
                      placed("<lookat origin='0, 0, 2' target='0, 0, 0' up='0, 1, 0'/>"),
                      is_old ? "cutoffAngle" : "cutoff_angle", is_old ? "beamWidth" : "beam_width"),
      16);
  // Straight below I / d² / π, and beyond 2 tan 30° = 1.15 nothing.
  EXPECT_NEAR(seen.mean(0.45F, 0.55F, 0.45F, 0.55F).x, 8.F / 4.F / kPi, 0.02F);
  EXPECT_EQ(seen.mean(0.F, 0.15F).x, 0.F);
}

TEST_P(Mitsuba, ImagesHaveTheirTopRowAtVZero) {
  // A rectangle has v = 0 at its lower side.
  const FourColors image;
  const std::string filter = GetParam().number[0] == '0' ? "filterType" : "filter_type";
  const TinyPicture seen = picture(
      camera(20, 4) + wall("<emitter type='area'><texture type='bitmap' name='radiance'><string "
                           "name='filename' value='" +
                           image.path() + "'/><string name='" + filter +
                           "' value='nearest'/></texture></emitter>"));
  expect_color(seen.lower_left(), {1, 0, 0});
  expect_color(seen.lower_right(), {0, 1, 0});
  expect_color(seen.upper_left(), {0, 0, 1});
  expect_color(seen.upper_right(), {1, 1, 1});
}

TEST_P(Mitsuba, ImagesRunOutwardOverDisksAndThenAround) {
  const FourColors image;
  const std::string filter = GetParam().number[0] == '0' ? "filterType" : "filter_type";
  const auto seen = [&](float x, float y) {
    return picture(view(0.01F, fmt::format("{}, {}, 5", x, y), fmt::format("{}, {}, 0", x, y)) +
                   "<shape type='disk'><emitter type='area'><texture type='bitmap' "
                   "name='radiance'><string name='filename' value='" +
                   image.path() + "'/><string name='" + filter +
                   "' value='nearest'/></texture></emitter></shape>")
        .mean();
  };
  // u is the radius, v the angle, half a turn for each row.
  expect_color(seen(0.F, 0.25F), {1, 0, 0});
  expect_color(seen(0.F, 0.75F), {0, 1, 0});
  expect_color(seen(0.F, -0.25F), {0, 0, 1});
  expect_color(seen(0.F, -0.75F), {1, 1, 1});
}

TEST_P(Mitsuba, CheckerboardsHaveTwoSquaresEachWay) {
  const TinyPicture seen = picture(
      camera(20, 4) + wall("<emitter type='area'><texture type='checkerboard' name='radiance'><rgb "
                           "name='color0' value='1, 0, 0'/><rgb name='color1' value='0, 0, 1'/>"
                           "</texture></emitter>"));
  expect_color(seen.lower_left(), {1, 0, 0});
  expect_color(seen.upper_right(), {1, 0, 0});
  expect_color(seen.lower_right(), {0, 0, 1});
  expect_color(seen.upper_left(), {0, 0, 1});
}

TEST_P(Mitsuba, EnvironmentsHaveTheirColumnsWhereMitsubaHasThem) {
  // u = atan2(x, −z) / 2π, v = acos(y) / π from the top row: the left half is at +x.
  // Two rows of each colour: at 45° it is the same whether the outer rows are the poles, as since
  // version 2, or not. PFM has the lowest row first.
  const test::TemporaryFile image("sky.pfm");
  const float below[] = {0, 0, 1, 1, 1, 1, 0, 0, 1, 1, 1, 1};
  const float above[] = {1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 0};
  std::ofstream file(image.path(), std::ios::binary);
  file << "PF\n2 4\n-1\n";
  file.write(reinterpret_cast<const char*>(below), sizeof(below));
  file.write(reinterpret_cast<const char*>(above), sizeof(above));
  file.close();
  const auto seen = [&](const std::string& place) {
    return picture(towards(place) + "<emitter type='envmap'><string name='filename' value='" +
                       image.path() + "'/></emitter>",
                   1, MayWarn::Yes)
        .mean();
  };
  expect_color(seen("1, 1, 0"), {1, 0, 0}, 1e-2F);
  expect_color(seen("-1, 1, 0"), {0, 1, 0}, 1e-2F);
  expect_color(seen("1, -1, 0"), {0, 0, 1}, 1e-2F);
  expect_color(seen("-1, -1, 0"), {1, 1, 1}, 1e-2F);
}

TEST_P(Mitsuba, CodedImagesAreDecodedUnlessTheFileSaysOtherwise) {
  const test::CodedGray image(188);
  const auto seen = [&](const std::string& property) {
    return picture(camera(5, 1) +
                   wall("<emitter type='area'><texture type='bitmap' name='radiance'><string "
                        "name='filename' value='" +
                        image.path() + "'/>" + property + "</texture></emitter>"))
        .mean();
  };
  expect_color(seen(""), Vec3(image.decoded()));
  if (GetParam().number[0] == '0') {
    expect_color(seen("<float name='gamma' value='1'/>"), Vec3(image.undecoded()));
    expect_color(seen("<float name='gamma' value='-1'/>"), Vec3(image.decoded()));
    expect_color(seen("<float name='gamma' value='3'/>"), Vec3(std::pow(image.undecoded(), 3.F)));
  } else {
    expect_color(seen("<boolean name='raw' value='true'/>"), Vec3(image.undecoded()));
  }
}

TEST_P(Mitsuba, ColorsAreLinearUnlessTheyAreCalledSrgb) {
  const auto emitted = [&](const std::string& color) {
    return picture(camera(5, 1) + wall("<emitter type='area'>" + color + "</emitter>")).mean();
  };
  expect_color(emitted("<rgb name='radiance' value='0.2, 0.5, 2'/>"), {0.2F, 0.5F, 2.F});
  expect_color(emitted("<rgb name='radiance' value='#ff8033'/>"), {1.F, 128.F / 255, 0.2F});
  // IEC 61966-2-1: 0.5 of the code is 0.21404 of the light.
  expect_color(emitted("<srgb name='radiance' value='1, 0.5, 0.02'/>"),
               {1.F, 0.21404F, 0.02F / 12.92F});
  // One number is equal energy since version 3, by the matrix of Rec. 709.
  const bool is_old = GetParam().number[0] == '0';
  expect_color(emitted("<spectrum name='radiance' value='7'/>"),
               7.F * (is_old ? Vec3(1.F) : Vec3(1.2048F, 0.9483F, 0.9089F)), 2e-3F);
}

TEST_P(Mitsuba, EvenSpectraOfSurfacesAreGreySinceMitsuba3) {
  const bool is_old = GetParam().number[0] == '0';
  // Light of equal energy, by the matrix of Rec. 709.
  const Vec3 even(1.2048F, 0.9483F, 0.9089F);
  const std::string spectrum = "value='300:0.5, 900:0.5'/>";
  expect_color(picture(camera(5, 1) + wall("<emitter type='area'><spectrum name='radiance' " +
                                           spectrum + "</emitter>"))
                   .mean(),
               even * 0.5F, 2e-3F);
  expect_color(reflected(matt("<spectrum name='reflectance' " + spectrum)),
               is_old ? even * 0.5F : Vec3(0.5F), 0.01F);
}

TEST_P(Mitsuba, MetalsReflectByTheirIndices) {
  const auto metal = [&](const std::string& properties) {
    return reflected(
        "<bsdf type='twosided'><bsdf type='conductor'>" + properties + "</bsdf></bsdf>", 16);
  };
  const std::string outside = GetParam().number[0] == '0' ? "extEta" : "ext_eta";
  expect_color(metal("<rgb name='eta' value='0.5'/><rgb name='k' value='3'/><float name='" +
                     outside + "' value='1'/>"),
               Vec3(test::normal_reflectance(0.5F, 3.F)), 5e-3F);
  expect_color(metal("<string name='material' value='none'/>"), Vec3(1.F), 1e-3F);
  // Values of Tungsten's tables (Johnson and Christy 1972): another metal, or another order of
  // lanes, would differ by more than a tenth.
  expect_color(
      metal("<string name='material' value='Au'/>"),
      {test::normal_reflectance(0.143119F, 3.98316F), test::normal_reflectance(0.374957F, 2.38572F),
       test::normal_reflectance(1.44248F, 1.60322F)},
      0.1F);
}

TEST_P(Mitsuba, PanesAndMasksTransmitTheRest) {
  // A pane reflects 2R / (1 + R), all orders between its sides in all.
  const auto through = [&](const std::string& bsdf) {
    return picture(camera(5, 0.02F) + wall(bsdf) + "<shape type='rectangle'>" +
                       placed("<scale value='2'/><translate z='-1'/>") + lamp("1, 2, 4") +
                       "</shape>",
                   256, MayWarn::Yes)
        .mean();
  };
  const bool is_old = GetParam().number[0] == '0';
  const float r = test::normal_reflectance(1.5F, 0.F);
  expect_color(through(fmt::format("<bsdf type='thindielectric'><float name='{}' value='1.5'/>"
                                   "<float name='{}' value='1'/></bsdf>",
                                   is_old ? "intIOR" : "int_ior", is_old ? "extIOR" : "ext_ior")),
               Vec3(1, 2, 4) * (1.F - 2.F * r / (1.F + r)), 0.01F);
  expect_color(through("<bsdf type='mask'><float name='opacity' value='0.25'/><bsdf "
                       "type='diffuse'><rgb name='reflectance' value='0'/></bsdf></bsdf>"),
               Vec3(1, 2, 4) * 0.75F, 0.02F);
  expect_color(through("<bsdf type='null'/>"), {1, 2, 4});
}

TEST_P(Mitsuba, FieldOfViewIsThatOfTheWidth) {
  // A disk of radius tan(fov / 2) at the distance 1 just touches the sides of a wide picture.
  const std::string axis = GetParam().number[0] == '0' ? "fovAxis" : "fov_axis";
  const auto covered = [&](const std::string& which) {
    return picture("<sensor type='perspective'><float name='fov' value='60'/>" + which +
                       placed("<lookat origin='0, 0, 1' target='0, 0, 0' up='0, 1, 0'/>") +
                       "<film type='hdrfilm'><integer name='width' value='16'/><integer "
                       "name='height' value='32'/><rfilter type='box'/></film></sensor>"
                       "<shape type='disk'>" +
                       placed(fmt::format("<scale value='{}'/>", std::tan(kPi / 6.F))) +
                       lamp("1, 1, 1") + "</shape>",
                   128)
        .mean()
        .x;
  };
  EXPECT_NEAR(covered(""), kPi / 8.F, 0.005F);
  // Coverage of the disk cut at half its radius on both sides, over its height.
  EXPECT_NEAR(covered("<string name='" + axis + "' value='y'/>"),
              0.5F * std::sqrt(0.75F) + kPi / 6.F, 0.005F);
}

TEST_P(Mitsuba, ProjectorsLightAPlaneEvenly) {
  // A white plane at the distance 5 in the light of 10 π / 5².
  for (const float fov : {30.F, 60.F, 100.F}) {
    const auto seen = [&](const std::string& place) {
      return picture(towards("0, 0, 5") +
                         fmt::format("<emitter type='projector'>{}<float name='fov' "
                                     "value='{}'/><rgb name='irradiance' value='10'/></emitter>"
                                     "<shape type='rectangle'>{}<bsdf type='diffuse'><rgb "
                                     "name='reflectance' value='1'/></bsdf></shape>",
                                     placed(place), fov,
                                     placed("<scale value='9'/><rotate x='1' angle='180'/>"
                                            "<translate z='5'/>")),
                     16, MayWarn::Yes)
          .mean();
    };
    expect_color(seen("<translate x='0'/>"), Vec3(0.4F), 2e-3F);
    const float tangent = std::tan(fov * kPi / 360.F);
    expect_color(seen(fmt::format("<translate x='{}'/>", 0.95F * 5.F * tangent)), Vec3(0.4F),
                 2e-3F);
    expect_color(seen(fmt::format("<translate y='{}'/>", 1.05F * 5.F * tangent)), Vec3(0.F));
    expect_color(seen("<scale value='3'/>"), Vec3(1.2F), 2e-3F);
  }
}

TEST_P(Mitsuba, NormalMapsOfOneColorTilt) {
  // 0.8 / π · 3 · cosine, of a light that comes from (1, 0.3, 1). Mitsuba 3.9 has 0.5284, and
  // tilted 0.6997, 0.4198 and 0.6595: 5 to 6 % less, by its shadowing of normal maps.
  const auto lit = [&](const std::string& map) {
    return picture(camera(5, 0.02F) +
                       wall("<bsdf type='normalmap'>" + map +
                            "<bsdf type='diffuse'><rgb name='reflectance' value='0.8'/></bsdf>"
                            "</bsdf>") +
                       "<emitter type='directional'><vector name='direction' x='-1' y='-0.3' "
                       "z='-1'/><rgb name='irradiance' value='3'/></emitter>",
                   16, MayWarn::Yes)
        .mean();
  };
  expect_color(lit("<rgb name='normalmap' value='0.5, 0.5, 1'/>"), Vec3(0.5284F), 3e-3F);
  expect_color(lit("<rgb name='normalmap' value='0.9, 0.5, 0.8'/>"), Vec3(0.7398F), 3e-3F);
  expect_color(lit("<rgb name='normalmap' value='0.5, 0.9, 0.8'/>"), Vec3(0.4438F), 3e-3F);
  expect_color(lit("<float name='normalmap' value='0.7'/>"), Vec3(0.7017F), 3e-3F);
}

TEST_P(Mitsuba, GridsAbsorbByTheIntegralOfTheirDensity) {
  // From 1 to 3 along z in a box of depth 2, half as wide as the cube around it.
  const test::TemporaryFile file("density.vol");
  const std::int32_t header[] = {1, 2, 2, 2, 1};
  const float numbers[] = {-0.5F, -1, -1, 0.5F, 1, 1, 1, 1, 1, 1, 3, 3, 3, 3};
  std::ofstream(file.path(), std::ios::binary)
      << "VOL\x03" << std::string_view(reinterpret_cast<const char*>(header), sizeof(header))
      << std::string_view(reinterpret_cast<const char*>(numbers), sizeof(numbers));
  const bool is_old = GetParam().number[0] == '0';
  const std::string volume = fmt::format(
      "<volume name='{}' type='gridvolume'><string name='filename' value='{}'/>{}</volume>",
      is_old ? "density" : "sigma_t", file.path(),
      is_old ? "" : placed("<scale x='1' y='2' z='2'/><translate x='-0.5' y='-1' z='-1'/>"));
  const std::string smoke =
      "<shape type='cube'><bsdf type='null'/><medium name='interior' type='heterogeneous'>" +
      volume +
      "<volume name='albedo' type='constvolume'><rgb name='value' value='0'/></volume>"
      "<float name='scale' value='0.5'/></medium></shape>";
  const auto along = [&](float x) {
    return picture(view(0.01F, fmt::format("{}, 0, 5", x), fmt::format("{}, 0, 0", x)) + smoke +
                       kEvenLight,
                   64)
        .mean();
  };
  expect_color(along(0.25F), Vec3(std::exp(-2.F)), 0.1F);
  expect_color(along(0.75F), Vec3(1.F));
}

}  // namespace
}  // namespace ajar
