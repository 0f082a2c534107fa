// Directives, films, cameras and shapes of pbrt-v4.
#include "import/common/opacity.h"
#include "import/pbrt/v4_test_support.h"

namespace ajar {
namespace {

desc::SceneDesc with_v4_options(const std::string& options) {
  Warnings warnings;
  desc::SceneDesc scene =
      import_with(options + " WorldBegin Material \"diffuse\" Shape \"sphere\"", warnings);
  for (const std::string& message : warnings.messages()) ADD_FAILURE() << message;
  return scene;
}

TEST(Pbrt4Film, HasTheDefaultsOfPbrt) {
  const desc::SceneDesc s = with_v4_options("Camera \"perspective\"");
  EXPECT_EQ(s.film.resolution, Vec2i(1280, 720));
  EXPECT_EQ(s.film.scale, 1.F);
  ASSERT_TRUE(std::holds_alternative<desc::GaussianFilter>(s.film.filter.node));
  EXPECT_EQ(std::get<desc::GaussianFilter>(s.film.filter.node).falloff, 2.F);
  EXPECT_EQ(s.film.filter.radius, Vec2(1.5F));
}

TEST(Pbrt4Film, ExposureIsIsoTimesTime) {
  const auto scale = [](const std::string& options) { return with_v4_options(options).film.scale; };
  EXPECT_FLOAT_EQ(scale("Film \"rgb\" \"float iso\" 400 Camera \"perspective\""), 4.F);
  EXPECT_FLOAT_EQ(scale("Film \"rgb\" Camera \"perspective\" \"float shutterclose\" 0.25"), 0.25F);
  EXPECT_FLOAT_EQ(scale("Camera \"perspective\" \"float shutteropen\" 1 \"float shutterclose\" 3 "
                        "Film \"rgb\" \"float iso\" 50"),
                  1.F);
  EXPECT_TRUE(contains(error_of("Film \"rgb\" Camera \"perspective\" \"float shutterclose\" 0"),
                       "the shutter closes before it opens"));
}

TEST(Pbrt4Film, PixelBoundsAreACropWindow) {
  const desc::SceneDesc s = with_v4_options(
      "Film \"rgb\" \"integer xresolution\" 200 \"integer yresolution\" 100 \"integer "
      "pixelbounds\" [50 100 25 75] Camera \"perspective\"");
  EXPECT_EQ(s.film.crop[0], 0.25F);
  EXPECT_EQ(s.film.crop[1], 0.5F);
  EXPECT_EQ(s.film.crop[2], 0.25F);
  EXPECT_EQ(s.film.crop[3], 0.75F);
}

TEST(Pbrt4Film, FiltersHaveRadiiAndSigma) {
  const desc::SceneDesc s = with_v4_options(
      "PixelFilter \"gaussian\" \"float xradius\" 3 \"float sigma\" 1 Camera \"perspective\"");
  EXPECT_EQ(s.film.filter.radius, Vec2(3.F, 1.5F));
  EXPECT_EQ(std::get<desc::GaussianFilter>(s.film.filter.node).falloff, 0.5F);
}

TEST(Pbrt4Options, OfPbrtAreAccepted) {
  const desc::SceneDesc s = with_v4_options(
      "Option \"integer seed\" 3 Option \"bool disablepixeljitter\" false Film \"rgb\" "
      "Sampler \"zsobol\" \"integer pixelsamples\" 8 Integrator \"volpath\" \"integer maxdepth\" 7 "
      "Camera \"spherical\" \"string mapping\" \"equirectangular\" "
      "ColorSpace \"srgb\" Accelerator \"bvh\"");
  EXPECT_EQ(s.hints.samples_per_pixel, 8);
  EXPECT_EQ(s.hints.max_depth, 8);
  EXPECT_EQ(s.hints.integrator, "pt");
  EXPECT_TRUE(std::holds_alternative<desc::EnvironmentCamera>(s.camera.node));
  EXPECT_EQ(v4_warnings("", {}), "");
  const std::string rest = " Film \"rgb\" Camera \"perspective\" WorldBegin Shape \"sphere\"";
  EXPECT_EQ(warnings_of("Option \"seed\" 3 Option \"disablepixeljitter\" false Option "
                        "\"rendercoordsys\" \"world\" Option \"forcediffuse\" false" +
                        rest),
            "");
  EXPECT_TRUE(contains(warnings_of("Option \"disablepixeljitter\" true" + rest),
                       "the option \"disablepixeljitter\" is not supported"));
  EXPECT_TRUE(contains(error_of("Option \"seed\"" + rest),
                       "test.pbrt:1:8: the option \"seed\" has no value"));
  EXPECT_TRUE(contains(warnings_of("Option \"forcediffuse\" true" + rest),
                       "test.pbrt:1:8: the option \"forcediffuse\" is not supported"));
  EXPECT_TRUE(contains(warnings_of("Option \"integer sead\" 3 Film \"rgb\" Camera \"perspective\" "
                                   "WorldBegin Shape \"sphere\""),
                       "test.pbrt:1:8: unknown option \"sead\"; did you mean \"seed\"?"));
}

TEST(Pbrt4Directives, NeedNoWorldEnd) { EXPECT_EQ(v4_warnings(""), ""); }

TEST(Pbrt4Directives, UnknownOnesAreSkippedWithTheirPlace) {
  const std::string told =
      v4_warnings("Shappe \"disk\" \"float radius\" [ 3 ]\nMaterial \"diffuse\"");
  EXPECT_TRUE(
      contains(told, "test.pbrt:2:1: unknown directive \"Shappe\"; did you mean \"Shape\"?"))
      << told;
  EXPECT_TRUE(contains(v4_warnings("Shape \"torus\" \"float radius\" 3"),
                       "test.pbrt:2:1: unknown shape \"torus\""));
  EXPECT_TRUE(contains(v4_warnings("Shape \"sphere\" \"double radius\" 3"),
                       "test.pbrt:2:16: unknown parameter type \"double\""));
}

TEST(Pbrt4Attribute, GivesDefaultsWithinItsBlock) {
  const desc::SceneDesc s = v4_scene(
      "Attribute \"shape\" \"float radius\" 5 \"float height\" 2 "
      "Attribute \"material\" \"float eta\" 1.3 Attribute \"light\" \"float scale\" 7 "
      "Material \"dielectric\" LightSource \"point\" "
      "AttributeBegin Attribute \"shape\" \"float radius\" 6 "
      "Shape \"disk\" Shape \"disk\" \"float radius\" 7 AttributeEnd Shape \"disk\"");
  EXPECT_EQ(s.shapes[0].node.number("radius"), 6.F);
  EXPECT_EQ(s.shapes[0].node.number("height"), 2.F);
  EXPECT_EQ(s.shapes[1].node.number("radius"), 7.F);
  EXPECT_EQ(s.shapes[2].node.number("radius"), 5.F);
  EXPECT_EQ(material_node_of(s, s.shapes[0]).number("eta"), 1.3F);
  EXPECT_EQ(s.lights[0].node.color("intensity"), desc::Rgb(7.F));
  EXPECT_TRUE(contains(v4_warnings("Attribute \"shapes\" \"float radius\" 5"),
                       "unknown target of Attribute \"shapes\"; did you mean \"shape\"?"));
}

TEST(Pbrt4Attribute, IsAWarningWhereItIsUnused) {
  EXPECT_TRUE(
      contains(v4_warnings("Attribute \"shape\" \"float alhpa\" .5"),
               "test.pbrt:2:19: unused parameter \"float alhpa\"; did you mean \"alpha\"?"));
  EXPECT_TRUE(contains(v4_warnings("Attribute \"shape\" \"integer radius\" 5"),
                       "unused parameter \"integer radius\": it must be of another type here"));
  // One that some ask for is of use, and one that none could ask for may be.
  EXPECT_EQ(v4_warnings("Attribute \"shape\" \"float height\" 2 Shape \"disk\""), "");
  EXPECT_EQ(v4_warnings("Shape \"sphere\" AttributeBegin Attribute \"shape\" \"float alhpa\" .5 "
                        "AttributeEnd"),
            "");
}

TEST(Pbrt4Import, RestoresTheState) {
  const std::map<std::string, std::string> files = {
      {"part.pbrt", "Scale 2 2 2 Material \"dielectric\" Shape \"disk\""}};
  const desc::SceneDesc s = v4_scene("Import \"part.pbrt\" Shape \"sphere\"", files);
  EXPECT_TRUE(material_node_of(s, s.shapes[0]).is("dielectric"));
  EXPECT_EQ(transform_point(s.shapes[0].to_world, Vec3(1.F)), Vec3(2.F));
  EXPECT_TRUE(material_node_of(s, s.shapes[1]).is("diffuse"));
  EXPECT_EQ(transform_point(s.shapes[1].to_world, Vec3(1.F)), Vec3(1.F));
  EXPECT_TRUE(
      contains(error_of(v4_world("Import \"loop.pbrt\""), {{"loop.pbrt", "Import \"loop.pbrt\""}}),
               "loop.pbrt:1:1: \"loop.pbrt\" includes itself"));
  EXPECT_TRUE(
      contains(error_of(v4_world("AttributeBegin Import \"a.pbrt\""), {{"a.pbrt", "AttributeEnd"}}),
               "AttributeEnd, but the innermost open block is"));
}

TEST(PbrtInclude, MayGoOnWithTheParametersOfADirective) {
  const std::map<std::string, std::string> files = {
      {"density.pbrt", "\"float density\" [ 1 3 ]\n\"integer ny\" 1"},
      {"bad.pbrt", "\"float radius\" 2 Shape \"disk\""},
      {"loop.pbrt", "\"float radius\" 2 Include \"loop.pbrt\""}};
  Warnings warnings;
  const desc::SceneDesc s = import_with(
      world("MakeNamedMedium \"smoke\" \"string type\" \"heterogeneous\" \"integer nx\" 2\n"
            "Include \"density.pbrt\" \"rgb sigma_a\" [1 1 1]"),
      warnings, files);
  EXPECT_EQ(warnings.count(), 0U);
  EXPECT_EQ(s.media[0].density->grid->values.size(), 2U);
  EXPECT_TRUE(contains(error_of(world("Shape \"sphere\" Include \"bad.pbrt\""), files),
                       "bad.pbrt:1:18: expected parameters only"));
  EXPECT_TRUE(contains(error_of(world("Shape \"sphere\" Include \"loop.pbrt\""), files),
                       "includes itself"));
}

TEST(Pbrt4Shapes, BilinearMeshesAreTriangles) {
  const auto mesh = [](const std::string& points) {
    return v4_scene("Shape \"bilinearmesh\" \"point3 P\" [" + points + "]")
        .shapes.at(0)
        .node.mesh("mesh");
  };
  const desc::MeshPointer flat = mesh("0 0 0 1 0 0 0 1 0 1 1 0");
  ASSERT_EQ(flat->indices.size(), 2U);
  // The normal is ∂p/∂u × ∂p/∂v.
  const auto& t = flat->indices[0];
  const Vec3 normal = cross(flat->positions[t.y] - flat->positions[t.x],
                            flat->positions[t.z] - flat->positions[t.x]);
  EXPECT_GT(normal.z, 0.F);
  EXPECT_EQ(flat->uvs[3], Vec2(1.F, 1.F));
  EXPECT_EQ(flat->positions[3], Vec3(1.F, 1.F, 0.F));
  EXPECT_EQ(mesh("0 0 0 1 0 0 0 1 0 1 1 1")->indices.size(), 128U);
  // Flat, but with an image that is not.
  EXPECT_EQ(v4_scene("Shape \"bilinearmesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0 1 1 0] \"point2 uv\" "
                     "[0 0 1 0 0 1 .5 .5]")
                .shapes.at(0)
                .node.mesh("mesh")
                ->indices.size(),
            128U);
  EXPECT_TRUE(contains(error_of(v4_world("Shape \"bilinearmesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0 1 "
                                         "1 0] \"integer indices\" [0 1 2 7]")),
                       "the index 7 is not one of 4 points"));
}

TEST(Pbrt4Shapes, PartlyTransparentOnesAreMixesWithNothing) {
  const desc::SceneDesc s = v4_scene(
      "Material \"conductor\" AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [4 4 4] Shape "
      "\"disk\" \"float alpha\" 0.5 AttributeEnd Shape \"disk\" \"float alpha\" 0.5 Shape \"disk\" "
      "\"float alpha\" 1 Shape \"disk\" \"float alpha\" 0");
  const desc::Node mix = material_node_of(s, s.shapes[0]);
  ASSERT_TRUE(mix.is("mix"));
  EXPECT_EQ(mix.color("amount"), Vec3(0.5F));
  EXPECT_TRUE(s.materials.at(static_cast<std::size_t>(mix.material("first"))).node.is("conductor"));
  EXPECT_EQ(s.shapes[1].material, s.shapes[0].material) << "made once";
  EXPECT_EQ(
      s.shapes[0].emission->node.color("scale") * s.shapes[0].emission->node.color("radiance"),
      Vec3(2.F));
  EXPECT_TRUE(material_node_of(s, s.shapes[2]).is("conductor"));
  EXPECT_TRUE(material_node_of(s, s.shapes[3]).is("conductor"));
  EXPECT_NE(s.shapes[3].alpha, desc::kNone);
  const desc::SceneDesc textured = v4_scene(
      "Texture \"t\" \"float\" \"checkerboard\" \"float tex1\" 0.25 Material \"diffuse\" Shape "
      "\"disk\" "
      "\"texture alpha\" \"t\"");
  EXPECT_TRUE(material_node_of(textured, textured.shapes[0]).is("mix"));
  EXPECT_NE(textured.shapes[0].alpha, desc::kNone);
  EXPECT_TRUE(contains(
      v4_warnings(
          "Texture \"t\" \"float\" \"checkerboard\" AreaLightSource \"diffuse\" Shape \"disk\" "
          "\"texture alpha\" \"t\""),
      "it shines as if it were 1"));
}

TEST(Pbrt4Media, HaveDefaultsAndPresets) {
  const auto medium = [](const std::string& parameters) {
    return v4_scene("MakeNamedMedium \"m\" " + parameters).media.at(0);
  };
  EXPECT_EQ(medium("\"string type\" \"homogeneous\"").sigma_a, desc::Rgb(1.F));
  const std::string coke = "\"string type\" \"homogeneous\" \"string preset\" \"Coke\" ";
  const desc::Rgb absorption(1.0014F, 1.6503F, 2.468F);
  expect_rgb(medium(coke + "\"float scale\" 10").sigma_a, absorption, 1e-4F);
  const std::string both = "MakeNamedMedium \"m\" " + coke + "\"rgb sigma_a\" [9 9 9]";
  EXPECT_EQ(v4_warnings(both), "test.pbrt:2:72: \"sigma_a\" is ignored: \"preset\" says it\n");
  expect_rgb(v4_scene_with_warnings(both).media.at(0).sigma_a, absorption * 0.1F, 1e-5F);
  const desc::SceneDesc grid = v4_scene(
      "MakeNamedMedium \"m\" \"string type\" \"uniformgrid\" \"integer nx\" 2 \"float density\" [1 "
      "3] \"rgb sigma_s\" [1 2 3]");
  EXPECT_EQ(grid.media[0].sigma_s, desc::Rgb(1.F, 2.F, 3.F));
  EXPECT_EQ(grid.media[0].density->grid->values, (std::vector<float>{1.F, 3.F}));
}

TEST(Pbrt4Media, HaveGridsOfColors) {
  const std::string medium = "MakeNamedMedium \"m\" \"string type\" \"rgbgrid\" \"integer nx\" 2 ";
  const desc::SceneDesc one = v4_scene(medium + "\"rgb sigma_a\" [1 2 3 3 4 5] \"float scale\" 2");
  EXPECT_EQ(one.media[0].sigma_a, desc::Rgb(2.F));
  EXPECT_EQ(one.media[0].sigma_s, desc::Rgb(2.F));
  const desc::DensityGrid& grid = *one.media[0].density->grid;
  EXPECT_TRUE(grid.values.empty());
  EXPECT_EQ(grid.absorption, (std::vector<Vec3>{{1, 2, 3}, {3, 4, 5}}));
  EXPECT_TRUE(grid.scattering.empty()) << "1 everywhere";
  const desc::SceneDesc both =
      v4_scene(medium + "\"rgb sigma_a\" [1 2 3 3 4 5] \"rgb sigma_s\" [0 1 0 1 0 2]");
  EXPECT_EQ(both.media[0].density->grid->scattering, (std::vector<Vec3>{{0, 1, 0}, {1, 0, 2}}));
  const desc::SceneDesc wide =
      v4_scene_with_warnings("ColorSpace \"rec2020\" " + medium + "\"rgb sigma_a\" [0 1 0 1 1 1]");
  const std::vector<Vec3>& colors = wide.media[0].density->grid->absorption;
  EXPECT_EQ(colors[0].x, 0.F) << "what Rec. 709 has as negative";
  expect_rgb(colors[1], desc::Rgb(1.F), 1e-3F);

  EXPECT_TRUE(contains(v4_warnings(medium + "\"rgb sigma_a\" [-1 2 3 3 -4 5]"),
                       "test.pbrt:2:1: 2 densities of this medium are negative"));
  const auto error = [&](const std::string& parameters) {
    return error_of(v4_world(medium + parameters));
  };
  EXPECT_TRUE(contains(error(""), "test.pbrt:2:1: a medium of type \"rgbgrid\" needs"));
  EXPECT_TRUE(contains(error("\"rgb sigma_a\" [1 2 3]"),
                       "test.pbrt:2:1: the medium has 1 colours of absorption, not 2 × 1 × 1"));
  EXPECT_TRUE(
      contains(error("\"rgb sigma_a\" [1 2 3] \"rgb sigma_s\" [0 1 0 1 0 2]"), "differ in size"));
}

TEST(Pbrt4Media, CameraMediumIsTheOutsideAtItsDirective) {
  Warnings warnings;
  const desc::SceneDesc s = import_with(
      "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" MediumInterface \"\" \"fog\" "
      "Camera \"perspective\" MediumInterface \"\" \"\" Film \"rgb\" WorldBegin Shape \"sphere\"",
      warnings);
  EXPECT_EQ(s.camera.medium, 0);
  EXPECT_EQ(s.shapes[0].outside, desc::kNone);
}

TEST(Pbrt4Directives, TransformBlocksKeepAllOfTheState) {
  const std::string body =
      "TransformBegin Material \"conductor\" AreaLightSource \"diffuse\" "
      "ReverseOrientation Scale 2 2 2 TransformEnd";
  const desc::SceneDesc scene = v4_scene(body);
  const desc::Shape& after = scene.shapes.back();
  EXPECT_TRUE(material_node_of(scene, after).is("diffuse"));
  EXPECT_FALSE(after.emission);
  EXPECT_FALSE(after.reverse_orientation);
  EXPECT_EQ(after.to_world, Mat4());
  // In pbrt-v3 only the transform comes back.
  Warnings warnings;
  const desc::SceneDesc v3 =
      import_with(world("TransformBegin Material \"mirror\" Scale 2 2 2 TransformEnd"), warnings);
  EXPECT_TRUE(material_node_of(v3, v3.shapes.back()).is("mirror"));
  EXPECT_EQ(v3.shapes.back().to_world, Mat4());
}

TEST(Pbrt4Options, UnsupportedOnesAreWarnings) {
  const auto warnings = [](const std::string& options) {
    return warnings_of(v4_world("", options));
  };
  EXPECT_TRUE(contains(warnings("Integrator \"path\" \"bool regularize\" true"),
                       "\"regularize\" is not supported"));
  EXPECT_EQ(warnings("Integrator \"path\" \"bool regularize\" false"), "");
  EXPECT_TRUE(contains(warnings("Accelerator \"bvh\" \"string splitmetod\" \"sah\""),
                       "unused parameter \"string splitmetod\"; did you mean \"splitmethod\"?"));
  EXPECT_TRUE(contains(warnings("Accelerator \"octree\""), "unknown accelerator \"octree\""));
}

TEST(Pbrt4Lamps, InvisibleOnesAreMadeVisible) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      v4_world("AreaLightSource \"diffuse\" Shape \"disk\" \"float alpha\" 0"), warnings);
  EXPECT_TRUE(contains(lines_of(warnings), "this lamp shines but is not seen in pbrt-v4"));
  const desc::Shape& lamp = scene.shapes.at(0);
  EXPECT_TRUE(lamp.emission);
  EXPECT_EQ(lamp.alpha, desc::kNone);
  // Interfaces between media would not shine.
  EXPECT_EQ(material_node_of(scene, lamp), clear_material(Passing::Uncounted));
}

TEST(Pbrt4Media, EmissiveOnesAreDarkWithAWarning) {
  EXPECT_TRUE(contains(v4_warnings("MakeNamedMedium \"m\" \"string type\" \"uniformgrid\" \"float "
                                   "density\" 1 \"float temperature\" 900"),
                       "test.pbrt:2:1: media that emit light are not supported: dark"));
  EXPECT_TRUE(
      contains(v4_warnings("MakeNamedMedium \"m\" \"string type\" \"rgbgrid\" \"integer nx\" "
                           "2 \"rgb sigma_a\" [1 1 1 1 1 1] \"rgb Le\" [0 0 0 1 1 1]"),
               "test.pbrt:2:1: media that emit light are not supported: dark"));
}

}  // namespace
}  // namespace ajar
