#include <gtest/gtest.h>

#include "session/output.h"
#include "support/render.h"
#include "support/same_picture.h"

/// What ordinary Monte Carlo finds of the light that chains make is another estimate of it
/// (`LayerSpec::instead_of`), for filters to mix with theirs.
namespace ajar {
namespace {

/// All methods of the registry that have one.
std::vector<std::string> methods_with_two_estimates() {
  const test::KnownPicture known = test::known_picture("GlassAndMetal");
  std::vector<std::string> names;
  for (const auto* list : {&integrators(), &integrator_presets()}) {
    for (const IntegratorInfo& info : *list) {
      test::RenderOptions options = known.options;
      options.integrator = info.name;
      options.other_estimates = true;
      options.samples = 8;
      const test::Render render = test::render(*known.scene, options);
      const auto layers = render.film->layers();
      const bool has_other = std::any_of(layers.begin(), layers.end(), [](const LayerSpec& layer) {
        return !layer.instead_of.empty();
      });
      if (has_other) names.push_back(info.name);
    }
  }
  return names;
}

PictureEstimates estimates_of_render(const test::Render& render) {
  return estimates_of(*render.film,
                      development_of(*render.film, *render.integrator, render.samples),
                      render.samples, 1.0);
}

TEST(OtherEstimates, HaveTheExpectationOfThePicture) {
  const std::vector<std::string> names = methods_with_two_estimates();
  EXPECT_GE(names.size(), 3U);
  const test::KnownPicture known = test::known_picture("GlassAndMetal");
  for (const std::string& name : names) {
    test::RenderOptions options = known.options;
    options.integrator = name;
    options.other_estimates = true;
    const test::Render render = test::render(*known.scene, options);
    const PictureEstimates estimates = estimates_of_render(render);
    test::expect_same(estimates.others, test::replicates_of(known.truth), *render.film, 0.1,
                      name + ", the other estimate");
    test::expect_same(estimates.replicates, test::replicates_of(known.truth), *render.film, 0.1,
                      name);
  }
}

/// It is beside the picture, not in it: to the bit what is rendered without.
TEST(OtherEstimates, LeaveThePictureAsItWas) {
  const test::KnownPicture known = test::known_picture("GlassAndMetal");
  test::RenderOptions options = known.options;
  options.integrator = "selective";
  options.samples = 16;
  const std::vector<float> without = test::render(*known.scene, options).image();
  options.other_estimates = true;
  EXPECT_EQ(test::render(*known.scene, options).image(), without);
}

}  // namespace
}  // namespace ajar
