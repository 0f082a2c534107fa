#include <gtest/gtest.h>

#include "session/output/output.h"
#include "support/render.h"
#include "support/same_picture.h"

/// Layers for filters: another estimate of the light of chains (`LayerSpec::instead_of`), which
/// they mix with the chains', and splats through boxes (`LayerSpec::box_of`).
namespace ajar {
namespace {

/// `selective` has chains where it is told where they begin.
test::RenderOptions options_of(const test::KnownPicture& known, const std::string& integrator) {
  test::RenderOptions options = known.options;
  options.integrator = integrator;
  options.for_filters = true;
  if (integrator == "selective") options.parameters = {{"split", "1"}};
  return options;
}

/// All methods of the registry that have one.
std::vector<std::string> methods_with_two_estimates() {
  const test::KnownPicture known = test::known_picture("GlassAndMetal", 8);
  std::vector<std::string> names;
  for (const IntegratorInfo& info : integrators()) {
    const test::Render render = test::render(*known.scene, options_of(known, info.name));
    const auto layers = render.film->layers();
    const bool has_other = std::any_of(layers.begin(), layers.end(), [](const LayerSpec& layer) {
      return !layer.instead_of.empty();
    });
    if (has_other) names.push_back(info.name);
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
  EXPECT_GE(names.size(), 2U);
  const test::KnownPicture known = test::known_picture("GlassAndMetal", 128);
  for (const std::string& name : names) {
    const test::Render render = test::render(*known.scene, options_of(known, name));
    const PictureEstimates estimates = estimates_of_render(render);
    test::expect_same(estimates.others, test::replicates_of(known.truth), *render.film, 0.1,
                      name + ", the other estimate");
    test::expect_same(estimates.replicates, test::replicates_of(known.truth), *render.film, 0.1,
                      name);
  }
}

/// Two estimates that are the same would cost filters twice the time.
TEST(OtherEstimates, AreLeftOutWhereChainsMakeNothing) {
  const Scene scene = test::builtin_scene("cornell");
  test::RenderOptions options;
  options.integrator = "selective";
  options.replicates = 4;
  options.samples = 4;
  options.for_filters = true;
  const test::Render render = test::render(scene, options);
  EXPECT_EQ(render.counters.mutations, 0U);
  EXPECT_TRUE(estimates_of_render(render).others.empty());
}

/// Splats through boxes: of methods that have nothing else, equal to the film of a box up to
/// rounding. (Camera samples are drawn from the filter.)
TEST(ForFilters, SplatsHaveBoxes) {
  const auto scene_with = [](const std::string& filter) {
    return test::scene_from(
        "LookAt 0 -4 1  0 0 0  0 0 1\nCamera \"perspective\" \"float fov\" [45]\n"
        "Film \"image\" \"integer xresolution\" [20] \"integer yresolution\" [14]\n" +
        filter +
        "WorldBegin\nLightSource \"point\" \"point from\" [0 -1 3] \"rgb I\" [9 9 9]\n"
        "Material \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\nShape \"sphere\"\nWorldEnd\n");
  };
  test::RenderOptions options;
  options.integrator = "lt";
  options.samples = 64;
  options.for_filters = true;
  const auto wide = scene_with("PixelFilter \"gaussian\" \"float xwidth\" [2]\n");
  const auto narrow = scene_with("PixelFilter \"box\"\n");
  const test::Render of_wide = test::render(*wide, options);
  const test::Render of_narrow = test::render(*narrow, options);
  const PictureEstimates boxes = estimates_of_render(of_wide);
  ASSERT_EQ(boxes.boxes.size(), boxes.replicates.size());
  EXPECT_TRUE(estimates_of_render(of_narrow).boxes.empty());
  const std::vector<float> expected = of_narrow.image();
  const std::vector<float> found = replicate_mean(boxes.boxes);
  double off = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    off += std::abs(static_cast<double>(found[i]) - static_cast<double>(expected[i]));
    all += static_cast<double>(expected[i]);
  }
  EXPECT_GT(all, 0.0);
  EXPECT_LT(off, 1e-4 * all);
}

/// Other estimates are beside the picture: to the bit the picture without them.
TEST(OtherEstimates, LeaveThePictureAsItWas) {
  const test::KnownPicture known = test::known_picture("GlassAndMetal", 16);
  test::RenderOptions options = known.options;
  options.integrator = "selective";
  const std::vector<float> without = test::render(*known.scene, options).image();
  options.for_filters = true;
  EXPECT_EQ(test::render(*known.scene, options).image(), without);
}

}  // namespace
}  // namespace ajar
