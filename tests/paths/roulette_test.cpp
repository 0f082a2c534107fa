#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "support/render.h"
#include "support/same_picture.h"
#include "support/small_scenes.h"
#include "transport/efficiency_cells.h"
#include "transport/heuristics.h"
#include "transport/sources.h"

/// Roulette by efficiency: no expectation changes, whatever cells claim to know.
namespace ajar {
namespace {

/// Means by depth, of camera subpaths alone, and their standard errors.
constexpr int kMostEdges = 4;
/// Longer paths are few where few survive: their errors would not be known.
constexpr int kEdgesLookedAt = 3;
struct ByDepth {
  std::array<double, kMostEdges + 1> sum{};
  std::array<double, kMostEdges + 1> squares{};
  double samples = 0.0;

  void add(const std::array<double, kMostEdges + 1>& sample) {
    for (std::size_t k = 0; k < sum.size(); ++k) {
      sum[k] += sample[k];
      squares[k] += sample[k] * sample[k];
    }
    ++samples;
  }
  double mean(std::size_t k) const { return sum[k] / samples; }
  double variance_of_mean(std::size_t k) const {
    return (squares[k] / samples - mean(k) * mean(k)) / samples;
  }
};

/// So little that hardly any connection is too weak for a ray.
constexpr double kPrice = 1e-3;

/// Contributions of one camera sample by depth.
class DepthSink final : public PathSink {
 public:
  void add(const Contribution& contribution) override {
    light[static_cast<std::size_t>(contribution.technique.depth())] +=
        static_cast<double>(luminance(contribution.value));
    ++contributions;
  }
  float rays_per_unit_light(const Vec2& /*raster*/) const override {
    return static_cast<float>(1.0 / kPrice);
  }
  std::array<double, kMostEdges + 1> light{};
  int contributions = 0;
};

/// Cells that all claim this worth, in prices, and those of light subpaths, which claim it in rays
/// at every other kind of vertex.
struct Claims {
  Claims(const Box3& bounds, double worth) : cells(bounds, kPrice), light_cells(bounds, 1.0) {
    for (std::uint32_t cell = 0; cell < 8; ++cell) {
      for (int i = 0; i < 64; ++i) {
        cells.add(cell, i % 2 == 0, kPrice * worth, 1);
        if (cell % 2 == 0) light_cells.add(cell, i % 2 == 0, worth, 1);
      }
    }
    cells.end_round();
    light_cells.end_round();
  }
  EfficiencyCells cells;
  EfficiencyCells light_cells;
};

struct Result {
  ByDepth light;
  double contributions = 0.0;  ///< mean over samples
};

Result sampled(const Scene& scene, const std::string& techniques, Claims* claims, int samples) {
  PathSamplerSettings settings;
  settings.techniques = TechniqueSet::parse(techniques);
  settings.max_depth = kMostEdges;
  if (claims != nullptr) {
    settings.cells = &claims->cells;
    settings.light_cells = &claims->light_cells;
  }
  PathSampler sampler(scene, settings);
  const Vec2 size(scene.camera().resolution());
  Result result;
  for (int i = 0; i < samples; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    IndependentSource source({claims == nullptr ? 1U : 2U, index, 5, index});
    DepthSink sink;
    sampler.sample(source, source.get_pair({Stream::Camera, 0, kEmissionDirection}) * size, sink);
    result.light.add(sink.light);
    result.contributions += sink.contributions;
  }
  result.contributions /= samples;
  return result;
}

/// Power: 5 standard errors of these samples are 2 to 8 % of the light of depths 1 to 3; a weight
/// forgotten is 25 % or more.
TEST(EfficientPaths, BringTheSameLightWhateverCellsClaim) {
  constexpr int kCameraSamples = 60000;
  for (const char* name : {"Room", "GlassAndMetal", "Fog"}) {
    const auto scene = test::scene_from(test::small_scene(name).text);
    for (const char* techniques : {"pt", "bdpt"}) {
      const Result truth = sampled(*scene, techniques, nullptr, kCameraSamples);
      // Few survive, some, and all.
      for (const double worth : {0.3, 1.0, 4.0}) {
        Claims claims(scene->bounds(), worth);
        const Result own = sampled(*scene, techniques, &claims, kCameraSamples);
        for (std::size_t k = 1; k <= kEdgesLookedAt; ++k) {
          const double error =
              std::sqrt(truth.light.variance_of_mean(k) + own.light.variance_of_mean(k));
          EXPECT_NEAR(own.light.mean(k), truth.light.mean(k), 5.0 * error)
              << name << ", " << techniques << ", depth " << k << ", worth " << worth;
        }
        if (worth < 1.0) {
          EXPECT_LT(own.contributions, 0.9 * truth.contributions) << "no path was ended";
        }
      }
    }
  }
}

/// Paths all of which bring the same, in rays. Light subpaths do not reach the lens if they are not
/// seen, or bring nothing.
class LensSink final : public PathSink {
 public:
  LensSink(double rays, bool sees) : rays_(rays), sees_(sees && rays > 0.0) {}
  void add(const Contribution& contribution) override {
    (contribution.technique.t == 1 ? to_lens_ : by_camera_) += rays_;
  }
  bool reaches(const Vec2& /*raster*/) const override { return sees_; }
  float rays_per_unit_light(const Vec2& /*raster*/) const override {
    return static_cast<float>(1.0 / kPrice);
  }
  double brought() const override { return kPrice * by_camera_; }
  double brought_to_lens() const override { return to_lens_; }
  bool learns() const override { return true; }
  bool knows_price() const override { return true; }

