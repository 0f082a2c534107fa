#include <gtest/gtest.h>

#include "import/pbrt/import_test_support.h"

namespace ajar {
namespace {

/// Everything that is ignored or replaced, worst first, whatever the order in the file.
TEST(PbrtWarnings, AreInTheOrderOfTheirEffect) {
  const std::string p = "\"point P\" [0 0 0 1 0 0 0 1 0]";
  const std::string told =
      warnings_of(world("Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 0 1] " + p +
                        "\nMaterial \"matte\" \"float unknown\" 1"
                        "\nMaterial \"hair\""
                        "\nShape \"nurbs\""
                        "\nLightSource \"distant\" \"point from\" [0 0 0] \"point to\" [0 0 0]"));
  std::size_t last = 0;
  for (const char* text : {"test.pbrt:6:1: \"from\" and \"to\"", "test.pbrt:5:1: nurbs",
                           "test.pbrt:4:1: material \"hair\"", "test.pbrt:3:18: unused parameter",
                           "test.pbrt:2:1: 1 of 2 triangles have no area"}) {
    const std::size_t at = told.find(text);
    ASSERT_NE(at, std::string::npos) << text << "\n" << told;
    EXPECT_GE(at, last) << told;
    last = at;
  }
}

TEST(PbrtWarnings, CountTheTrianglesOfAllMeshes) {
  Warnings warnings;
  const std::string shape =
      "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 0 1 1 1 1] "
      "\"point P\" [0 0 0 1 0 0 0 1 0]\n";
  import_with(world(shape + shape + shape), warnings);
  ASSERT_EQ(warnings.groups().size(), 1U);
  EXPECT_EQ(warnings.groups().front().amount, 6U);
  EXPECT_EQ(warnings.groups().front().count, 3U);
  EXPECT_EQ(warnings.groups().front().first.where.line, 2);
}

TEST(PbrtWarnings, ReportDuplicateNames) {
  const std::string texture = "Texture \"t\" \"float\" \"constant\"\n";
  const std::string material = "MakeNamedMaterial \"m\" \"string type\" \"matte\"\n";
  const std::string medium = "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\"\n";
  const std::string object = "ObjectBegin \"o\" ObjectEnd\n";
  const std::string once = texture + material + medium + object;
  EXPECT_EQ(warnings_of(world(once)).find("already"), std::string::npos);
  const std::string told = warnings_of(world(once + once));
  for (const char* name : {"texture \"t\"", "material \"m\"", "medium \"fog\"", "object \"o\""}) {
    EXPECT_NE(told.find(std::string("there is a ") + name + " already"), std::string::npos) << told;
  }
  // Within a scope a name may mean something else.
  const std::string inside = "AttributeBegin " + texture + material + "AttributeEnd ";
  EXPECT_EQ(warnings_of(world(once + inside + inside)).find("already"), std::string::npos);
}

TEST(PbrtDirectives, UnknownOnesNameTheNearestWithTheirPlace) {
  const std::string error = error_of("WorldBegin\n  Shpae \"sphere\"");
  EXPECT_TRUE(
      contains(error, "test.pbrt:2:3: unknown directive \"Shpae\"; did you mean \"Shape\"?"))
      << error;
}

TEST(PbrtDirectives, Pbrt4IsNamedAsSuch) {
  for (const char* text : {"Option \"x\" 1", "WorldBegin Material \"dielectric\"",
                           "WorldBegin Shape \"bilinearmesh\""}) {
    EXPECT_TRUE(contains(error_of("Film \"image\" " + std::string(text)), "belongs to pbrt-v4"))
        << text;
  }
}

TEST(PbrtDirectives, OtherFilesAreErrors) {
  EXPECT_TRUE(contains(error_of(""), "there is no WorldBegin"));
  EXPECT_TRUE(contains(error_of("# nothing\n"), "test.pbrt:2:1"));
  EXPECT_TRUE(contains(error_of(std::string("\x7f"
                                            "ELF\0\0",
                                            6)),
                       "test.pbrt:1:5: this is not a pbrt scene: it is a binary file"));
  EXPECT_TRUE(contains(error_of(std::string("Film \"image\"\n \0", 15)), "test.pbrt:2:2"));
  EXPECT_TRUE(contains(error_of("\"Shape\""), "expected a directive"));
  EXPECT_TRUE(contains(error_of("{ \"json\": 1 }"), "test.pbrt:1:1: unknown directive"));
}

TEST(PbrtDirectives, WorldEndMayBeMissing) {
  EXPECT_EQ(warnings_of("Camera \"perspective\" WorldBegin Shape \"sphere\""),
            "test.pbrt:1:47: there is no WorldEnd: the file may have been cut off, or be meant as "
            "pbrt-v4, of which it has no word\n");
  EXPECT_EQ(warnings_of("Camera \"perspective\" Film \"image\" WorldBegin Shape \"sphere\""),
            "test.pbrt:1:60: there is no WorldEnd: the file may have been cut off\n");
  EXPECT_TRUE(contains(warnings_of(world("") + " Shape \"sphere\""),
                       "everything after WorldEnd is ignored"));
}

TEST(PbrtDirectives, ThingsOfTheWorldNeedAWorldAndOptionsNone) {
  EXPECT_TRUE(
      contains(error_of("Shape \"sphere\""), "1:1: Shape is only allowed after WorldBegin"));
  EXPECT_TRUE(contains(error_of("AttributeBegin"), "only allowed after WorldBegin"));
  EXPECT_TRUE(contains(warnings_of(world("Film \"image\"")),
                       "test.pbrt:2:1: Film has no effect after WorldBegin"));
  EXPECT_TRUE(contains(error_of("WorldBegin WorldBegin"), "1:12"));
}

TEST(PbrtDirectives, BlocksMustMatch) {
  EXPECT_EQ(error_of("WorldBegin\nAttributeEnd"),
            "test.pbrt:2:1: AttributeEnd without AttributeBegin");
  EXPECT_EQ(error_of("WorldBegin\n AttributeBegin\nTransformEnd"),
            "test.pbrt:3:1: TransformEnd, but the innermost open block is AttributeBegin at "
            "test.pbrt:2:2");
  EXPECT_TRUE(contains(warnings_of(world("  AttributeBegin")),
                       "test.pbrt:2:3: AttributeBegin without an end"));
  EXPECT_TRUE(contains(error_of("WorldBegin ObjectBegin \"a\" ObjectBegin \"b\""),
                       "inside of another object"));
}

TEST(PbrtDirectives, DeepNestingIsNoProblemUpToALimit) {
  std::string deep = "Camera \"perspective\" WorldBegin Shape \"sphere\" ";
  for (int i = 0; i < 20000; ++i) deep += "AttributeBegin ";
  std::string closed = deep;
  for (int i = 0; i < 20000; ++i) closed += "AttributeEnd ";
  EXPECT_EQ(warnings_of(closed + "WorldEnd"), "");
  std::string absurd = "WorldBegin ";
  for (int i = 0; i < 200000; ++i) absurd += "AttributeBegin ";
  EXPECT_TRUE(contains(error_of(absurd), "nested too deeply"));
}

TEST(PbrtParameters, MayHaveBracketsOrNot) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      "Camera \"perspective\" \"float fov\" 40 Film \"image\" \"integer xresolution\" [ 30 ] "
      "\"integer yresolution\"[40]"
      "\"string filename\" \"a.exr\" WorldBegin Shape \"sphere\" \" float  radius \" [ 3 ] "
      "WorldEnd",
      warnings);
  EXPECT_EQ(warnings.count(), 0U);
  EXPECT_EQ(std::get<desc::PerspectiveCamera>(scene.camera.node).fov, 40.F);
  EXPECT_EQ(scene.film.resolution, Vec2i(30, 40));
  EXPECT_EQ(scene.film.filename, "a.exr");
  EXPECT_EQ(scene.shapes[0].node.number("radius"), 3.F);
}

