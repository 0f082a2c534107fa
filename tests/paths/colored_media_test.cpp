#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/methods.h"
#include "support/render.h"

/// Media in which lanes of the spectrum scatter differently, against grey ones.
namespace ajar {
namespace {

using test::pbrt_scene;
using test::scene_from;

const char* const kView =
    "LookAt 0 0 -5  0 0 0  0 1 0\nCamera \"orthographic\" \"float screenwindow\" [-.4 .4 -.4 .4]";

struct Lanes {
  double r, g, b;
  std::string text() const {
    return "[" + std::to_string(r) + " " + std::to_string(g) + " " + std::to_string(b) + "]";
  }
};

std::string fog(const Lanes& sigma_s, const Lanes& sigma_a) {
  return R"(MakeNamedMedium "m" "string type" "homogeneous" "float g" 0.3 "rgb sigma_s" )" +
         sigma_s.text() + " \"rgb sigma_a\" " + sigma_a.text() + "\n";
}

std::string smoke(const Lanes& sigma_s, const Lanes& sigma_a) {
  return R"(MakeNamedMedium "m" "string type" "heterogeneous" "integer nx" 2 "integer ny" 2
"integer nz" 2 "float density" [1 0 1 .5 1 1 0 1] "point p0" [-1 -1 -1] "point p1" [1 1 1]
"float g" -.5 "rgb sigma_s" )" +
         sigma_s.text() + " \"rgb sigma_a\" " + sigma_a.text() + "\n";
}

using MakeMedium = std::string (*)(const Lanes& sigma_s, const Lanes& sigma_a);

/// A ball of it before a sky as bright in all directions: media without absorption are invisible.
std::string ball(const std::string& medium) {
  return pbrt_scene(medium + kView, 16, 16,
                    "LightSource \"infinite\" \"rgb L\" [1 1 1]\nMediumInterface \"m\" \"\"\n"
                    "Material \"none\"\nShape \"sphere\" \"float radius\" [0.9]");
}

struct BlueSpread {
  double mean;
  double variance;  ///< variance of a pixel
};
BlueSpread blue(const test::Render& picture) {
  const std::vector<float> pixels = picture.image();
  const double count = static_cast<double>(pixels.size()) / 3.0;
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 2; i < pixels.size(); i += 3) {
    sum += double{pixels[i]};
    squares += double{pixels[i]} * double{pixels[i]};
  }
  const double mean = sum / count;
  return {mean, squares / count - mean * mean};
}

class ColoredMedia : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Methods, ColoredMedia, ::testing::Values("pt", "lt", "ibpt", "bdpt"),
                         [](const auto& test) { return std::string(test.param); });

/// One lane has a third of the samples, so that three times the variance is expected. With a lane
/// drawn for each distance, it would be twenty times and more.
TEST_P(ColoredMedia, AreAlmostAsQuietAsGreyOnes) {
  for (const MakeMedium medium : {&fog, &smoke}) {
    SCOPED_TRACE(medium == &fog ? "fog" : "smoke");
    const auto spread = [&](const Lanes& sigma_s) {
      test::RenderOptions options;
      options.integrator = GetParam();
      options.samples = 64;
      if (options.integrator != "pt") options.parameters = {{"light-paths-per-pixel", "1"}};
      return blue(test::render(*scene_from(ball(medium(sigma_s, {0, 0, 0}))), options));
    };
    const BlueSpread grey = spread({4, 4, 4});
    const BlueSpread colored = spread({1, 2, 4});
    EXPECT_NEAR(colored.mean, 1.0, 5.0 * std::sqrt(colored.variance / 256.0));
    EXPECT_LT(colored.variance, 4.0 * grey.variance);
  }
}

using PerLane = std::array<double, 3>;
struct LaneEstimate {
  PerLane mean{};
  PerLane standard_error{};
};
LaneEstimate estimate_lanes(const test::Render& picture) {
  const int replicates = picture.film->replicates();
  std::vector<PerLane> means;
  LaneEstimate result;
  for (int r = 0; r < replicates; ++r) {
    const std::vector<float> pixels = picture.replicate(r);
    PerLane& mean = means.emplace_back();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      mean[i % 3] += 3.0 * double{pixels[i]} / static_cast<double>(pixels.size());
    }
    for (std::size_t lane = 0; lane < 3; ++lane) result.mean[lane] += mean[lane] / replicates;
  }
  for (std::size_t lane = 0; lane < 3; ++lane) {
    double squares = 0.0;
    for (const PerLane& mean : means) squares += std::pow(mean[lane] - result.mean[lane], 2);
    result.standard_error[lane] = std::sqrt(squares / (replicates - 1.0) / replicates);
  }
  return result;
}

class LanesOfMedia : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Methods, LanesOfMedia,
                         ::testing::Values("pt", "ibpt", "bdpt", "pssmlt", "mmlt", "mlt"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(LanesOfMedia, MatchGreyMedia) {
  const std::array<double, 3> sigma_s = {0.5, 1.0, 2.5};
  const std::array<double, 3> sigma_a = {0.3, 0.1, 0.4};
  const bool chains = test::has_chains(GetParam());
  for (const MakeMedium medium : {&fog, &smoke}) {
    SCOPED_TRACE(medium == &fog ? "fog" : "smoke");
    test::RenderOptions options;
    options.samples = 128;
    // Chains need long for many scattering events.
    options.max_depth = 6;
    PerLane expected{};
    PerLane error{};
    for (std::size_t lane = 0; lane < 3; ++lane) {
      const Lanes s{sigma_s[lane], sigma_s[lane], sigma_s[lane]};
      const Lanes a{sigma_a[lane], sigma_a[lane], sigma_a[lane]};
      const LaneEstimate grey =
          estimate_lanes(test::render(*scene_from(ball(medium(s, a))), options));
      expected[lane] = grey.mean[lane];
      error[lane] = grey.standard_error[lane];
    }
    const auto scene = scene_from(
        ball(medium({sigma_s[0], sigma_s[1], sigma_s[2]}, {sigma_a[0], sigma_a[1], sigma_a[2]})));
    options.integrator = GetParam();
    options.seed = 2;
    const LaneEstimate colored = estimate_lanes(test::render(*scene, options));
    for (std::size_t lane = 0; lane < 3; ++lane) {
      const double noise = 5.0 * std::hypot(colored.standard_error[lane], error[lane]);
      EXPECT_NEAR(colored.mean[lane], expected[lane], noise) << "lane " << lane;
      EXPECT_LT(noise, (chains ? 0.2 : 0.04) * expected[lane]) << "too noisy to notice";
    }
  }
}

}  // namespace
}  // namespace ajar
