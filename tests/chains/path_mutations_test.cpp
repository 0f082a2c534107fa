#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/random.h"
#include "mcmc/moments.h"
#include "mcmc/path_space/make_path_mutations.h"
#include "path/measure.h"
#include "path/visibility.h"
#include "support/path_samples.h"
#include "support/path_scenes.h"
#include "support/render.h"

/// Mutations of paths: each by itself leaves the distribution of light as it is, region by region,
/// and follows its densities.
namespace ajar {
namespace {

constexpr int kMaxDepth = test::kPathSampleDepth;

PathBounds bounds_of(const Scene& scene) { return test::path_sample_bounds(scene); }

using test::for_samples;
using test::WeightedPath;

/// Cosine.
constexpr float kSteep = 0.8F;

std::int32_t one_layer(int /*depth*/) { return 0; }

constexpr std::size_t kRegions = 3 * 2 * kMaxDepth * 3 * 2;

/// By the place on the film, the length, the first hit (a specular vertex, another, or the light),
/// and whether light falls steeply on the first vertex.
std::size_t region_of(const Scene& scene, const Path& path) {
  const Vec2 place = path.raster / Vec2(scene.camera().resolution());
  const auto column = static_cast<std::size_t>(std::clamp(place.x * 3.F, 0.F, 2.F));
  const auto row = static_cast<std::size_t>(std::clamp(place.y * 2.F, 0.F, 1.F));
  const int k = path.depth();
  const std::size_t seen = k == 1 ? 2 : path.vertex(k - 1).event.specular() ? 1 : 0;
  const bool steep = k > 1 && path.vertex(1).cosine(path.toward_light(scene, 1)) > kSteep;
  const std::size_t place_and_depth =
      (column * 2 + row) * kMaxDepth + static_cast<std::size_t>(k - 1);
  return (place_and_depth * 3 + seen) * 2 + (steep ? 1 : 0);
}

/// Change of the light in each region by one step: zero on average, if the step keeps the
/// distribution.
struct Flow {
  std::array<Moments, kRegions> gain;
  double moved = 0.0;  ///< share of all light that leaves its region
  double light = 0.0;
  std::uint64_t steps = 0;
  std::uint64_t without_density = 0;
};

Flow flow_of(const Scene& scene, std::size_t mutation, std::uint32_t samples) {
  const PathBounds bounds = bounds_of(scene);
  std::vector<double> weights(path_mutations().size(), 0.0);
  weights[mutation] = 1.0;
  PathKernel kernel = make_path_kernel(scene, bounds, weights, one_layer);
  Flow flow;
  for_samples(scene, samples, [&](std::uint32_t sample, const std::vector<WeightedPath>& paths) {
    std::array<double, kRegions> gain{};
    for (std::size_t i = 0; i < paths.size(); ++i) {
      PathChain chain;
      chain.path = paths[i].path;
      chain.scalar = 1.0;
      SplatBuffer splats;
      if (!std::isfinite(light_on(scene, chain.path, bounds, 0, splats))) continue;
      flow.light += paths[i].weight;
      kernel.start(chain);
      const Proposal proposal = kernel.propose(hash_numbers(99, sample, i));
      const Candidate& candidate = proposal.candidates.front();
      EXPECT_EQ(candidate.fault, Fault::None);
      ++flow.steps;
      if (proposal.without_density) ++flow.without_density;
      if (!(candidate.probability > 0.0)) continue;
      const std::size_t from = region_of(scene, chain.path);
      kernel.accept(0);
      const std::size_t to = region_of(scene, chain.path);
      if (from == to) continue;
      const double light = paths[i].weight * candidate.probability;
      gain[from] -= light;
      gain[to] += light;
      flow.moved += light;
    }
    for (std::size_t r = 0; r < kRegions; ++r) flow.gain[r].add(gain[r]);
  });
  return flow;
}

/// Share of all light that a region may gain or lose in a step before it is noticed.
double power_of_flow(const std::string& scene) {
  // Where light glides, few paths have most of it.
  return scene == "Grazing" ? 0.2 : 0.06;
}

/// Share of all light that must leave its region in a step: the power to find densities that are
/// wrong for some of that.
double least_flow(const std::string& mutation, const std::string& scene) {
  if (mutation == "manifold") {
    // Elsewhere chains at the light are few.
    if (scene == "BurningGlassInTheSun" || scene == "BurningGlassUnderASky") return 0.001;
    if (scene.starts_with("BurningGlass")) return 0.05;
    if (scene == "Instances") return 0.01;
    return scene == "Pool" || scene == "Lenses" ? 0.0005 : 0.0;
  }
  if (mutation == "half-vector") return scene.starts_with("Gloss") ? 0.005 : 0.0;
  if (scene.starts_with("BurningGlass")) return 0.0;
  if (scene == "Lenses" || scene == "GlossOverWater") return 0.0005;
  if (scene == "Instances" || scene == "Grazing") return 0.0001;
  if (mutation != "multi-chain") return 0.002;
  return scene == "Pool" ? 0.0005 : 0.0;  // elsewhere its paths are too long, or too few
}

/// Scenes for walks alone: under other cameras, with other lights, in media.
bool is_for_walks(const std::string& scene) {
  return scene.starts_with("BurningGlass") && scene != "BurningGlass" &&
         scene != "BurningGlassInTheSun";
}

class KeepsTheDistribution : public ::testing::TestWithParam<const char*> {};

/// Holds with 100 000 samples, too, and 400 000 of the pool. There, densities without the spread of
/// specular vertices or the factor of one edge fail with 60 000.
TEST_P(KeepsTheDistribution, OfLightRegionByRegion) {
  const auto scene = test::scene_from(test::path_scene(GetParam()));
  const std::string_view scene_name = GetParam();
  std::uint32_t samples = 4000;
  // Few samples of these have any light that moves.
  for (const char* name :
       {"Lenses", "BurningGlass", "BurningGlassInTheSun", "BurningGlassOrthographic",
        "BurningGlassByALens", "BurningGlassInFog", "BurningGlassUnderASky", "Gloss",
        "GlossInTheSun", "Instances", "BumpsAndNormalMaps", "Grazing", "EnvironmentCamera"}) {
    if (scene_name == name) samples = 20000;
  }
  if (scene_name == "Pool" || scene_name == "GlossOverWater") samples = 60000;
  for (std::size_t m = 0; m < path_mutations().size(); ++m) {
    const std::string name(path_mutations()[m].name);
    if (is_for_walks(GetParam()) && name != "manifold") continue;
    SCOPED_TRACE(name);
    const Flow flow = flow_of(*scene, m, samples);
    double largest_error = 0.0;
    for (std::size_t r = 0; r < kRegions; ++r) {
      const Moments& gain = flow.gain[r];
      if (gain.sum_of_squares == 0.0) continue;
      const double error = gain.standard_error();
      EXPECT_LT(std::abs(gain.mean()), 5.0 * error)
          << "region " << r << " gains " << gain.mean() * samples / flow.light << " of the light";
      largest_error = std::max(largest_error, error * samples / flow.light);
    }
    EXPECT_LT(5.0 * largest_error, power_of_flow(GetParam()))
        << "too noisy to notice what it should";
    EXPECT_GE(flow.moved / flow.light, least_flow(name, GetParam()));
    // At the ends of a reach, by rounding.
    EXPECT_LE(flow.without_density, flow.steps / 200);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, KeepsTheDistribution,
                         ::testing::Values("Pool", "Lenses", "BurningGlass", "BurningGlassInTheSun",
                                           "BurningGlassOrthographic", "BurningGlassByALens",
                                           "BurningGlassInFog", "BurningGlassUnderASky",
                                           "Instances", "BumpsAndNormalMaps", "Grazing", "Gloss",
                                           "GlossOverWater", "GlossInTheSun", "GlassAndMetal",
                                           "ThinLens", "Environment", "Distant", "PointAndSpot",
                                           "ShadingNormals", "Orthographic", "EnvironmentCamera",
                                           "Fog", "MilkBall", "ColoredSmoke"),
                         [](const auto& test) { return std::string(test.param); });

/// A square on the floor or the back wall of the small room, by its middle and
/// half its side.
struct Square {
  Vec3 middle;
  float half;
  bool has(const InnerVertex& vertex) const {
    const Vec3 d = vertex.p() - middle;
    return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) <= half;
  }
  double area() const { return 4.0 * double{half} * double{half}; }
};
const Square kOnFloor{Vec3(0.25F, 0.F, 0.3F), 0.15F};
const Square kOnWall{Vec3(0.3F, 1.F, 2.F), 0.9F};
/// For mutations that come there seldom.
const Square kMoreOfFloor{Vec3(0.F, 0.F, 0.5F), 0.7F};
/// For those that do not go far.
const Square kLessOfFloor{Vec3(0.25F, 0.F, 0.3F), 0.08F};
constexpr double kLamp = 0.8 * 0.8;

/// Sum over changes of one kind, by kept vertices and regions of the new ones: the mean over
/// proposals of 1/T is the size of the region, if T is their density.
struct Region {
  const char* mutation;
  Kept kept;
  /// Where x₁, x₂, … of the new path are.
  std::vector<Square> squares;
  double size;   ///< product of areas
  double power;  ///< relative error that would be noticed
};

Path direct_path(const Scene& scene) {
  std::optional<Path> found;
  for_samples(scene, 4000, [&](std::uint32_t /*sample*/, const std::vector<WeightedPath>& paths) {
    for (const WeightedPath& weighted : paths) {
      // Near the square, but further from it than the smallest
      // perturbation.
      const Path& path = weighted.path;
      if (found || path.depth() != 2 || std::abs(path.vertex(1).p().y) > 1e-4F) continue;
      const float away = length(path.vertex(1).p() - kOnFloor.middle);
      if (away > 0.3F && away < 0.4F) found = path;
    }
  });
  if (!found) throw std::logic_error("no such path");
  return *found;
}

TEST(PathMutations, FollowTheirDensity) {
  const auto scene = test::scene_from(test::small_scene("Room").text);
  const PathBounds bounds = bounds_of(*scene);
  const Path x = direct_path(*scene);
  const double floor = kMoreOfFloor.area();
  const double wall = kOnWall.area();
  const Square here{x.vertex(1).p(), 1e-3F};
  const std::vector<Region> regions = {
      {"bidirectional", {1, 1}, {kMoreOfFloor}, floor, 0.2},
      {"bidirectional", {1, 1}, {kMoreOfFloor, kOnWall}, floor * wall, 1.0},
      {"bidirectional", {0, 1}, {kMoreOfFloor}, kLamp * floor, 0.3},
      {"bidirectional", {0, 0}, {kMoreOfFloor}, kLamp * floor, 0.3},
      {"bidirectional", {1, 0}, {kMoreOfFloor}, floor, 0.4},
      {"bidirectional", {2, 1}, {here, kOnWall}, wall, 0.4},
      {"bidirectional", {1, 2}, {kOnWall, here}, wall, 0.4},
      {"lens-subpath", {1, 0}, {kMoreOfFloor}, floor, 0.1},
      {"lens", {1, 1}, {kOnFloor}, kOnFloor.area(), 0.1},
      {"caustic", {1, 1}, {kLessOfFloor}, kLessOfFloor.area(), 0.1},
  };
  for (const PathMutationInfo& info : path_mutations()) {
    const auto mutation = info.make(*scene, bounds);
    std::vector<Moments> sizes(regions.size());
    Path y;
    for (std::uint64_t i = 0; mutation->suitable(x) && i < 400000; ++i) {
      const auto kept = mutation->propose(x, hash_numbers(5, i), y);
      for (std::size_t r = 0; r < regions.size(); ++r) {
        const Region& region = regions[r];
        if (region.mutation != info.name) continue;
        bool inside = kept && kept->light == region.kept.light &&
                      kept->camera == region.kept.camera &&
                      y.vertices.size() == region.squares.size();
        for (std::size_t v = 0; inside && v < region.squares.size(); ++v) {
          inside = region.squares[v].has(y.vertices[v]);
        }
        sizes[r].add(inside ? std::exp(-mutation->log_density(x, y, *kept)) : 0.0);
      }
    }
    for (std::size_t r = 0; r < regions.size(); ++r) {
      if (regions[r].mutation != info.name) continue;
      const double error = sizes[r].standard_error() / regions[r].size;
      SCOPED_TRACE(std::string(info.name) + " region " + std::to_string(r));
      EXPECT_NEAR(sizes[r].mean() / regions[r].size, 1.0, 5.0 * error);
      EXPECT_LT(5.0 * error, regions[r].power) << "too noisy to notice what it should";
    }
  }
}

/// The density of a whole new path is that of all techniques together.
TEST(PathMutations, MakeWholePathsAsTheTechniquesDo) {
  for (const char* name : {"GlassAndMetal", "Environment", "PointAndSpot", "ThinLens", "Fog"}) {
    SCOPED_TRACE(name);
    const auto scene = test::scene_from(test::small_scene(name).text);
    const PathBounds bounds = bounds_of(*scene);
    const auto mutation = path_mutations()[0].make(*scene, bounds);
    ASSERT_EQ(mutation->name(), "bidirectional");
    // Probabilities of lengths, by that of the old and the new path.
    std::map<std::pair<int, int>, double> choices;
    int checked = 0;
    Path y;
    for_samples(*scene, 3000, [&](std::uint32_t sample, const std::vector<WeightedPath>& paths) {
      for (std::size_t i = 0; i < paths.size(); ++i) {
        const Path& x = paths[i].path;
        const auto kept = mutation->propose(x, hash_numbers(3, sample, i), y);
        if (!kept || kept->light > 0 || kept->camera > 0) continue;
        const int k = y.depth();
        double density = 0.0;
        for (int s = 0; s <= k; ++s) {
          double own = technique_pdf(*scene, y, {s, k + 1 - s});
          for (int v = 1; v + 1 < s; ++v) {
            if (y.vertex(v).event.specular()) own /= specular_spread(*scene, y, v);
          }
          if (own > 0.0) density += own;
        }
        const double choice = mutation->log_density(x, y, *kept) - std::log(density);
        const auto [known, is_new] = choices.emplace(std::pair(x.depth(), k), choice);
        EXPECT_NEAR(choice, known->second, 1e-6) << "from " << x.depth() << " to " << k;
        EXPECT_LT(choice, std::log(0.1)) << "no more often than whole paths are made";
        ++checked;
      }
    });
    EXPECT_GT(checked, 30);
    EXPECT_GT(choices.size(), 5U);
  }
}

/// Proposals of mutations have open edges and the kept vertices, and the reverse move is known.
TEST(PathMutations, KeepVerticesAndAreReversible) {
  for (const char* name :
       {"GlassAndMetal", "NestedDielectrics", "Orthographic", "Distant", "Fog"}) {
    const auto scene = test::scene_from(test::small_scene(name).text);
    const PathBounds bounds = bounds_of(*scene);
    for (const PathMutationInfo& info : path_mutations()) {
      SCOPED_TRACE(std::string(name) + ", " + std::string(info.name));
      const auto mutation = info.make(*scene, bounds);
      RayCounts rays;
      int proposed = 0;
      int blocked = 0;
      int unknown = 0;
      int one_way = 0;
      Path y;
      for_samples(*scene, 400, [&](std::uint32_t sample, const std::vector<WeightedPath>& paths) {
        for (std::size_t i = 0; i < paths.size(); ++i) {
          const Path& x = paths[i].path;
          if (!mutation->suitable(x)) continue;
          const auto kept = mutation->propose(x, hash_numbers(4, sample, i), y);
          if (!kept) continue;
          ++proposed;
          EXPECT_EQ(y.segments.size(), y.vertices.size() + 1);
          for (int v = 0; v < kept->light; ++v) EXPECT_EQ(y.position(v), x.position(v));
          for (int v = 0; v + 1 < kept->camera; ++v) {
            EXPECT_EQ(y.position(y.depth() - 1 - v), x.position(x.depth() - 1 - v));
          }
          if (!mutation->suitable(y)) continue;  // as chains do
          if (!std::isfinite(mutation->log_density(x, y, *kept))) ++unknown;
          if (!std::isfinite(mutation->log_density(y, x, *kept))) ++one_way;
          Path again = y;
          if (!look_along_all(*scene, again, rays)) ++blocked;
        }
      });
      if (proposed == 0) continue;
      EXPECT_LE(blocked, 1 + proposed / 200) << "of " << proposed;
      // At the ends of its reach, which roundings of the edges of a path may
      // pass.
      EXPECT_LE(unknown, proposed / 200) << "of " << proposed;
      // The reach of caustic and half-vector perturbations is not that of the
      // way back. No mutation leads back to specular vertices right after the
      // light, if the light is kept.
      const bool leads_back =
          info.name != "caustic" && info.name != "half-vector" && info.name != "bidirectional";
      EXPECT_LE(one_way, leads_back ? 0 : proposed / 3) << "of " << proposed;
    }
  }
}

}  // namespace
}  // namespace ajar