TEST(PbrtParameters, BoolsMayBeQuotedOrNot) {
  for (const char* value : {"\"false\"", "false", "[ \"false\" ]", "[ false ]"}) {
    Warnings warnings;
    const desc::SceneDesc scene = import_with(
        world("Material \"plastic\" \"bool remaproughness\" " + std::string(value)), warnings);
    EXPECT_EQ(scene.materials[0].node.text("roughness_scale"), "alpha") << value;
    EXPECT_EQ(warnings.count(), 0U);
  }
  EXPECT_TRUE(contains(error_of(world("Material \"plastic\" \"bool remaproughness\" 1")),
                       "test.pbrt:2:42: expected true or false"));
}

TEST(PbrtParameters, UnusedOnesAreReportedWithTheNearestName) {
  EXPECT_EQ(warnings_of(world("Material \"glass\" \"float indx\" 1.3")),
            "test.pbrt:2:18: unused parameter \"float indx\"; did you mean \"index\"?\n");
  EXPECT_TRUE(contains(warnings_of(world("Shape \"sphere\" \"float raduis\" 1.3")),
                       "did you mean \"radius\"?"));
  EXPECT_TRUE(contains(
      warnings_of("Camera \"perspective\" \"integer fov\" 3 WorldBegin Shape \"sphere\" WorldEnd"),
      "\"integer fov\": it must be of another type here"));
  EXPECT_TRUE(contains(
      warnings_of(
          "Camera \"perspective\" \"float fov\" [3 4] WorldBegin Shape \"sphere\" WorldEnd"),
      "must have one value, not 2"));
}

