#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "image/compare_blocks.h"
#include "integrator/integrator.h"
#include "support/render.h"
#include "support/small_scenes.h"

/// Every set of techniques against path tracing, block by block, on scenes that both can render.
namespace ajar {
namespace {

Replicates replicates_of(const test::Render& picture) {
  Replicates replicates;
  for (int r = 0; r < picture.film->replicates(); ++r) replicates.push_back(picture.replicate(r));
  return replicates;
}

class Agreement : public ::testing::TestWithParam<test::SmallScene> {};

/// What is compared with path tracing: integrators as they are, and sets that no integrator has.
struct Variant {
  std::string name;
  std::string integrator;
  std::map<std::string, std::string> parameters;
  bool needs_light_tracing = false;  ///< cannot do without technique (s, 1) anywhere
};

const std::vector<Variant>& variants() {
  static const std::vector<Variant> kVariants = {
      {"ibpt", "ibpt", {}},
      {"bdpt", "bdpt", {}},
      {"lt", "lt", {}, true},
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

TEST_P(Agreement, EverySetHasTheExpectationOfPathTracing) {
  const test::SmallScene& small = GetParam();
  const auto scene = test::scene_from(small.text);
  test::RenderOptions options;
  options.samples = small.samples;
  options.replicates = 16;
  options.max_depth = 6;
  options.crop = small.crop;
  const Replicates truth = replicates_of(test::render(*scene, options));
  for (const Variant& variant : variants()) {
    if (variant.needs_light_tracing && !small.light_tracing_works) continue;
    options.integrator = variant.integrator;
    options.parameters = variant.parameters;
    options.seed = 2;
    const test::Render other = test::render(*scene, options);
    const BlockGrid grid{.width = other.film->width(), .height = other.film->height(), .block = 8};
    const BlockComparison comparison = compare_blocks(replicates_of(other), truth, grid);
    // A right program fails this with a chance of 2e-6.
    EXPECT_TRUE(comparison.equal())
        << variant.name << ": worst block at " << comparison.worst_block.min.x << ", "
        << comparison.worst_block.min.y << ", z " << comparison.worst_z << ", mean z "
        << comparison.mean_z << ", relative " << comparison.mean_relative_difference;
    // Power: 5 standard errors of the mean are less than 6 %.
    const Estimate mean = image_mean(truth);
    const double error =
        std::hypot(mean.standard_error, image_mean(replicates_of(other)).standard_error);
    EXPECT_LT(5.0 * error, 0.06 * mean.value) << variant.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Agreement, ::testing::ValuesIn(test::small_scenes()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace ajar
