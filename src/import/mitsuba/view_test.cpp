// Lights, camera, film, and render settings of a scene.
#include <cmath>

#include "import/mitsuba/import_test_support.h"

namespace ajar::mitsuba {
namespace {

desc::SceneDesc seen_by(const std::string& sensor) {
  Warnings warnings;
  desc::SceneDesc scene = import_with(
      "<scene version=\"3.0.0\">" + sensor + "<shape type=\"sphere\"/></scene>", warnings);
  for (const std::string& message : warnings.messages()) ADD_FAILURE() << message;
  return scene;
}

const std::string kWide =
    "<film type=\"hdrfilm\"><integer name=\"width\" value=\"400\"/><integer name=\"height\" "
    "value=\"200\"/></film>";

/// Field of view of the shorter side of a film of 400 × 200.
float fov_of(const std::string& properties) {
  const desc::SceneDesc scene =
      seen_by("<sensor type=\"perspective\">" + kWide + properties + "</sensor>");
  return std::get<desc::PerspectiveCamera>(scene.camera.node).fov;
}

float degrees(float tangent) { return 2.F * std::atan(tangent) * 180.F / kPi; }
float tangent(float degrees) { return std::tan(0.5F * degrees * kPi / 180.F); }

TEST(MitsubaView, CamerasAreNotMirrored) {
  const desc::SceneDesc scene = seen_by(
      "<sensor type=\"perspective\"><transform name=\"to_world\"><lookat origin=\"0, 0, 5\" "
      "target=\"0, 0, 0\" up=\"0, 1, 0\"/></transform></sensor>");
  // Looking along -z with +y up, +x is to the right in Mitsuba's right-handed world.
  const Mat4& m = scene.camera.to_world;
  expect_near(transform_point(m, {0, 0, 0}), {0, 0, 5});
  expect_near(transform_vector(m, {0, 0, 1}), {0, 0, -1});
  expect_near(transform_vector(m, {1, 0, 0}), {1, 0, 0});
  expect_near(transform_vector(m, {0, 1, 0}), {0, 1, 0});
}

TEST(MitsubaView, DefaultSensorLooksAlongZ) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      "<scene version=\"3.0.0\"><shape type=\"sphere\"><point name=\"center\" x=\"5\" y=\"1\" "
      "z=\"2\"/><float name=\"radius\" value=\"3\"/></shape></scene>",
      warnings);
  EXPECT_TRUE(contains(warnings.messages().front(), "there is no sensor"));
  const Mat4& m = scene.camera.to_world;
  expect_near(transform_point(m, {0, 0, 0}), {5, 1, -1 - 3 / tangent(45.F)});
  expect_near(transform_vector(m, {0, 0, 1}), {0, 0, 1});
  expect_near(transform_vector(m, {0, 1, 0}), {0, 1, 0});
  EXPECT_NEAR(std::get<desc::PerspectiveCamera>(scene.camera.node).fov,
              degrees(tangent(45.F) * 0.75F), 1e-3F);
}

TEST(MitsubaView, SurfaceOnlyIntegratorsAreAWarning) {
  const auto warnings = [](const std::string& integrator) {
    return warnings_of("<integrator type=\"" + integrator +
                       "\"/><shape type=\"sphere\"><medium name=\"interior\" "
                       "type=\"homogeneous\"/></shape>");
  };
  EXPECT_TRUE(contains(warnings("path"), "\"path\" of Mitsuba leaves out media"));
  EXPECT_FALSE(contains(warnings("volpath"), "leaves out media"));
}

TEST(MitsubaView, PanoramasHaveMinusZAtTheirEdgeAndPlusXAfterAQuarter) {
  const Mat4 m = seen_by("<sensor type=\"spherical\"/>").camera.to_world;
  // Our panorama begins at +x and turns toward +z.
  expect_near(transform_vector(m, {1, 0, 0}), {0, 0, -1});
  expect_near(transform_vector(m, {0, 0, 1}), {1, 0, 0});
  expect_near(transform_vector(m, {0, 1, 0}), {0, 1, 0});
}