 private:
  double rays_;
  bool sees_;
  double by_camera_ = 0.0;
  double to_lens_ = 0.0;
};

/// Rays of light subpaths once cells know what the first ones have brought.
std::uint64_t rays_of_light(const Scene& scene, double brings, bool learns) {
  constexpr std::uint32_t kLightPaths = 4000;
  EfficiencyCells cells(scene.bounds(), 1.0);
  PathSamplerSettings settings;
  settings.techniques = TechniqueSet::parse("ibpt");
  settings.max_depth = 12;
  settings.light_cells = learns ? &cells : nullptr;
  LensSink sink(brings, true);
  const auto trace = [&](std::uint32_t seed) {
    PathSampler sampler(scene, settings);
    for (std::uint32_t i = 0; i < kLightPaths; ++i) {
      IndependentSource source({seed, i, seed, i});
      sampler.sample_light(source, sink);
    }
    return sampler.rays_by_use().light_walk;
  };
  trace(1);
  cells.end_round();
  return trace(2);
}

/// Light subpaths are ended where they bring nothing, and nowhere if each vertex is worth its rays.
TEST(EfficientPaths, OfLightEndWhereTheyBringNothing) {
  const auto scene = test::scene_from(test::small_scene("Room").text);
  const auto usual = static_cast<double>(rays_of_light(*scene, 10.0, false));
  EXPECT_LT(static_cast<double>(rays_of_light(*scene, 0.0, true)), 0.7 * usual);
  EXPECT_GT(static_cast<double>(rays_of_light(*scene, 10.0, true)), usual);
}

/// Worths that cells know of paths each of which brings so much, in rays: camera subpaths, and
/// light subpaths with their connections.
std::vector<float> learned(const Scene& scene, double brings, bool sees = true) {
  EfficiencyCells cells(scene.bounds(), kPrice);
  EfficiencyCells light_cells(scene.bounds(), 1.0);
  PathSamplerSettings settings;
  settings.techniques = TechniqueSet::parse("bdpt");
  settings.max_depth = 6;
  settings.cells = &cells;
  settings.light_cells = &light_cells;
  LensSink sink(brings, sees);
  PathSampler sampler(scene, settings);
  const Vec2 size(scene.camera().resolution());
  for (std::uint32_t i = 0; i < 2000; ++i) {
    IndependentSource source({1, i, 1, i});
    sampler.sample(source, source.get_pair({Stream::Camera, 0, kEmissionDirection}) * size, sink);
  }
  std::vector<float> worths;
  for (EfficiencyCells* each : {&cells, &light_cells}) {
    each->end_round();
    for (std::uint32_t cell = 0; cell < 8; ++cell) {
      worths.insert(worths.end(), each->worth(cell).begin(), each->worth(cell).end());
    }
  }
  return worths;
}

/// Fireflies of any strength are worth as many rays as any other bright light.
TEST(EfficientPaths, BoundWhatFirefliesSay) {
  const auto scene = test::scene_from(test::small_scene("Room").text);
  const double most = TransportHeuristics::kMostRays;
  const std::vector<float> bright = learned(*scene, 1.01 * most);
  EXPECT_EQ(learned(*scene, 1e6 * most), bright);
  const std::vector<float> usual = learned(*scene, most / 100.0);
  std::array<int, 2> known{};
  for (std::size_t i = 0; i < bright.size(); ++i) {
    if (usual[i] == 0.F) continue;
    ++known[i < bright.size() / 2 ? 0 : 1];
    EXPECT_GT(bright[i], 2.F * usual[i]) << "what is not bound says how bright it is";
  }
  EXPECT_GT(known[0], 0) << "of camera subpaths";
  EXPECT_GT(known[1], 0) << "of light subpaths";
}

/// Light subpaths that no lens sees bring what connections to them bring.
TEST(EfficientPaths, OfLightLearnFromConnections) {
  const auto scene = test::scene_from(test::small_scene("Room").text);
  const std::vector<float> nothing = learned(*scene, 0.0);
  const std::vector<float> unseen = learned(*scene, 1.0, false);
  int known = 0;
  for (std::size_t i = unseen.size() / 2; i < unseen.size(); ++i) {
    if (unseen[i] == 0.F) continue;
    ++known;
    EXPECT_GT(unseen[i], 10.F * nothing[i]);
  }
  EXPECT_GT(known, 0);
}

/// By region, with cells that learn as the render goes on.
TEST(EfficientPaths, RenderTheSamePictures) {
  for (const char* name : {"Room", "GlassAndMetal", "CroppedMitchell"}) {
    auto [scene, options, truth] = test::known_picture(name, 256);
    for (const char* integrator : {"pt", "ibpt", "bdpt"}) {
      options.integrator = integrator;
      options.parameters = {{"roulette", "efficient"}};
      const test::Render render = test::render(*scene, options);
      test::expect_same(test::replicates_of(render), test::replicates_of(truth), *render.film, 0.15,
                        std::string(name) + ", " + integrator);
    }
  }
}

}  // namespace
}  // namespace ajar
