#include "import/mitsuba/attributes.h"

#include <algorithm>

#include "import/mitsuba/import_test_support.h"

namespace ajar::mitsuba {
namespace {

TEST(MitsubaAttributes, ElementsInPropertiesAndReferencesAreWarnings) {
  const std::string glass = "<bsdf type='dielectric' id='m'/>";
  for (const std::string& body : std::initializer_list<std::string>{
           sphere_of("<bsdf type='dielectric'><float name='int_ior' value='1.5'><float name='deep' "
                     "value='2'/></float></bsdf>"),
           glass +
               sphere_of("<ref id='m'><float name='q' value='3'><float name='r'/></float></ref>"),
           "<shape type='sphere'><transform name='to_world'><translate x='1'><float name='a'/>"
           "</translate></transform></shape>",
           "<emitter type='constant'><spectrum name='radiance' value='1'><float "
           "name='a'/></spectrum>"
           "</emitter>",
           "<default name='a' value='1'><float name='b'/></default>"}) {
    const std::string warnings = warnings_of(body);
    EXPECT_TRUE(contains(warnings, "test.xml:2:")) << body;
    EXPECT_TRUE(contains(warnings, "has no <float> in it: ignored\n")) << body << warnings;
    EXPECT_EQ(std::count(warnings.begin(), warnings.end(), '\n'), 1) << warnings;
  }
  const std::string moving = warnings_of(
      "<shape type='sphere'><animation name='to_world'><transform time='0'/><float name='a'/>"
      "</animation></shape>");
  EXPECT_TRUE(contains(moving, "<animation> has no <float> in it")) << moving;
}

TEST(MitsubaAttributes, DuplicatesAreWarnings) {
  const auto placed = [](const std::string& step) {
    return "<shape type='sphere'><transform name='to_world'>" + step + "</transform></shape>";
  };
  EXPECT_EQ(warnings_of(placed("<translate value='1 2 3' x='9'/>")),
            "test.xml:2:49: <translate> has \"value\" and \"x\": the latter is ignored\n");
  EXPECT_EQ(warnings_of(placed("<translate x='9' y='1'/><scale value='2'/>")), "");
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      world("<emitter type='point'><point name='position' value='1 2 3' y='4'/></emitter>"
            "<emitter type='constant'><spectrum name='radiance' type='uniform' "
            "value='3'/></emitter>"),
      warnings);
  expect_near(transform_point(scene.lights.at(0).to_world, {0, 0, 0}), {1, 2, 3});
  const std::string said = lines_of(warnings);
  EXPECT_TRUE(contains(said, "<point> has \"value\" and \"y\"")) << said;
  EXPECT_TRUE(contains(said, "<spectrum> has \"type\" and \"value\"")) << said;
}

}  // namespace
}  // namespace ajar::mitsuba