TEST(MitsubaView, FieldsOfViewAreOfTheAxisThatIsNamed) {
  const std::string sixty = "<float name=\"fov\" value=\"60\"/>";
  const auto along = [&](const std::string& axis) {
    return fov_of(sixty + "<string name=\"fov_axis\" value=\"" + axis + "\"/>");
  };
  EXPECT_NEAR(fov_of(sixty), degrees(tangent(60.F) / 2.F), 1e-3F);
  EXPECT_NEAR(along("x"), degrees(tangent(60.F) / 2.F), 1e-3F);
  EXPECT_NEAR(along("larger"), degrees(tangent(60.F) / 2.F), 1e-3F);
  EXPECT_NEAR(along("y"), 60.F, 1e-3F);
  EXPECT_NEAR(along("smaller"), 60.F, 1e-3F);
  EXPECT_NEAR(along("diagonal"), degrees(tangent(60.F) / std::sqrt(5.F)), 1e-3F);
}

TEST(MitsubaView, AxesMayHaveCapitals) {
  const std::string fov = "<float name=\"fov\" value=\"60\"/><string name=\"fovAxis\" value=";
  EXPECT_EQ(fov_of(fov + "\"Y\"/>"), fov_of(fov + "\"y\"/>"));
  EXPECT_NE(fov_of(fov + "\"Y\"/>"), fov_of(fov + "\"x\"/>"));
}

TEST(MitsubaView, FocalLengthsAreOfAFilmOf35Millimetres) {
  const float half_diagonal = 0.5F * std::hypot(36.F, 24.F);
  EXPECT_NEAR(fov_of("<string name=\"focalLength\" value=\"35mm\"/>"),
              degrees(half_diagonal / 35.F / std::sqrt(5.F)), 1e-3F);
  EXPECT_NEAR(fov_of(""), degrees(half_diagonal / 50.F / std::sqrt(5.F)), 1e-3F);
}

/// An offset is added to the place on the film, as fractions of it from the upper left corner.
TEST(MitsubaView, PrincipalPointsShiftThePictureLeftAndUp) {
  const desc::SceneDesc scene =
      seen_by("<sensor type=\"perspective\">" + kWide +
              "<float name=\"principal_point_offset_x\" value=\"0.25\"/>"
              "<float name=\"principal_point_offset_y\" value=\"0.125\"/></sensor>");
  const auto& window = std::get<desc::PerspectiveCamera>(scene.camera.node).window;
  ASSERT_TRUE(window);
  // The axis is a quarter of the film from its left edge, and 3/8 of it from the upper one.
  EXPECT_FLOAT_EQ(-window->x_min / (window->x_max - window->x_min), 0.25F);
  EXPECT_FLOAT_EQ(window->y_max / (window->y_max - window->y_min), 0.375F);
}

TEST(MitsubaView, LensesAndOrthographicWindows) {
  const desc::SceneDesc lens = seen_by(
      "<sensor type=\"thinlens\"><float name=\"fov\" value=\"40\"/><float name=\"aperture_radius\" "
      "value=\"0.5\"/><float name=\"focus_distance\" value=\"7\"/></sensor>");
  const auto& camera = std::get<desc::PerspectiveCamera>(lens.camera.node);
  EXPECT_EQ(camera.lens_radius, 0.5F);
  EXPECT_EQ(camera.focal_distance, 7.F);
  const desc::SceneDesc far = seen_by(
      "<sensor type=\"thinlens\"><float name=\"aperture_radius\" value=\"0.5\"/><float "
      "name=\"farClip\" value=\"20000\"/></sensor>");
  EXPECT_EQ(std::get<desc::PerspectiveCamera>(far.camera.node).focal_distance, 2e4F)
      << "sharp at the far clip plane if nothing is said";
  const desc::SceneDesc flat = seen_by("<sensor type=\"orthographic\">" + kWide + "</sensor>");
  const auto& window = std::get<desc::OrthographicCamera>(flat.camera.node).window;
  EXPECT_EQ(window->x_max, 1.F);
  EXPECT_EQ(window->y_max, 0.5F);
}