TEST(PbrtParameters, MalformedOnesAreLocatedErrors) {
  EXPECT_TRUE(contains(error_of("Camera \"perspective\" \"float fov\" \"wide\""),
                       "test.pbrt:1:34: expected a number, found \"wide\""));
  EXPECT_TRUE(
      contains(error_of("Film \"image\" \"string filename\" 3"), "1:32: expected a quoted string"));
  EXPECT_TRUE(
      contains(error_of("Film \"image\" \"fov\" 3"), "expected a parameter as \"type name\""));
  EXPECT_TRUE(contains(error_of("Film \"image\" \"flaot scale\" 3"),
                       "unknown parameter type \"flaot\"; did you mean \"float\"?"));
  EXPECT_TRUE(contains(error_of("Film \"image\" \"float scale\" [ 3"),
                       "1:28: this bracket is never closed"));
  EXPECT_TRUE(
      contains(error_of("Film \"image\" \"float scale\" nan"), "expected a number, found \"nan\""));
  EXPECT_TRUE(contains(error_of("Film \"image\" \"float scale\""),
                       "the file ends where a number should be"));
  EXPECT_TRUE(contains(error_of("Film"), "Film needs a quoted name here"));
  EXPECT_TRUE(contains(error_of("Translate 1 2"), "the file ends where a number should be"));
  EXPECT_TRUE(contains(error_of("Transform [1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17]"),
                       "expected ] after 16 numbers"));
}

TEST(PbrtInclude, ReadsOtherFilesAndNamesThemInMessages) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      world("Include \"geometry/a.pbrt\""), warnings,
      {{"geometry/a.pbrt", "Shape \"disk\" Include \"b.pbrt\""}, {"b.pbrt", "Shape \"cone\""}});
  EXPECT_EQ(scene.shapes.size(), 3U);
  EXPECT_TRUE(scene.shapes[1].node.is("cone"));
  EXPECT_EQ(error_of(world("Include \"x.pbrt\""), {{"x.pbrt", "\n Nonsense"}}).substr(0, 12),
            "x.pbrt:2:2: ");
}

TEST(PbrtInclude, OfMissingFilesIsAWarning) {
  EXPECT_EQ(warnings_of(world("Include \"missing-file\" Shape \"disk\"")),
            "test.pbrt:2:1: \"missing-file\" is not there: what it should include is left out\n");
  // Also where parameters of a directive could go on in it.
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      world("Shape \"disk\" \"float radius\" 2 Include \"missing-file\" Shape \"cone\""), warnings);
  EXPECT_EQ(scene.shapes.size(), 3U);
  EXPECT_EQ(warnings.count(), 1U);
}

