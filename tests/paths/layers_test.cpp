#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "integrator/integrator.h"
#include "session/output/output.h"
#include "support/methods.h"
#include "support/render.h"

/// The layers of a render against each other.
namespace ajar {
namespace {

using test::pbrt_scene;
using test::render;
using test::scene_from;

/// Inside a sphere that emits 1 and reflects 0.5: paths of k edges contribute 0.5^(k-1).
std::unique_ptr<Scene> closed_room() {
  return scene_from(
      pbrt_scene("LookAt 0 0 0.7  0 0 2  0 1 0\nCamera \"perspective\" \"float fov\" [90]", 12, 8,
                 "Material \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\nReverseOrientation\nAreaLightSource "
                 "\"diffuse\" \"rgb L\" [1 1 1]\n"
                 "Shape \"sphere\" \"float radius\" [2]"));
}

double mean(const std::vector<float>& pixels) {
  return std::accumulate(pixels.begin(), pixels.end(), 0.0) / static_cast<double>(pixels.size());
}

const Picture::Layer& layer(const Picture& picture, const std::string& name) {
  for (const Picture::Layer& candidate : picture.layers) {
    if (candidate.name == name) return candidate;
  }
  throw std::logic_error("no layer " + name);
}

TEST(Layers, DirectHoldsThePathsOfUpToTwoEdges) {
  const auto scene = closed_room();
  for (const IntegratorInfo& info : integrators()) {
    test::RenderOptions options;
    options.integrator = info.name;
    options.max_depth = 4;
    // Chains that change the length of their paths find out how much light is direct.
    options.samples = info.name == "mlt" ? 4096 : 256;
    const auto picture = render(*scene, options);
    const double direct = mean(picture.layer("direct"));
    EXPECT_NEAR(direct, 1.5, 0.03) << info.name;
  }
}

TEST(Layers, DirectPlusIndirectIsThePictureToTheBit) {
  const auto scene = closed_room();
  for (const IntegratorInfo& info : integrators()) {
    test::RenderOptions options;
    options.integrator = info.name;
    options.samples = 32;
    options.replicates = 4;
    const auto rendered = render(*scene, options);
    const Picture picture = develop(*rendered.film, *rendered.integrator, 32, 1.0, {});
    const auto& whole = layer(picture, "").pixels;
    const auto& direct = layer(picture, "direct").pixels;
    const auto& indirect = layer(picture, "indirect").pixels;
    for (std::size_t i = 0; i < whole.size(); ++i) {
      ASSERT_EQ(whole[i], direct[i] + indirect[i]) << info.name << ", value " << i;
    }
  }
}

TEST(TechniqueLayers, WeightedOnesAddUpToThePicture) {
  const auto scene = closed_room();
  for (const auto& [integrator, reason] : test::those_without_chains("they have such layers")) {
    test::RenderOptions options;
    options.integrator = integrator;
    options.samples = 16;
    options.max_depth = 5;
    options.aovs = {"techniques"};
    const auto picture = render(*scene, options);
    std::vector<float> sum(picture.image().size());
    for (std::size_t i = 0; i < picture.film->layers().size(); ++i) {
      const std::string& name = picture.film->layers()[i].name;
      if (!name.starts_with("techniques.weighted.")) continue;
      const std::vector<float> part = picture.layer(name);
      for (std::size_t p = 0; p < part.size(); ++p) sum[p] += part[p];
    }
    const std::vector<float> image = picture.image();
    for (std::size_t p = 0; p < image.size(); ++p) {
      ASSERT_NEAR(sum[p], image[p], 1e-5F + 1e-5F * image[p]) << integrator;
    }
  }
}

TEST(TechniqueLayers, EachTechniqueAloneShowsAllLightItReaches) {
  const auto scene = closed_room();
  std::map<std::string, std::vector<double>> means;
  constexpr int kRuns = 12;
  for (int run = 0; run < kRuns; ++run) {
    test::RenderOptions options;
    options.integrator = "bdpt";
    options.samples = 512;
    options.seed = static_cast<std::uint64_t>(run);
    options.max_depth = 4;
    options.aovs = {"techniques"};
    const auto picture = render(*scene, options);
    for (int depth = 2; depth <= 4; ++depth) {
      for (int s = 0; s <= depth; ++s) {
        const std::string name =
            "techniques.unweighted.s" + std::to_string(s) + "t" + std::to_string(depth + 1 - s);
        ASSERT_GE(picture.film->layer(name), 0) << name;
        means[name + " " + std::to_string(depth)].push_back(mean(picture.layer(name)));
      }
    }
  }
  EXPECT_EQ(means.size(), 12U);
  for (const auto& [name, values] : means) {
    const int depth = name.back() - '0';
    const double expected = std::pow(0.5, depth - 1);
    const double average = std::accumulate(values.begin(), values.end(), 0.0) / kRuns;
    double squares = 0.0;
    for (const double v : values) squares += (v - average) * (v - average);
    const double error = std::sqrt(squares / (kRuns - 1) / kRuns);
    EXPECT_NEAR(average, expected, 5.0 * error + 1e-5) << name;
    EXPECT_LT(5.0 * error, 0.1 * expected) << name << ": too noisy to notice what it should";
  }
}

}  // namespace
}  // namespace ajar