TEST(MitsubaView, FilmsHaveACropAndAFilter) {
  const desc::SceneDesc scene = seen_by(
      "<sensor type=\"perspective\"><film type=\"hdrfilm\"><integer name=\"width\" value=\"100\"/>"
      "<integer name=\"height\" value=\"50\"/><integer name=\"crop_offset_x\" value=\"25\"/>"
      "<integer name=\"crop_width\" value=\"50\"/><rfilter type=\"gaussian\"><float "
      "name=\"stddev\" value=\"0.5\"/></rfilter></film><sampler type=\"independent\"><integer "
      "name=\"sample_count\" value=\"32\"/></sampler></sensor>");
  EXPECT_EQ(scene.film.resolution, Vec2i(100, 50));
  EXPECT_EQ(scene.film.crop[0], 0.25F);
  EXPECT_EQ(scene.film.crop[1], 0.75F);
  EXPECT_EQ(scene.film.crop[3], 1.F);
  EXPECT_EQ(std::get<desc::GaussianFilter>(scene.film.filter.node).falloff, 2.F);
  EXPECT_EQ(scene.film.filter.radius, Vec2(2.F));
  EXPECT_EQ(scene.hints.samples_per_pixel, 32);
  EXPECT_EQ(scene.hints.sampler, "independent");
  EXPECT_TRUE(contains(
      error_of("<scene version=\"3.0.0\"><sensor type=\"perspective\"><film type=\"hdrfilm\">"
               "<integer name=\"width\" value=\"0\"/></film></sensor></scene>"),
      "\"width\" must be 1 to 65536"));
}

std::string with_film(const std::string& film) {
  return "<scene version=\"0.6.0\"><sensor type=\"perspective\">" + film +
         "</sensor><shape type=\"sphere\"/></scene>";
}

TEST(MitsubaFilm, ExposureOfDisplaysMultipliesAndToneMapsAreWarnings) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      with_film("<film type=\"ldrfilm\"><float name=\"exposure\" value=\"-2\"/></film>"), warnings);
  EXPECT_EQ(scene.film.scale, 0.25F);
  const auto warnings_with = [](const std::string& film) {
    return warnings_in([&](Warnings& remarks) { import_with(with_film(film), remarks); });
  };
  EXPECT_TRUE(contains(warnings_with("<film type=\"ldrfilm\"><string name=\"tonemapMethod\" "
                                     "value=\"reinhard\"/></film>"),
                       "the tone map \"reinhard\" is not supported"));
  EXPECT_TRUE(contains(warnings_with("<film type=\"specfilm\"/>"), "pictures of wavelengths"));
  EXPECT_TRUE(contains(
      error_of(with_film("<film type=\"ldrfilm\"><float name=\"exposure\" value=\"999\"/></film>")),
      "beyond what a float holds"));
}

TEST(MitsubaView, FilmsHaveMitsubasDefaultSize) {
  for (const char* film : {"", "<film type=\"hdrfilm\"/>"}) {
    const desc::Film seen =
        seen_by("<sensor type=\"perspective\">" + std::string(film) + "</sensor>").film;
    EXPECT_EQ(seen.resolution, Vec2i(768, 576));
    EXPECT_TRUE(std::holds_alternative<desc::GaussianFilter>(seen.filter.node));
  }
}

