// Small files that would hang the importer, fill the memory or end the stack.
#include "import/mitsuba/import_test_support.h"

namespace ajar::mitsuba {
namespace {

/// A text for each number from `first` to `last`: in `pattern` "#" is the number, "@" the one
/// before it.
std::string repeated(const std::string& pattern, int first, int last) {
  std::string result;
  for (int i = first; i <= last; ++i) {
    for (const char c : pattern) {
      if (c == '#') {
        result += std::to_string(i);
      } else if (c == '@') {
        result += std::to_string(i - 1);
      } else {
        result += c;
      }
    }
  }
  return result;
}

std::string medium_with(const std::string& content) {
  return "<shape type='cube'><medium type='heterogeneous' name='interior'>" + content +
         "</medium></shape>";
}

TEST(MitsubaHostileInput, CyclesAreRefused) {
  const auto spectrum = [](const std::string& type, const std::string& name) {
    return sphere_of("<bsdf type='diffuse'><spectrum name='reflectance' type='" + type +
                     "' id='a'><ref id='a' name='" + name + "'/></spectrum></bsdf>");
  };
  for (const std::string& circle :
       {std::string("<integrator type='aov' id='a'><ref id='a'/></integrator>"),
        std::string("<integrator type='aov' id='a'><integrator type='foo'><ref id='a'/>"
                    "</integrator></integrator>"),
        spectrum("uniform", "value"), spectrum("d65", "color"), spectrum("srgb", "color"),
        spectrum("foo", "value"),
        medium_with("<volume name='sigma_t' type='volcache' id='a'><ref id='a'/></volume>"),
        medium_with("<volume name='sigma_t' type='volcache' id='a'><volume type='volcache'>"
                    "<ref id='a'/></volume></volume>"),
        std::string("<shape type='merge' id='a'><ref id='a'/></shape>"),
        std::string("<shape type='shapegroup' id='a'><ref id='a'/></shape>"
                    "<shape type='instance'><ref id='a'/></shape>"),
        sphere_of("<bsdf type='twosided' id='a'><ref id='a'/></bsdf>"),
        sphere_of("<bsdf type='diffuse'><texture type='scale' name='reflectance' id='a'>"
                  "<ref id='a'/></texture></bsdf>")}) {
    EXPECT_TRUE(contains(error_of(world(circle)), "refers to itself")) << circle;
  }
}

TEST(MitsubaHostileInput, LongChainsOfReferencesAreRefused) {
  constexpr int kLength = 5000;
  const auto chain = [](const std::string& first, const std::string& link,
                        const std::string& last) {
    return first + repeated(link, 1, kLength) + last;
  };
  const std::string end = "<ref id='a5000'/>";
  for (const std::string& text :
       {chain("<bsdf type='diffuse' id='a0'/>",
              "<bsdf type='twosided' id='a#'><ref id='a@'/></bsdf>", sphere_of(end)),
        chain("<texture type='uniform' id='a0'/>",
              "<texture type='scale' id='a#'><ref id='a@'/></texture>",
              sphere_of("<bsdf type='diffuse'><ref name='reflectance' id='a5000'/></bsdf>")),
        chain("<shape type='shapegroup' id='a0'/>",
              "<shape type='shapegroup' id='a#'><ref id='a@'/></shape>",
              "<shape type='instance'>" + end + "</shape>"),
        chain("<volume type='constvolume' id='a0'/>",
              "<volume type='volcache' id='a#'><ref id='a@'/></volume>",
              medium_with("<ref name='sigma_t' id='a5000'/>"))}) {
    const std::string error = error_of(world(text));
    EXPECT_TRUE(contains(error, "nested too deeply")) << error << text.substr(0, 100);
  }
}

/// Each is made before the next one, so that none is in the midst of another.
TEST(MitsubaHostileInput, MixesOfMixesAreRefusedBeforeTheyTakeLong) {
  for (const std::string parts :
       {"<bsdf type='null'/><ref id='a@'/>", "<ref id='a@'/><bsdf type='null'/>"}) {
    const std::string mixes = repeated("<bsdf type='blendbsdf' id='a#'>" + parts +
                                           "</bsdf><shape type='sphere'><ref id='a#'/></shape>",
                                       1, 2000);
    const std::string error = error_of(world("<bsdf type='diffuse' id='a0'/>" + mixes));
    EXPECT_TRUE(contains(error, "bsdfs are nested too deeply")) << error;
  }
}

TEST(MitsubaHostileInput, ExponentialShapesAreRefused) {
  const auto doubled = [](const std::string& type, const std::string& shape) {
    return "<shape type='" + type + "' id='a0'>" + shape + "</shape>" +
           repeated("<shape type='" + type + "' id='a#'><ref id='a@'/><ref id='a@'/></shape>", 1,
                    25);
  };
  // All of them are in the scene, each by itself.
  EXPECT_TRUE(contains(error_of(world(doubled("merge", "<shape type='sphere'/>"))),
                       "shapes of shapes are more than 1000000"));
  EXPECT_TRUE(contains(error_of(world(doubled("merge", ""))), "more than 1000000"))
      << "though there is none at all";
  EXPECT_TRUE(contains(
      error_of(world(doubled("shapegroup", "") + "<shape type='instance'><ref id='a25'/></shape>")),
      "more than 1000000"));
}

TEST(MitsubaHostileInput, RepeatedPartsAreReadOnce) {
  // A file for each copy would be a million times its bytes.
  const std::string merges =
      "<shape type='merge' id='a0'><shape type='linearcurve' id='hair'><string name='filename' "
      "value='a.txt'/></shape></shape>" +
      repeated("<shape type='merge' id='a#'><ref id='a@'/><ref id='a@'/></shape>", 1, 3);
  const desc::SceneDesc scene = scene_of(merges, {{"a.txt", "0 0 0 1\n1 0 0 1\n"}});
  ASSERT_EQ(scene.shapes.size(), 1U + 1U + 2U + 4U + 8U);
  for (std::size_t i = 1; i + 1 < scene.shapes.size(); ++i) {
    EXPECT_EQ(scene.shapes[i].node.curves("curves"), scene.shapes[0].node.curves("curves"))
        << "the same, not another like it";
  }
}

}  // namespace
}  // namespace ajar::mitsuba
