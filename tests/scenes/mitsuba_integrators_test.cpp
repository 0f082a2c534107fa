// Depths that the integrators of Mitsuba count, and lamps that they show. Numbers are those of
// Mitsuba 3.9.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "import/mitsuba/mitsuba_import.h"
#include "scene/scene.h"
#include "support/methods.h"
#include "support/render.h"
#include "support/tiny_picture.h"

namespace ajar {
namespace {

desc::SceneDesc description_with(const std::string& body) {
  Warnings warnings;
  const std::string text = "<scene version='3.0.0'>" + body + "</scene>";
  desc::SceneDesc scene = import_mitsuba_text(test::with_quotes(text), "test.xml", ".", warnings);
  for (const std::string& message : warnings.messages()) ADD_FAILURE() << message;
  return scene;
}

double mean_of(const std::string& body, int samples, const std::string& method = "pt") {
  desc::SceneDesc description = description_with(body);
  test::RenderOptions options;
  options.integrator = method;
  options.samples = samples;
  options.max_depth = description.hints.max_depth.value_or(options.max_depth);
  Warnings warnings;
  const Scene scene(std::move(description), BuildOptions{}, warnings);
  return test::render(scene, options).mean();
}

std::string integrator(const std::string& type, int max_depth, bool hides_emitters = false) {
  return fmt::format(
      "<integrator type='{}'><integer name='max_depth' value='{}'/><boolean name='hide_emitters' "
      "value='{}'/></integrator>",
      type, max_depth, hides_emitters);
}

/// Looks along −z from a place on the axis.
std::string view(int distance, int pixels) {
  return fmt::format(
      "<sensor type='perspective'><float name='fov' value='20'/><transform name='to_world'><lookat "
      "origin='0, 0, {}' target='0, 0, 0' up='0, 1, 0'/></transform><film type='hdrfilm'><integer "
      "name='width' value='{}'/><integer name='height' value='{}'/><rfilter "
      "type='box'/></film></sensor>",
      distance, pixels, pixels);
}

/// A square of `side` around the axis.
std::string square(double side, double z, const std::string& content) {
  return fmt::format(
      "<shape type='rectangle'><transform name='to_world'><scale value='{}'/><translate "
      "z='{}'/></transform>{}</shape>",
      0.5 * side, z, content);
}

constexpr const char* kEvenLight =
    "<emitter type='constant'><rgb name='radiance' value='1'/></emitter>";
constexpr const char* kMatt = "<bsdf type='twosided'><bsdf type='diffuse'/></bsdf>";

/// Five of them, one behind the other, before even light; or three before a floor.
struct NullEvents {
  const char* bsdf;
  const char* integrator;
  int max_depth;
  double panes;
  double floor;
};
void PrintTo(const NullEvents& events, std::ostream* out) {
  *out << events.bsdf << " by " << events.integrator << ", depth " << events.max_depth;
}

constexpr const char* kThin = "<bsdf type='thindielectric'/>";
constexpr const char* kMask =
    "<bsdf type='mask'><float name='opacity' value='0.3'/><bsdf type='twosided'><bsdf "
    "type='diffuse'/></bsdf></bsdf>";
constexpr const char* kCutOut =
    "<bsdf type='mask'><texture name='opacity' type='checkerboard'><float name='color0' "
    "value='0'/><float name='color1' value='1'/><transform name='to_uv'><scale "
    "value='4'/></transform></texture><bsdf type='twosided'><bsdf type='diffuse'/></bsdf></bsdf>";
constexpr const char* kNull = "<bsdf type='null'/>";
constexpr const char* kBlend =
    "<bsdf type='blendbsdf'><float name='weight' value='0.5'/><bsdf type='null'/><bsdf "
    "type='twosided'><bsdf type='diffuse'/></bsdf></bsdf>";
constexpr const char* kMaskedThin =
    "<bsdf type='mask'><float name='opacity' value='0.5'/><bsdf type='thindielectric'/></bsdf>";

class NullEventsCount : public ::testing::TestWithParam<NullEvents> {};

TEST_P(NullEventsCount, AsInMitsuba) {
  const NullEvents& events = GetParam();
  const auto with = [&](int panes, const std::string& rest) {
    std::string scene = integrator(events.integrator, events.max_depth) + view(9, 24) + kEvenLight;
    for (int i = 0; i < panes; ++i) scene += square(6, i, events.bsdf);
    return mean_of(scene + rest, 256);
  };
  EXPECT_NEAR(with(5, ""), events.panes, 0.006);
  const std::string floor = "<bsdf type='diffuse'><rgb name='reflectance' value='0.8'/></bsdf>";
  EXPECT_NEAR(with(3, square(6, -1, floor)), events.floor, 0.008);
}

INSTANTIATE_TEST_SUITE_P(All, NullEventsCount,
                         ::testing::Values(NullEvents{kThin, "path", 3, 0.0784, 0.0784},
                                           NullEvents{kThin, "path", 6, 0.8682, 0.4046},
                                           NullEvents{kThin, "volpath", 2, 0.9550, 0.7017},
                                           NullEvents{kThin, "volpathmis", 3, 0.9896, 0.7578},
                                           NullEvents{kMask, "path", 3, 0.1602, 0.1612},
                                           NullEvents{kCutOut, "path", 3, 0.2561, 0.2533},
                                           NullEvents{kCutOut, "path", 6, 0.5038, 0.3631},
                                           NullEvents{kCutOut, "volpath", 2, 0.5045, 0.3762},
                                           NullEvents{kNull, "path", 3, 0.0, 0.0},
                                           NullEvents{kNull, "path", 7, 1.0, 0.3969},
                                           NullEvents{kNull, "volpath", 2, 1.0, 0.8},
                                           NullEvents{kBlend, "path", 3, 0.2618, 0.2630},
                                           NullEvents{kBlend, "volpath", 2, 0.3896, 0.3755},
                                           NullEvents{kMaskedThin, "path", 6, 0.9301, 0.3371},
                                           NullEvents{kMaskedThin, "volpath", 2, 0.9869, 0.7443}));

/// Three wide masks before even light, of two edges: 0.7³ comes through, and mask i (from 0)
/// reflects 0.3 · 0.5 of its light, which passes i masks on either way. Mitsuba 3.9 has 0.6163
/// instead of 0.6025.
TEST(Masks, TransmitBothWaysByTheirOpacity) {
  std::string scene = integrator("volpath", 2) + view(9, 24) + kEvenLight;
  for (int i = 0; i < 3; ++i) scene += square(600, i, kMask);
  const double passed = 0.7 * 0.7;
  EXPECT_NEAR(mean_of(scene, 256), 0.7 * passed + 0.15 * (1 + passed + passed * passed), 0.006);
}

class NullEventsOf : public ::testing::TestWithParam<std::string> {};

/// Two masks hang between a lamp and the floor that is seen: light that falls there has passed
/// both, or comes from it by more edges.
TEST_P(NullEventsOf, AddNothingToTheDepthThatCountsByAnyMethod) {
  const auto lit = [&](const std::string& type, bool masked) {
    const auto mask = [&](double z) { return masked ? square(10, z, kMask) : ""; };
    return integrator(type, 2) + view(9, 16) + mask(10) + mask(11) +
           square(2, 0, "<bsdf type='diffuse'/>") +
           "<shape type='rectangle'><transform name='to_world'><scale value='4'/><rotate x='1' "
           "angle='180'/><translate z='12'/></transform>" +
           kMatt + "<emitter type='area'><rgb name='radiance' value='100'/></emitter></shape>";
  };
  const double open = mean_of(lit("volpath", false), 256);
  // Five standard errors of `mmlt`: no method connects through masks, so that hits are few.
  EXPECT_NEAR(mean_of(lit("volpath", true), 256, GetParam()), 0.49 * open, 0.1 * open);
  EXPECT_LT(mean_of(lit("path", true), 64, GetParam()), 1e-6);
}

/// An invisible lamp lights the scene behind it.
TEST_P(NullEventsOf, HiddenLampsEmitByAnyMethod) {
  const auto lit = [](bool hidden) {
    return integrator("path", 4, hidden) + view(8, 16) + square(2, -1, "<bsdf type='diffuse'/>") +
           "<shape type='sphere'><float name='radius' value='0.5'/><point name='center' x='0.3' "
           "y='0' z='0'/><emitter type='area'><rgb name='radiance' value='2'/></emitter></shape>";
  };
  EXPECT_NEAR(mean_of(lit(true), 256, GetParam()), 0.0502, 0.0015);
  EXPECT_NEAR(mean_of(lit(false), 256, GetParam()), 0.2275, 0.007);
}

/// A lamp that is not seen reflects the light of another, which is not seen either.
TEST_P(NullEventsOf, HiddenLampsAreInvisibleByAnyMethod) {
  const auto lit = [](bool hidden) {
    return integrator("path", 3, hidden) + view(8, 16) +
           "<shape type='sphere'><float name='radius' value='0.5'/><bsdf type='diffuse'><rgb "
           "name='reflectance' value='0.8'/></bsdf><emitter type='area'><rgb name='radiance' "
           "value='0.1'/></emitter></shape><shape type='rectangle'><transform "
           "name='to_world'><scale value='2'/><rotate x='1' angle='180'/><translate "
           "z='12'/></transform>" +
           kMatt + "<emitter type='area'><rgb name='radiance' value='20'/></emitter></shape>";
  };
  EXPECT_GT(mean_of(lit(false), 64, GetParam()), 0.03);
  EXPECT_EQ(mean_of(lit(true), 64, GetParam()), 0.0);
}

/// The camera looks past a lamp, but not past one beyond a pane that counts.
TEST_P(NullEventsOf, LampsBehindHiddenOnesAreVisibleByAnyMethod) {
  const auto lamp = [](const std::string& shape, int radiance) {
    return shape + "<bsdf type='diffuse'><rgb name='reflectance' value='0'/></bsdf>" +
           "<emitter type='area'><rgb name='radiance' value='" + std::to_string(radiance) +
           "'/></emitter></shape>";
  };
  const std::string scene = integrator("path", 3, true) + view(8, 16) +
                            lamp("<shape type='sphere'><float name='radius' value='0.5'/>", 5) +
                            square(6, -1, kNull) +
                            lamp(
                                "<shape type='rectangle'><transform name='to_world'><scale "
                                "value='6'/><translate z='-2'/></transform>",
                                1);
  EXPECT_NEAR(mean_of(scene, 64, GetParam()), 1.0, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Methods, NullEventsOf, ::testing::ValuesIn(test::methods_but({})),
                         [](const auto& one) { return test::name_for_tests(one.param); });

struct Hidden {
  const char* integrator;
  const char* before;  ///< between the camera and the rest
  double mean;
};

/// A lamp, a sky, and a pane before them, which does not count.
TEST(HiddenEmitters, AreInvisibleBehindNullEvents) {
  const std::string lamp =
      "<shape type='sphere'><float name='radius' value='0.5'/><point name='center' x='0.3' y='0' "
      "z='0'/><emitter type='area'><rgb name='radiance' value='2'/></emitter></shape>";
  for (const Hidden& hidden :
       {Hidden{"volpath", kThin, 0.2754}, Hidden{"volpath", kNull, 0.2223}}) {
    const std::string scene = integrator(hidden.integrator, 4, true) + view(8, 32) + lamp +
                              square(2, -1, "<bsdf type='diffuse'/>") + kEvenLight +
                              square(2, 2, hidden.before);
    EXPECT_NEAR(mean_of(scene, 256), hidden.mean, 0.006)
        << hidden.integrator << " " << hidden.before;
  }
}

}  // namespace
}  // namespace ajar
