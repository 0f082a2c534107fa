// Replacements for plugins without an equivalent (docs/reference/formats-mitsuba.md).
#include <algorithm>
#include <map>

#include "import/mitsuba/import_test_support.h"

namespace ajar::mitsuba {
namespace {

/// An imported scene, and its warnings.
struct Imported {
  explicit Imported(const std::string& text, const Files& files = {}) {
    Warnings of_import;
    scene = import_with(text, of_import, files);
    warnings = lines_of(of_import);
  }
  desc::SceneDesc scene;
  std::string warnings;
};

Imported seen_through(const std::string& sensor) {
  return Imported("<scene version='3.0.0'>" + sensor + "<shape type='sphere'/></scene>");
}

TEST(MitsubaStandIns, HaveLocatedWarnings) {
  struct Case {
    std::string body;
    std::string warning;
  };
  const std::string matt = "<bsdf type='dielectric'/>";
  for (const Case& c : std::initializer_list<Case>{
           {"<shape type='sphere'>" + matt + "<subsurface type='dipole'/></shape>",
            "subsurface scattering is not supported: this shape is opaque"},
           {"<shape type='sphere'><animation name='to_world'><transform time='0'/></animation>"
            "</shape>",
            "motion is not supported"},
           {"<shape type='obj'><string name='filename' value='m.obj'/>" + matt +
                "<float name='max_smooth_angle' value='30'/></shape>",
            "\"max_smooth_angle\" is not supported"},
           {"<emitter type='collimated'/>", "a collimated beam is not supported"},
           {sphere_of("<bsdf type='phong'/>"), "bsdf \"phong\" is not supported"},
           {sphere_of("<bsdf type='phong'><texture name='exponent' type='checkerboard'/></bsdf>"),
            "an \"exponent\" that varies is not supported: 30 stands in"},
           {"<integrator type='aov'><integrator type='path'/></integrator>",
            "integrator \"aov\" is not supported: only that in it is used"}}) {
    const std::string said =
        warnings_of(c.body, {{"m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}});
    EXPECT_TRUE(contains(said, "test.xml:2:") && contains(said, c.warning)) << c.body << said;
  }
}

TEST(MitsubaStandIns, IntegratorsOfExplicitPathsAreOurs) {
  for (const char* type : {"mlt", "erpt", "pssmlt"}) {
    const Imported imported(world("<integrator type='" + std::string(type) + "'/>"));
    EXPECT_EQ(imported.scene.hints.integrator, type);
    EXPECT_EQ(imported.warnings, "");
  }
}

TEST(MitsubaStandIns, WrapperIntegratorsAreTheirNestedOne) {
  const std::string path =
      "<integrator type='bdpt'><integer name='max_depth' value='7'/></integrator>";
  const Imported watched(world(
      "<integrator type='foo'><boolean name='hide_emitters' value='true'/><float name='bogus' "
      "value='3'/>" +
      path + "<integrator type='path'/></integrator>"));
  EXPECT_EQ(watched.scene.hints.integrator, "bdpt");
  EXPECT_EQ(watched.scene.hints.max_depth, 7);
  EXPECT_FALSE(watched.scene.camera.hides_lights);
  for (const char* part : {"integrator \"foo\" is not supported",
                           "<integrator type=\"foo\"> has more of <integrator> than it can use"}) {
    EXPECT_TRUE(contains(watched.warnings, part)) << part << watched.warnings;
  }
  // Nested integrators without a parent of their kind have no meaning.
  const Imported path_in_path(world("<integrator type='path'>" + path + "</integrator>"));
  EXPECT_EQ(path_in_path.scene.hints.integrator, "pt");
  EXPECT_TRUE(contains(path_in_path.warnings, "has no property \"integrator\""))
      << path_in_path.warnings;
  EXPECT_TRUE(
      contains(warnings_of("<integrator type='aov'><integrator type='path'/></integrator><shape "
                           "type='sphere'><medium name='interior' type='homogeneous'/></shape>"),
               "\"path\" of Mitsuba leaves out media"));
}

TEST(MitsubaStandIns, ProjectorsHaveTheirIrradianceOnAPlane) {
  const auto projector = [](const std::string& content) {
    return Imported(world("<emitter type='projector'><float name='scale' value='2'/>" + content +
                          "</emitter>"));
  };
  const auto bitmap = [&](const std::string& more) {
    return projector(
        "<float name='fov' value='30'/><texture name='irradiance' type='bitmap'><string "
        "name='filename' value='a.png'/>" +
        more + "</texture>");
  };
  const Imported plain = bitmap("");
  EXPECT_EQ(plain.warnings, "");
  const desc::Light light = plain.scene.lights.at(0);
  ASSERT_TRUE(light.node.is("projection"));
  EXPECT_EQ(light.node.number("fov"), 30.F);
  EXPECT_EQ(light.node.text("fov_axis"), "x");
  EXPECT_EQ(light.node.text("image_is"), "irradiance");
  EXPECT_EQ(light.node.color("intensity"), Vec3(2.F * kPi));
  EXPECT_TRUE(light.node.text("image").ends_with("a.png"));
  // The image begins at +x and +y in Mitsuba, at -x and -y here.
  expect_near(transform_vector(light.to_world, {1, 2, 3}), {-1, -2, 3});
  for (const auto& [said, exponent] :
       std::map<std::string, float>{{"<boolean name='raw' value='true'/>", 1.F},
                                    {"<float name='gamma' value='2.2'/>", 2.2F}}) {
    const Imported decoded = bitmap(said);
    EXPECT_EQ(decoded.warnings, "");
    EXPECT_EQ(decoded.scene.lights.at(0).node.number("decoding_exponent"), exponent);
  }
  const Imported moved = bitmap("<transform name='to_uv'><scale x='2'/></transform>");
  EXPECT_TRUE(contains(moved.warnings, "of the image of a projector is not supported"));
  EXPECT_TRUE(
      contains(bitmap("<float name='bogus' value='1'/>").warnings, "has no property \"bogus\""));
  const Imported board = projector(
      "<texture name='irradiance' type='checkerboard'><float name='bogus' value='1'/></texture>");
  EXPECT_TRUE(contains(board.warnings, "white light stands in")) << board.warnings;
  EXPECT_EQ(std::count(board.warnings.begin(), board.warnings.end(), '\n'), 1) << board.warnings;
  const desc::Node even = projector(
                              "<rgb name='irradiance' value='1 2 3'/><string "
                              "name='focal_length' value='50mm'/><transform "
                              "name='to_world'><scale z='5'/></transform>")
                              .scene.lights.at(0)
                              .node;
  expect_near(even.color("intensity"), Vec3(10, 20, 30) * kPi);
  EXPECT_EQ(even.text("fov_axis"), "diagonal");
  EXPECT_NEAR(even.number("fov"), 46.79F, 0.01F);
}

TEST(MitsubaStandIns, CollimatedBeamsHaveTheirPower) {
  const Imported beam(
      world("<emitter type='collimated'><rgb name='power' value='1 2 3'/></emitter>"));
  const desc::Node& spot = beam.scene.lights.at(0).node;
  ASSERT_TRUE(spot.is("spot"));
  EXPECT_EQ(spot.number("cone_angle"), 0.5F);
  // Into a cone of half a degree, which is about a disk of that radius.
  const float radius = 0.5F * kPi / 180.F;
  expect_near(spot.color("intensity") * (kPi * radius * radius), {1, 2, 3}, 1e-2F);
}

TEST(MitsubaStandIns, TelecentricCamerasAreOrthographicWithALens) {
  const Imported seen = seen_through(
      "<sensor type='telecentric'><float name='aperture_radius' value='0.5'/><float "
      "name='focus_distance' value='7'/></sensor>");
  EXPECT_EQ(seen.warnings, "");
  const auto& camera = std::get<desc::OrthographicCamera>(seen.scene.camera.node);
  EXPECT_EQ(camera.lens_radius, 0.5F);
  EXPECT_EQ(camera.focal_distance, 7.F);
  EXPECT_TRUE(contains(seen_through("<sensor type='perspective'><float name='aperture_radius' "
                                    "value='0.5'/></sensor>")
                           .warnings,
                       "has no property \"aperture_radius\""))
      << "a camera without a lens";
}

TEST(MitsubaStandIns, UnsupportedOptionsOfSensorsAreWarnings) {
  EXPECT_TRUE(contains(seen_through("<sensor type='perspective'><spectrum name='srf' "
                                    "value='400:1 700:0'/></sensor>")
                           .warnings,
                       "\"srf\" is not supported"));
  const Imported both = seen_through(
      "<sensor type='perspective'><float name='fov' value='40'/><string name='focal_length' "
      "value='20mm'/></sensor>");
  EXPECT_TRUE(contains(both.warnings, "a field of view and a focal length: the former counts"))
      << both.warnings;
}

TEST(MitsubaStandIns, MergesAreTheirParts) {
  const desc::SceneDesc scene = scene_of(
      "<shape type='merge'><shape type='sphere' id='a'/><shape type='merge'><shape type='cube' "
      "id='b'/></shape></shape>");
  ASSERT_EQ(scene.shapes.size(), 3U);
  EXPECT_EQ(scene.shapes[0].name, "a");
  EXPECT_EQ(scene.shapes[1].name, "b");
}

TEST(MitsubaStandIns, CachesOfVolumesAreTheirContent) {
  const desc::SceneDesc scene = scene_of(
      "<shape type='cube'><medium type='heterogeneous' name='interior'><volume name='sigma_t' "
      "type='volcache'><volume type='volcache'><volume type='constvolume'><float name='value' "
      "value='4'/></volume></volume></volume><float name='albedo' value='0.25'/></medium></shape>");
  expect_near(scene.media.at(0).sigma_s, Vec3(1.F));
  expect_near(scene.media.at(0).sigma_a, Vec3(3.F));
}

TEST(MitsubaStandIns, MotionIsFrozenAtItsStart) {
  const Imported moving(
      world("<shape type='sphere'><animation name='to_world'><transform time='0'><translate "
            "x='3'/></transform><transform time='1'><translate x='9'/></transform></animation>"
            "</shape>"));
  expect_near(transform_point(moving.scene.shapes.at(0).to_world, {0, 0, 0}), {3, 0, 0});
}

TEST(MitsubaStandIns, PhongsAreCoatsOfLikeRoughness) {
  const MaterialOf phong(
      "<bsdf type='phong'><float name='exponent' value='30'/><rgb name='diffuse_reflectance' "
      "value='0.1 0.2 0.3'/><rgb name='specular_reflectance' value='0.4'/></bsdf>");
  ASSERT_TRUE(phong.node().is("coated_diffuse"));
  EXPECT_EQ(phong.node().number("roughness"), 0.25F);  // √(2 / 32)
  expect_near(phong.node().color("diffuse_reflectance"), {0.1F, 0.2F, 0.3F});
  expect_near(phong.node().color("glossy_reflectance"), Vec3(0.4F));
}

TEST(MitsubaStandIns, FiltersAreThoseOfTheirNames) {
  const auto filter = [](const std::string& rfilter) {
    const Imported seen = seen_through("<sensor type='perspective'><film type='hdrfilm'>" +
                                       rfilter + "</film></sensor>");
    EXPECT_EQ(seen.warnings, "");
    return seen.scene.film.filter;
  };
  const desc::Filter usual = filter("<rfilter type='mitchell'/>");
  EXPECT_FLOAT_EQ(std::get<desc::MitchellFilter>(usual.node).b, 1.F / 3.F);
  EXPECT_EQ(usual.radius, Vec2(2.F));
  const desc::Filter sharp = filter(
      "<rfilter type='mitchell'><float name='B' value='0.25'/><float name='C' value='0.5'/>"
      "</rfilter>");
  EXPECT_EQ(std::get<desc::MitchellFilter>(sharp.node).b, 0.25F);
  EXPECT_EQ(std::get<desc::MitchellFilter>(sharp.node).c, 0.5F);
  const desc::Filter spline = filter("<rfilter type='catmullrom'/>");
  EXPECT_EQ(std::get<desc::MitchellFilter>(spline.node).b, 0.F);
  EXPECT_EQ(std::get<desc::MitchellFilter>(spline.node).c, 0.5F);
  const desc::Filter lobes =
      filter("<rfilter type='lanczos'><integer name='lobes' value='4'/></rfilter>");
  EXPECT_EQ(std::get<desc::SincFilter>(lobes.node).lobes, 4.F);
  EXPECT_EQ(lobes.radius, Vec2(4.F));
}

/// Defaults of Mitsuba 0.6's film for matrices.
TEST(MitsubaStandIns, MatrixFilmsHaveMitsubasDefaults) {
  const Imported seen = seen_through("<sensor type='perspective'><film type='mfilm'/></sensor>");
  EXPECT_EQ(seen.scene.film.resolution, Vec2i(1, 1));
  EXPECT_TRUE(std::holds_alternative<desc::BoxFilter>(seen.scene.film.filter.node));
  EXPECT_TRUE(contains(seen.warnings, "pictures of luminance are not supported"));
}

TEST(MitsubaStandIns, DaylightHasTheColourThatItIsGiven) {
  const desc::SceneDesc scene = scene_of(
      "<emitter type='constant'><spectrum name='radiance' type='d65'><rgb name='color' "
      "value='1 2 3'/><float name='scale' value='2'/></spectrum></emitter>"
      "<emitter type='constant'><spectrum name='radiance' type='d65'/></emitter>");
  EXPECT_EQ(scene.lights.at(0).node.color("radiance"), Vec3(2, 4, 6));
  EXPECT_EQ(scene.lights.at(1).node.color("radiance"), Vec3(1.F));
}

TEST(MitsubaStandIns, DuplicateCoefficientsAreWarnings) {
  const auto medium = [](const std::string& version, const std::string& content) {
    return Imported("<scene version='" + version +
                    "'><sensor type='perspective'/><shape type='cube'><medium "
                    "type='homogeneous' name='interior'>" +
                    content + "</medium></shape></scene>");
  };
  const std::string extinction = "<rgb name='sigma_t' value='2 4 6'/>";
  const std::string scattering = "<rgb name='sigma_s' value='1 2 3'/>";
  const std::string preset = "<string name='material' value='Skin2'/>";
  for (const char* version : {"0.6.0", "3.0.0"}) {
    const Imported both = medium(version, extinction + scattering);
    EXPECT_TRUE(contains(both.warnings, "are left out beside \"sigma_t\"")) << both.warnings;
    expect_near(both.scene.media.at(0).sigma_a + both.scene.media.at(0).sigma_s, {2, 4, 6}, 1e-5F);
    EXPECT_EQ(medium(version, extinction).warnings, "");
    EXPECT_EQ(medium(version, scattering).warnings, "");
  }
  const Imported beside = medium("0.6.0", preset + scattering);
  EXPECT_TRUE(
      contains(beside.warnings, "beside coefficients a preset is only what they leave open"))
      << beside.warnings;
  expect_near(beside.scene.media.at(0).sigma_s, {1, 2, 3});
  EXPECT_EQ(medium("0.6.0", preset).warnings, "");
}

}  // namespace
}  // namespace ajar::mitsuba