TEST(PbrtInclude, BlocksMaySpanIncludes) {
  const Files files = {{"matte.pbrt", "Material \"matte\" # its colour follows"},
                       {"none.pbrt", "# nothing\n"},
                       {"nested.pbrt", "Include \"matte.pbrt\""},
                       {"array.pbrt", "Material \"matte\" \"rgb Kd\" [.1"},
                       {"color.pbrt", "\"rgb Kd\" [.1 .2 .3]"}};
  for (const char* text :
       {"Include \"matte.pbrt\" \"rgb Kd\" [.1 .2 .3] \"float sigma\" 20",
        "Include \"nested.pbrt\" \"rgb Kd\" [.1 .2 .3] \"float sigma\" 20",
        "Include \"array.pbrt\" .2 .3] \"float sigma\" 20",
        "Include \"matte.pbrt\" Include \"color.pbrt\" \"float sigma\" 20",
        "Material \"matte\" Include \"none.pbrt\" \"rgb Kd\" [.1 .2 .3] \"float sigma\" 20"}) {
    SCOPED_TRACE(text);
    const desc::SceneDesc scene = scene_of(text, files);
    const desc::Node& node = material_node_of(scene, scene.shapes.back());
    expect_rgb(node.color("reflectance"), {0.1F, 0.2F, 0.3F});
    EXPECT_EQ(node.number("sigma"), 20.F);
  }
  EXPECT_EQ(warnings_of(world("Material \"matte\" Include \"gone.pbrt\" \"float sigma\" 20")),
            "test.pbrt:2:18: \"gone.pbrt\" is not there: what it should include is left out\n");
  EXPECT_EQ(error_of(world("Include \"matte.pbrt\" \"rgb Kd\" [.1 x]"), files).substr(0, 12),
            "test.pbrt:2:")
      << "places are those of the file that goes on";
}

TEST(PbrtInclude, CirclesAndBadFilesAreErrors) {
  EXPECT_EQ(error_of("Include \"a\"", {{"a", "Include \"b\""}, {"b", "\nInclude \"a\""}}),
            "b:2:1: \"a\" includes itself");
  EXPECT_TRUE(contains(error_of("Include \"test.pbrt\"", {{"test.pbrt", ""}}), "includes itself"));
  EXPECT_TRUE(contains(error_of("Include \"/dev/zero\""), "only regular files can be read"));
  std::map<std::string, std::string> chain;
  for (int i = 0; i < 100; ++i)
    chain["f" + std::to_string(i)] = "Include \"f" + std::to_string(i + 1) + "\"";
  EXPECT_TRUE(contains(error_of("Include \"f0\"", chain), "too deeply"));
}

TEST(PbrtInclude, ExponentialInclusionIsStopped) {
  std::map<std::string, std::string> bomb;
  for (int i = 0; i < 40; ++i) {
    const std::string next = "Include \"f" + std::to_string(i + 1) + "\" ";
    bomb["f" + std::to_string(i)] = next + next;
  }
  bomb["f40"] = "";
  EXPECT_TRUE(contains(error_of("Include \"f0\"", bomb), "too many files"));
}

TEST(PbrtObjects, ArePlacedByInstances) {
  Warnings warnings;
  const desc::SceneDesc scene =
      import_with(world("ObjectBegin \"o\" Translate 1 0 0 Shape \"disk\" Shape \"cone\" ObjectEnd "
                        "Translate 0 5 0 ObjectInstance \"o\""),
                  warnings);
  EXPECT_EQ(warnings.count(), 0U);
  ASSERT_EQ(scene.objects.size(), 1U);
  EXPECT_EQ(scene.objects[0].shapes.size(), 2U);
  EXPECT_EQ(scene.objects[0].shapes[0].to_world[3][0], 1.0);
  ASSERT_EQ(scene.instances.size(), 1U);
  EXPECT_EQ(scene.instances[0].object, 0);
  EXPECT_EQ(scene.instances[0].to_world[3][1], 5.0);
  EXPECT_EQ(scene.shapes.size(), 1U);
}

TEST(PbrtObjects, CannotEmitAndAreLeftOutIfNotMade) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      world("ObjectBegin \"o\" AreaLightSource \"diffuse\" Shape \"disk\" ObjectEnd"), warnings);
  EXPECT_FALSE(scene.objects[0].shapes[0].emission);
  EXPECT_EQ(warnings.count(), 1U);
  EXPECT_TRUE(
      contains(warnings_of(world("ObjectInstance \"o\"")),
               "test.pbrt:2:1: unknown object \"o\". There are none. The instance is left out"));
}

