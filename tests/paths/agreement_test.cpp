#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "integrator/integrator.h"
#include "support/methods.h"
#include "support/render.h"
#include "support/same_picture.h"
#include "support/small_scenes.h"

/// Every integrator, and sets of techniques that none has, against path tracing, block by block.
/// New integrators of the registry are included.
namespace ajar {
namespace {

using test::expect_same;
using test::replicates_of;

class Agreement : public ::testing::TestWithParam<test::SmallScene> {};

/// Integrators that are not compared on some scenes, and why.
bool is_exception(const std::string& integrator, const test::SmallScene& scene) {
  if (integrator == "pt") return true;  // the reference of others
  // Light tracing cannot see mirrors and clear glass, and reports it.
  return integrator == "lt" && !scene.light_tracing_works;
}

/// A set that no integrator has.
struct Variant {
  std::string name;
  std::string integrator;
  std::map<std::string, std::string> parameters;
  bool needs_light_tracing = false;  ///< cannot do without technique (s, 1) anywhere
};

const std::vector<Variant>& variants() {
  static const std::vector<Variant> kVariants = {
      {"implicit and light",
       "ibpt",
       {{"techniques", "implicit,light"}, {"light-paths-per-pixel", "0.6"}},
       true},
      {"classes with counts, connections culled",
       "bdpt",
       {{"techniques", "implicit,explicit*2.5,light*0.5,inner*0.5"},
        {"light-paths-per-pixel", "1.5"},
        {"cull", "1"},
        {"heuristic", "balance"}}},
      {"single techniques",
       "bdpt",
       {{"techniques", "(0,*),(1,2)*2,(1,3),(3,*)*0.5,(*,1)"}, {"light-paths-per-pixel", "1.3"}}},
  };
  return kVariants;
}

/// Per pixel, of path tracing.
constexpr int kSamples = 512;

test::RenderOptions options_of(const test::SmallScene& small) {
  test::RenderOptions options;
  options.samples = kSamples;
  options.replicates = 16;
  options.max_depth = 6;
  options.crop = small.crop;
  return options;
}

/// Samples per pixel that notice a mean that is wrong by `power`.
struct Effort {
  int samples;
  double power;
};
Effort effort_of(const std::string& integrator, const test::SmallScene& scene) {
  // Chains that share nothing with ordinary Monte Carlo scatter several times as much; those of one
  // path at a time, and those that end, most.
  if (integrator == "mmlt" || integrator == "erpt") return {384, 0.25};
  if (integrator == "pssmlt" || integrator == "mlt") return {192, 0.2};
  if (test::has_chains(integrator)) return {scene.samples / 2, 0.12};
  return {integrator == "lt" ? 2 * scene.samples : scene.samples, 0.06};
}

// One picture of path tracing serves all.
TEST_P(Agreement, EveryIntegratorAndSetHasTheExpectationOfPathTracing) {
  const test::SmallScene& small = GetParam();
  const auto scene = test::scene_from(small.text);
  test::RenderOptions options = options_of(small);
  const Replicates truth = replicates_of(test::render(*scene, options));
  options.seed = 2;
  for (const IntegratorInfo& info : integrators()) {
    if (is_exception(info.name, small)) continue;
    options.integrator = info.name;
    const Effort effort = effort_of(info.name, small);
    options.samples = effort.samples;
    const test::Render other = test::render(*scene, options);
    expect_same(replicates_of(other), truth, *other.film, effort.power, info.name);
  }
  options.samples = small.samples;
  for (const Variant& variant : variants()) {
    if (variant.needs_light_tracing && !small.light_tracing_works) continue;
    options.integrator = variant.integrator;
    options.parameters = variant.parameters;
    const test::Render other = test::render(*scene, options);
    expect_same(replicates_of(other), truth, *other.film, 0.06, variant.name);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Agreement, ::testing::ValuesIn(test::small_scenes()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace ajar