TEST(MitsubaView, DepthsCountEdgesAsOursDo) {
  const auto hints = [](const std::string& integrator) { return scene_of(integrator).hints; };
  EXPECT_EQ(hints("<integrator type=\"path\"><integer name=\"maxDepth\" value=\"5\"/></integrator>")
                .max_depth,
            5);
  EXPECT_EQ(
      hints("<integrator type=\"bdpt\"><integer name=\"max_depth\" value=\"-1\"/></integrator>")
          .max_depth,
      std::nullopt);
  EXPECT_EQ(hints("<integrator type=\"direct\"/>").max_depth, 2);
  EXPECT_EQ(hints("<integrator type=\"bdpt\"/>").integrator, "bdpt");
  EXPECT_TRUE(contains(warnings_of("<integrator type=\"photonmapper\"/>"),
                       "unknown integrator \"photonmapper\""));
}

// ---------------------------------------------------------------- lights

desc::Light light_of(const std::string& emitter) { return scene_of(emitter).lights.front(); }

TEST(MitsubaLights, PointsAreWhereTheyAre) {
  const desc::Light point = light_of(
      "<emitter type=\"point\"><point name=\"position\" x=\"1\" y=\"2\" z=\"3\"/><rgb "
      "name=\"intensity\" value=\"4 5 6\"/></emitter>");
  expect_near(transform_point(point.to_world, {0, 0, 0}), {1, 2, 3});
  EXPECT_EQ(point.node.color("intensity"), Vec3(4.F, 5.F, 6.F));
}

TEST(MitsubaLights, SpotsShineAlongZFromTheAxisToTheirCutoff) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      world("<emitter type=\"spot\"><float name=\"cutoffAngle\" value=\"40\"/></emitter>"),
      warnings);
  EXPECT_EQ(scene.lights[0].node.number("cone_angle"), 40.F);
  EXPECT_EQ(scene.lights[0].node.number("falloff_start"), 30.F);
  EXPECT_EQ(scene.lights[0].node.text("falloff"), "angle");
}

TEST(MitsubaLights, DirectionalOnesShineAlongTheirDirection) {
  // Ours has the direction that light comes from at +z.
  expect_near(transform_vector(light_of("<emitter type=\"directional\"><vector name=\"direction\" "
                                        "value=\"0, -2, 0\"/></emitter>")
                                   .to_world,
                               {0, 0, 1}),
              {0, 1, 0});
  expect_near(transform_vector(light_of("<emitter type=\"directional\"><transform "
                                        "name=\"to_world\"><rotate x=\"1\" angle=\"90\"/>"
                                        "</transform></emitter>")
                                   .to_world,
                               {0, 0, 1}),
              {0, 1, 0});
}

TEST(MitsubaLights, EnvironmentMapsHaveMinusZAtTheirEdges) {
  const desc::Light map = light_of(
      "<emitter type=\"envmap\"><string name=\"filename\" value=\"sky.exr\"/><float name=\"scale\" "
      "value=\"2\"/></emitter>");
  EXPECT_EQ(map.node.color("radiance"), Vec3(2.F));
  EXPECT_TRUE(map.node.text("image").ends_with("sky.exr"));
  // Our map begins at +x and turns toward +y, its upper row is at +z. Mitsuba's has u = 0 at -z,
  // u = 1/4 at +x, and its upper row at +y.
  expect_near(transform_vector(map.to_world, {1, 0, 0}), {0, 0, -1});
  expect_near(transform_vector(map.to_world, {0, 1, 0}), {1, 0, 0});
  expect_near(transform_vector(map.to_world, {0, 0, 1}), {0, 1, 0});
  EXPECT_TRUE(map.node.flag("rows_at_poles"));
}

TEST(MitsubaLights, BlackBodiesHaveMitsubasUnits) {
  const desc::Light sky = light_of(
      "<emitter type=\"constant\"><blackbody name=\"radiance\" temperature=\"5500K\" "
      "scale=\"0.001\"/></emitter>");
  // Planck's law at 555 nm and 5500 K: 2.0e13 W/(m² sr m), that is 20200 per nm.
  EXPECT_NEAR(sky.node.color("radiance").y, 20.2F, 0.6F);
}