TEST(PbrtMedia, InterfacesFollowTheGraphicsState) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      "Integrator \"volpath\" MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"rgb "
      "sigma_a\" [1 2 3] \"rgb "
      "sigma_s\" [4 5 6] "
      "\"float scale\" 2 \"float g\" 0.5 MediumInterface \"\" \"fog\" Camera \"perspective\" "
      "WorldBegin "
      "AttributeBegin MediumInterface \"fog\" \"\" Shape \"sphere\" AttributeEnd Shape \"disk\" "
      "AttributeBegin MediumInterface \"fog\" Shape \"cone\" AttributeEnd "
      "LightSource \"point\" WorldEnd",
      warnings);
  EXPECT_EQ(warnings.count(), 0U);
  ASSERT_EQ(scene.media.size(), 1U);
  EXPECT_EQ(scene.media[0].sigma_a, desc::Rgb(2.F, 4.F, 6.F));
  EXPECT_EQ(scene.media[0].sigma_s, desc::Rgb(8.F, 10.F, 12.F));
  EXPECT_EQ(scene.media[0].g, 0.5F);
  EXPECT_EQ(scene.camera.medium, 0);
  EXPECT_EQ(scene.lights[0].medium, 0);
  EXPECT_TRUE(scene.shapes[0].has_medium_interface);
  EXPECT_EQ(scene.shapes[0].inside, 0);
  EXPECT_EQ(scene.shapes[0].outside, desc::kNone);
  EXPECT_EQ(scene.shapes[1].inside, desc::kNone);
  EXPECT_EQ(scene.shapes[1].outside, 0);
  EXPECT_FALSE(scene.shapes[2].has_medium_interface);
}

TEST(PbrtMedia, UnknownOnesAreNone) {
  const std::string body = "MediumInterface \"x\" \"\"";
  EXPECT_TRUE(contains(warnings_of(world(body)), "test.pbrt:2:1: unknown medium \"x\""));
  // Once, not for each shape.
  EXPECT_EQ(warnings_of(world(body + " Shape \"disk\" Shape \"disk\"")), warnings_of(world(body)));
  Warnings warnings;
  EXPECT_EQ(import_with(world(body), warnings).shapes.at(0).inside, desc::kNone);
}

std::string grid_medium(const std::string& parameters) {
  return world(
      "Translate 1 0 0 MakeNamedMedium \"m\" \"string type\" \"heterogeneous\" \"rgb "
      "sigma_a\" [1 1 1] \"integer nx\" 2 " +
      parameters);
}

TEST(PbrtMedia, HaveGridsOfDensity) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      grid_medium("\"float density\" [1 3] \"float scale\" 2 \"point p1\" [2 3 4]"), warnings);
  EXPECT_EQ(warnings.count(), 0U);
  const desc::Medium& medium = scene.media[0];
  EXPECT_EQ(medium.sigma_a, desc::Rgb(2.F));
  ASSERT_TRUE(medium.density);
  EXPECT_EQ(medium.density->grid->values, (std::vector<float>{1.F, 3.F}));
  EXPECT_EQ(medium.density->grid->resolution, desc::Vec3i(2, 1, 1));
  EXPECT_EQ(transform_point(medium.density->to_world, Vec3(1.F)), Vec3(3.F, 3.F, 4.F));
}

TEST(PbrtMedia, OfBadGridsAreErrorsAndOfBadDensitiesWarnings) {
  EXPECT_TRUE(contains(error_of(grid_medium("\"float density\" [1 3 5]")),
                       "has 3 values of density, not 2 × 1 × 1"));
  EXPECT_TRUE(contains(error_of(grid_medium("")), "has 0 values of density"));
  EXPECT_TRUE(contains(error_of(grid_medium("\"integer ny\" -1 \"float density\" [1 3]")),
                       "fewer than 1 along an axis"));
  EXPECT_TRUE(contains(error_of(grid_medium("\"float density\" [1 3] \"point p1\" [0 1 1]")),
                       "box without volume"));
  Warnings warnings;
  const desc::SceneDesc scene = import_with(grid_medium("\"float density\" [-1 3]"), warnings);
  EXPECT_EQ(warnings.count(), 1U);
  EXPECT_EQ(scene.media[0].density->grid->values[0], 0.F);
}

}  // namespace
}  // namespace ajar
