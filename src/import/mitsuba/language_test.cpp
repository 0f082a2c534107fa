// Common features of all plugins: parameters, includes, ids, colours, transforms, messages.
#include "color/color.h"
#include "import/mitsuba/import_test_support.h"
#include "import/mitsuba/names.h"

namespace ajar::mitsuba {
namespace {

/// The reflectance that this property gives.
Vec3 color_of(const std::string& property) {
  return MaterialOf("<bsdf type=\"diffuse\">" + property + "</bsdf>").node().color("reflectance");
}

/// The place of a cube with this transform.
Mat4 placed(const std::string& steps, const std::string& name = "to_world") {
  return scene_of("<shape type=\"cube\"><transform name=\"" + name + "\">" + steps +
                  "</transform></shape>")
      .shapes.front()
      .to_world;
}

TEST(MitsubaLanguage, NamesOfAllVersionsMeanTheSame) {
  EXPECT_EQ(snake_case("toWorld"), "to_world");
  EXPECT_EQ(snake_case("to_world"), "to_world");
  EXPECT_EQ(snake_case("intIOR"), "int_ior");
  EXPECT_EQ(snake_case("flipTexCoords"), "flip_tex_coords");
  for (const char* name : {"to_world", "int_ior", "sigma_t", "crop_offset_x"}) {
    EXPECT_EQ(snake_case(camel_case(name)), name);
  }
  expect_near(transform_point(placed("<translate x=\"3\"/>", "toWorld"), {0, 0, 0}), {3, 0, 0});
}

TEST(MitsubaLanguage, ParametersAreReplacedAndThoseFromOutsideComeFirst) {
  const std::string text =
      "<scene version=\"2.0.0\"><default name=\"r\" value=\"2\"/><default name=\"radius\" "
      "value=\"$r.5\"/><sensor type=\"perspective\"/><shape type=\"sphere\"><float name=\"radius\" "
      "value=\"$radius\"/></shape></scene>";
  Warnings warnings;
  EXPECT_EQ(import_with(text, warnings).shapes[0].node.number("radius"), 2.5F);
  EXPECT_EQ(import_with(text, warnings, {}, {{"r", "7"}}).shapes[0].node.number("radius"), 7.5F);
  EXPECT_EQ(warnings.count(), 0U);
}

TEST(MitsubaLanguage, ParametersWithoutValueAreErrorsWithTheNearestName) {
  EXPECT_EQ(error_of("<scene version=\"3.0.0\">\n <default name=\"depth\" value=\"4\"/>\n"
                     "  <integrator type=\"path\"><integer name=\"max_depth\" value=\"$dept\"/>"
                     "</integrator></scene>"),
            "test.xml:3:27: unknown parameter \"dept\"; did you mean \"depth\"? Valid: depth. "
            "<default> gives parameters a value, and so does -Dname=value");
}

TEST(MitsubaLanguage, UnknownParametersFromOutsideAreErrors) {
  const auto error_with = [](const std::string& text, const SceneDefinitions& definitions) {
    return error_in([&](Warnings& warnings) { import_with(text, warnings, {}, definitions); });
  };
  const std::string text = world(
      "<default name=\"depth\" value=\"4\"/><integrator type=\"path\">"
      "<integer name=\"max_depth\" value=\"$limit\"/></integrator>");
  EXPECT_EQ(error_with(text, {{"limit", "3"}}), "no error") << "used, not defined by the scene";
  EXPECT_EQ(error_with(text, {{"limit", "3"}, {"depth", "2"}}), "no error") << "defined, not used";
  EXPECT_EQ(
      error_with(text, {{"limit", "3"}, {"dept", "2"}}),
      "test.xml:1:1: -Ddept: unknown parameter \"dept\"; did you mean \"depth\"? Valid: depth, "
      "limit");
  EXPECT_EQ(error_with(world(""), {{"a", "1"}}), "test.xml:1:1: -Da: this scene has no parameters");
}

TEST(MitsubaLanguage, ParameterExpansionIsLimited) {
  std::string text = "<scene version=\"3.0.0\"><default name=\"a0\" value=\"xxxxxxxxxx\"/>";
  for (int i = 0; i < 30; ++i) {
    const std::string before = "$a" + std::to_string(i);
    text += "<default name=\"a" + std::to_string(i + 1) + "\" value=\"" + before + before + "\"/>";
  }
  EXPECT_TRUE(contains(error_of(text + "</scene>"), "longer than a million"));
}

TEST(MitsubaLanguage, IncludedFilesShareParametersIdsAndFolders) {
  const Files files = {
      {"parts/walls.xml",
       "<scene version=\"3.0.0\"><bsdf type=\"diffuse\" id=\"wall\"><rgb name=\"reflectance\" "
       "value=\"$white\"/></bsdf><shape type=\"obj\"><string name=\"filename\" "
       "value=\"m.obj\"/><bsdf type=\"twosided\"><ref id=\"wall\"/></bsdf></shape></scene>"},
      {"parts/m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}};
  const desc::SceneDesc scene = scene_of(
      "<default name=\"white\" value=\"0.25\"/><include filename=\"parts/walls.xml\"/>", files);
  ASSERT_EQ(scene.shapes.size(), 2U);
  EXPECT_EQ(scene.shapes[0].name, "m");
  EXPECT_EQ(scene.materials[0].node.color("reflectance"), Vec3(0.25F));
  EXPECT_EQ(scene.materials[0].name, "wall");
}

TEST(MitsubaLanguage, FilesThatIncludeThemselvesAreRefused) {
  const Files files = {{"a.xml", "<scene><include filename=\"b.xml\"/></scene>"},
                       {"b.xml", "<scene><include filename=\"a.xml\"/></scene>"}};
  EXPECT_EQ(error_of("<scene version=\"3.0.0\"><include filename=\"a.xml\"/></scene>", files),
            "b.xml:1:8: \"a.xml\" includes itself");
  EXPECT_TRUE(
      contains(error_of("<scene version=\"3.0.0\">\n<include filename=\"no.xml\"/></scene>"),
               "test.xml:2:1: cannot include this file"));
}

TEST(MitsubaLanguage, PipesAndDevicesAreNotRead) {
  EXPECT_TRUE(
      contains(error_of("<scene version=\"3.0.0\"><include filename=\"/dev/zero\"/></scene>"),
               "only regular files can be read"));
  EXPECT_TRUE(contains(
      warnings_of("<shape type=\"ply\"><string name=\"filename\" value=\"/dev/zero\"/></shape>"),
      "only regular files can be read"));
}

TEST(MitsubaLanguage, AliasesAndIdsAreFound) {
  const desc::SceneDesc scene = scene_of(
      "<bsdf type=\"conductor\" id=\"a\"><string name=\"material\" value=\"none\"/></bsdf>"
      "<alias id=\"a\" as=\"b\"/><shape type=\"sphere\"><ref id=\"b\"/></shape>");
  EXPECT_TRUE(
      scene.materials[static_cast<std::size_t>(scene.shapes[0].material)].node.is("mirror"));
  EXPECT_EQ(error_of(world("<bsdf type=\"diffuse\" id=\"wall\"/><shape type=\"sphere\">\n"
                           "<ref id=\"wal\"/></shape>")),
            "test.xml:3:1: unknown id \"wal\"; did you mean \"wall\"? Valid: wall");
}

TEST(MitsubaLanguage, MalformedXmlIsAnErrorWithLineAndColumn) {
  EXPECT_EQ(error_of("<scene version=\"3.0.0\">\n  <shape type=\"sphere\">\n</scene>"),
            "test.xml:3:3: this is not well-formed XML: Start-end tags mismatch");
  EXPECT_TRUE(contains(error_of(""), "test.xml:1:1: this is not well-formed XML"));
  EXPECT_TRUE(contains(error_of("<html/>"), "it begins with <html>, not with <scene>"));
}

TEST(MitsubaLanguage, EntitiesAreNotExpanded) {
  const std::string text =
      "<?xml version=\"1.0\"?><!DOCTYPE scene [<!ENTITY a SYSTEM \"/etc/passwd\">]>"
      "<scene version=\"3.0.0\"><sensor type=\"perspective\"/><shape type=\"sphere\" "
      "id=\"&a;\"/></scene>";
  Warnings warnings;
  EXPECT_EQ(import_with(text, warnings).shapes[0].name, "&a;");
}

TEST(MitsubaLanguage, DeepNestingIsRefused) {
  std::string body;
  for (int i = 0; i < 3000; ++i) body += "<bsdf type=\"twosided\">";
  for (int i = 0; i < 3000; ++i) body += "</bsdf>";
  EXPECT_TRUE(contains(error_of(world(body)), "nested too deeply"));
}

TEST(MitsubaLanguage, UnknownPropertiesAreWarningsWithTheNearestName) {
  EXPECT_EQ(warnings_of("<shape type=\"sphere\"><float name=\"radios\" value=\"2\"/></shape>"),
            "test.xml:2:22: <shape type=\"sphere\"> has no property \"radios\"; did you mean "
            "\"radius\"?: ignored\n");
  EXPECT_TRUE(contains(warnings_of("<mode type=\"final\"/>"), "<mode> is not an element"));
}

TEST(MitsubaLanguage, InvalidValuesAreErrors) {
  EXPECT_EQ(
      error_of(world("<shape type=\"sphere\"><float name=\"radius\" value=\"big\"/></shape>")),
      "test.xml:2:22: <float> \"radius\": \"value\" must be a number, not \"big\"");
  EXPECT_TRUE(
      contains(warnings_of("<shape type=\"sphere\"><string name=\"radius\" value=\"2\"/></shape>"),
               "\"radius\" must be a number: ignored"));
}

TEST(MitsubaLanguage, ColorsHaveManySpellings) {
  expect_near(color_of("<rgb name=\"reflectance\" value=\"0.1, 0.2, 0.3\"/>"), {0.1F, 0.2F, 0.3F});
  expect_near(color_of("<rgb name=\"reflectance\" value=\"0.1 0.2 0.3\"/>"), {0.1F, 0.2F, 0.3F});
  expect_near(color_of("<spectrum name=\"reflectance\" value=\"0.4\"/>"), Vec3(0.4F));
  expect_near(color_of("<float name=\"reflectance\" value=\"0.4\"/>"), Vec3(0.4F));
  expect_near(color_of("<rgb name=\"reflectance\" value=\"#ff8000\"/>"), {1.F, 128.F / 255.F, 0.F});
  // 128 of 255 by the sRGB curve.
  expect_near(color_of("<srgb name=\"reflectance\" value=\"#ff8000\"/>"), {1.F, 0.215861F, 0.F});
  expect_near(color_of("<xyz name=\"reflectance\" value=\"0.2 0.3 0.1\"/>"),
              Vec3(xyz_to_rgb({0.2, 0.3, 0.1})));
  expect_near(color_of("<spectrum type=\"uniform\" name=\"reflectance\"><float name=\"value\" "
                       "value=\"0.3\"/></spectrum>"),
              Vec3(0.3F));
  const double wavelengths[] = {400, 500, 600, 700};
  const double values[] = {0.1, 0.2, 0.6, 0.8};
  expect_near(
      color_of("<spectrum name=\"reflectance\" value=\"400:0.1, 500:0.2 600:0.6,700:0.8\"/>"),
      Vec3(sampled_to_rgb_in_daylight(wavelengths, values)));
}

TEST(MitsubaLanguage, TexturesSpectraAndNumbersNameTheSamePlugins) {
  const Files files = {{"a.png", ""}};
  const auto material = [&](const std::string& bsdf, const std::string& tag,
                            const std::string& name) {
    return MaterialOf("<bsdf type=\"" + bsdf + "\"><" + tag + " name=\"" + name +
                          "\" type=\"bitmap\"><string name=\"filename\" value=\"a.png\"/></" + tag +
                          "><bsdf type=\"diffuse\"/><bsdf type=\"diffuse\"/></bsdf>",
                      files);
  };
  for (const std::string tag : {"texture", "spectrum", "float", "rgb"}) {
    const MaterialOf color("<bsdf type=\"diffuse\"><" + tag +
                               " name=\"reflectance\" type=\"bitmap\"><string name=\"filename\" "
                               "value=\"a.png\"/></" +
                               tag + "></bsdf>",
                           files);
    EXPECT_EQ(color.warnings, "") << tag;
    EXPECT_TRUE(color.texture("reflectance").is("image")) << tag;
    const MaterialOf weight = material("blendbsdf", tag, "weight");
    EXPECT_EQ(weight.warnings, "") << tag;
    EXPECT_TRUE(weight.texture("amount").is("image")) << tag;
    EXPECT_EQ(color_of("<" + tag +
                       " name=\"reflectance\" type=\"srgb\"><rgb name=\"color\" "
                       "value=\"0.1 0.2 0.3\"/></" +
                       tag + ">"),
              Vec3(0.1F, 0.2F, 0.3F))
        << tag;
  }
  // By reference, and in another.
  const MaterialOf scaled(
      "<bsdf type=\"diffuse\"><spectrum name=\"reflectance\" type=\"scale\"><spectrum "
      "type=\"checkerboard\"><spectrum name=\"color0\" type=\"uniform\"><float name=\"value\" "
      "value=\"0.25\"/></spectrum></spectrum><float name=\"scale\" "
      "value=\"2\"/></spectrum></bsdf>");
  EXPECT_EQ(scaled.warnings, "");
  EXPECT_TRUE(scaled.texture("reflectance").is("product"));
  const desc::SceneDesc shared = scene_of(
      "<spectrum type=\"bitmap\" id=\"t\"><string name=\"filename\" value=\"a.png\"/></spectrum>" +
          sphere_of("<bsdf type=\"diffuse\"><ref id=\"t\" name=\"reflectance\"/></bsdf>"),
      files);
  EXPECT_TRUE(shared.textures.at(0).node.is("image"));
}

TEST(MitsubaLanguage, TheLastStepOfATransformIsAppliedLast) {
  expect_near(transform_point(placed("<scale x=\"2\"/><translate x=\"3\"/>"), {1, 1, 1}),
              {5, 1, 1});
  expect_near(transform_point(placed("<rotate z=\"1\" angle=\"90\"/>"), {1, 0, 0}), {0, 1, 0});
  expect_near(transform_point(placed("<scale value=\"2\"/>"), {1, 1, 1}), {2, 2, 2});
  expect_near(
      transform_point(placed("<matrix value=\"1 0 0 7 0 1 0 8 0 0 1 9 0 0 0 1\"/>"), {0, 0, 0}),
      {7, 8, 9});
}

TEST(MitsubaLanguage, MeaninglessAttributesAndPropertiesAreWarnings) {
  const auto expect_warning = [](const std::string& body, const std::string& text) {
    const std::string warnings = warnings_of(body);
    EXPECT_TRUE(contains(warnings, "test.xml:2:") && contains(warnings, text)) << warnings;
  };
  expect_warning("<shape type=\"sphere\" nam=\"a\"/>",
                 "<shape> has no attribute \"nam\"; did you mean \"name\"?");
  expect_warning(
      "<shape type=\"sphere\"><transform name=\"to_world\"><rotate x=\"1\" "
      "angel=\"9\"/></transform></shape>",
      "<rotate> has no attribute \"angel\"; did you mean \"angle\"?");
  expect_warning("<integrator type=\"path\"><integer name=\"max_deph\" value=\"3\"/></integrator>",
                 "has no property \"max_deph\"; did you mean \"max_depth\"?");
  expect_warning(
      "<sensor type=\"perspective\"><sampler type=\"independent\"><integer "
      "name=\"sampel_count\" value=\"3\"/></sampler></sensor>",
      "did you mean \"sample_count\"?");
  expect_warning(
      "<sensor type=\"perspective\"><film type=\"hdrfilm\"><string "
      "name=\"pixel_format\" value=\"luminance\"/></film></sensor>",
      "pictures of luminance are not supported");
  expect_warning("<sensor type=\"perspective\"><float name=\"near_clip\" value=\"1\"/></sensor>",
                 "\"near_clip\" is not supported: what is nearer is seen, too");
  EXPECT_FALSE(contains(warnings_of("<sensor type=\"perspective\"><float name=\"near_clip\" "
                                    "value=\"1\"/><float name=\"far_clip\" value=\"2\"/></sensor>"),
                        "has no property"));
  expect_warning(
      "<emitter type=\"envmap\"><string name=\"filename\" value=\"a.png\"/><float "
      "name=\"gamma\" value=\"2.2\"/></emitter>",
      "\"gamma\" is not supported");
}

TEST(MitsubaLanguage, DuplicatesAreWarnings) {
  EXPECT_TRUE(
      contains(warnings_of("<shape type=\"sphere\"><float name=\"radius\" value=\"1\"/><float "
                           "name=\"radius\" value=\"2\"/></shape>"),
               "test.xml:2:22: <shape type=\"sphere\"> has another \"radius\", which counts "
               "instead of this"));
  EXPECT_TRUE(contains(warnings_of("<integrator type=\"path\"/><integrator type=\"direct\"/>"),
                       "there is more than one integrator: this one is ignored"));
}

/// Numbers of Mitsuba 3.9.
TEST(MitsubaLanguage, EmittedSpectraOfOneNumberAreEvenSinceVersion2) {
  const auto radiance = [](const std::string& version, const std::string& value) {
    Warnings warnings;
    return import_with("<scene version=\"" + version + "\"><emitter type=\"constant\">" + value +
                           "</emitter><sensor type=\"perspective\"/></scene>",
                       warnings)
        .lights.at(0)
        .node.color("radiance");
  };
  const std::string spectrum = "<spectrum name=\"radiance\" value=\"3\"/>";
  expect_near(radiance("3.0.0", spectrum), {3.6147F, 2.8447F, 2.7278F}, 1e-3F);
  expect_near(radiance("2.1.0", spectrum), {3.6147F, 2.8447F, 2.7278F}, 1e-3F);
  expect_near(radiance("0.6.0", spectrum), Vec3(3.F));
  expect_near(radiance("3.0.0", "<float name=\"radiance\" value=\"3\"/>"), Vec3(3.F));
}

TEST(MitsubaLanguage, UnknownSpectraHaveAReplacement) {
  const auto radiance = [](const std::string& spectrum, Warnings& warnings) {
    const desc::SceneDesc scene =
        import_with(world("<emitter type=\"constant\">" + spectrum + "</emitter>"), warnings);
    return scene.lights.at(0).node.color("radiance");
  };
  Warnings none;
  EXPECT_EQ(radiance("<spectrum name=\"radiance\" type=\"rawconstant\"><rgb name=\"value\" "
                     "value=\"1,2,3\"/></spectrum>",
                     none),
            Vec3(1, 2, 3));
  expect_none(none);
  Warnings warnings;
  radiance("<spectrum name=\"radiance\" type=\"rainbow\"/>", warnings);
  EXPECT_TRUE(contains(lines_of(warnings), "unknown texture \"rainbow\""));
}

}  // namespace
}  // namespace ajar::mitsuba