/// Elevation of the sun, for skies; where the light of the sun comes from, for suns.
desc::SceneDesc daylight_of(const std::string& inside, const std::string& version = "3.0.0") {
  Warnings warnings;
  return import_with("<scene version=\"" + version + "\"><emitter type=\"sunsky\">" + inside +
                         "</emitter><sensor type=\"perspective\"/><shape type=\"sphere\"/></scene>",
                     warnings);
}

TEST(MitsubaLights, SkiesAreClearOnesWithTheSunInTheWorldsDirection) {
  for (const std::string transform :
       {"", "<transform name=\"to_world\"><rotate x=\"1\" angle=\"-90\"/></transform>"}) {
    const desc::SceneDesc scene =
        daylight_of("<vector name=\"sunDirection\" x=\"0\" y=\"0.6\" z=\"0.8\"/>" + transform);
    ASSERT_EQ(scene.lights.size(), 2U);
    const desc::Light& sky = scene.lights[0];
    ASSERT_TRUE(sky.node.is("sky"));
    EXPECT_EQ(sky.node.number("turbidity"), 3.F);
    // The pole is z, turned to y by the transform; the sun is over x.
    const Vec3 up = transform.empty() ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
    const float height = dot(up, Vec3(0.F, 0.6F, 0.8F));
    expect_near(transform_vector(sky.to_world, {0, 0, 1}), up);
    expect_near(transform_vector(sky.to_world, {1, 0, 0}),
                normalize(Vec3(0.F, 0.6F, 0.8F) - up * height));
    EXPECT_NEAR(std::sin(sky.node.number("elevation") * kPi / 180.F), height, 1e-5F);
    expect_near(transform_vector(scene.lights[1].to_world, {0, 0, 1}), {0.F, 0.6F, 0.8F});
  }
}

TEST(MitsubaLights, SunsFollowTheDate) {
  // Noon at the equator in June: the sun is in the north, 23.4 degrees from the zenith.
  const std::string june =
      "<integer name=\"month\" value=\"6\"/><integer name=\"day\" value=\"21\"/><float "
      "name=\"hour\" "
      "value=\"12\"/><float name=\"latitude\" value=\"0\"/><float name=\"longitude\" value=\"0\"/>"
      "<float name=\"timezone\" value=\"0\"/>";
  const float sine = std::sin(23.44F * kPi / 180.F);
  const float cosine = std::cos(23.44F * kPi / 180.F);
  const auto toward = [&](const std::string& version) {
    return transform_vector(daylight_of(june, version).lights.at(1).to_world, {0, 0, 1});
  };
  expect_near(toward("0.6.0"), {0.F, cosine, -sine}, 0.02F);
  expect_near(toward("3.0.0"), {-sine, 0.F, cosine}, 0.02F);
  // By night there is nothing.
  EXPECT_TRUE(daylight_of("<float name=\"hour\" value=\"0\"/>").lights.empty());
}

TEST(MitsubaLights, SkiesWarnOfTheirReplacement) {
  const std::string said = warnings_of(
      "<emitter type=\"sunsky\"><float name=\"turbidity\" value=\"1\"/><float name=\"stretch\" "
      "value=\"1.5\"/><float name=\"turbidty\" value=\"1\"/></emitter>");
  for (const char* part : {"Preetham", "the sun is a point", "the nearest from 2 to 10",
                           "black there", "did you mean \"turbidity\"?"}) {
    EXPECT_TRUE(contains(said, part)) << part << "\n" << said;
  }
}

TEST(MitsubaLights, UnknownOnesAreLeftOutWithAWarning) {
  EXPECT_TRUE(contains(warnings_of("<emitter type=\"pint\"/>"), "did you mean \"point\"?"));
}

}  // namespace
}  // namespace ajar::mitsuba
