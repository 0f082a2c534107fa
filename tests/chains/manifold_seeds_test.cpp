#include "mcmc/path_space/manifold_seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "core/random.h"
#include "mcmc/moments.h"
#include "mcmc/path_space/path_form.h"
#include "path/measure.h"
#include "support/path_samples.h"
#include "support/path_scenes.h"
#include "support/render.h"
#include "support/small_scenes.h"

/// Paths that no connection makes, as seeds of chains: joined by manifold connections, they have as
/// much light as unidirectional hits, in every part of the picture.
namespace ajar {
namespace {

const std::string kPoolFloor = R"(Material "matte" "rgb Kd" [0.7 0.6 0.5]
Shape "trianglemesh" "point P" [-2 0 -2  2 0 -2  2 0 2  -2 0 2] "integer indices" [0 2 1 0 3 2]
)";
const std::string kWater = R"(Material "glass" "float index" [1.33]
Shape "trianglemesh" "point P" [-2 0.5 -2  2 0.5 -2  2 0.6 2  -2 0.4 2] "integer indices" [0 2 1 0 3 2]
  "normal N" [0.2 1 0  -0.2 1 0.1  0.1 1 -0.2  0 1 0.1]
)";
const std::string kSky = "LightSource \"infinite\" \"rgb L\" [1 1.2 1.5]\n";
/// Water whose surface waves, so that several chains lead to a place.
std::string waves() {
  constexpr int kRows = 48;
  std::string points;
  std::string normals;
  std::string indices;
  for (int y = 0; y <= kRows; ++y) {
    for (int x = 0; x <= kRows; ++x) {
      const double px = 4.0 * x / kRows - 2.0;
      const double pz = 4.0 * y / kRows - 2.0;
      const double a = 9.0 * px + 4.0 * pz;
      const double b = 6.0 * px - 10.0 * pz;
      const double dx = 0.06 * (9.0 * std::cos(a) + 6.0 * std::cos(b));
      const double dz = 0.06 * (4.0 * std::cos(a) - 10.0 * std::cos(b));
      points += std::to_string(px) + " " +
                std::to_string(0.7 + 0.06 * (std::sin(a) + std::sin(b))) + " " +
                std::to_string(pz) + "\n";
      normals += std::to_string(-dx) + " 1 " + std::to_string(-dz) + "\n";
      if (x == kRows || y == kRows) continue;
      const int at = y * (kRows + 1) + x;
      for (const int i : {at, at + kRows + 2, at + 1, at, at + kRows + 1, at + kRows + 2}) {
        indices += std::to_string(i) + " ";
      }
    }
  }
  return "Material \"glass\" \"float index\" [1.33]\nShape \"trianglemesh\" \"point P\" [" +
         points + "] \"normal N\" [" + normals + "] \"integer indices\" [" + indices + "]\n";
}

std::string over_water(const std::string& world) {
  return test::pbrt_scene(
      "LookAt 0 2.4 -2.2  0 0 0.1  0 1 0\nCamera \"perspective\" \"float fov\" [40]", 24, 16,
      world);
}
std::string foggy_water() {
  return over_water(R"(MakeNamedMedium "fog" "string type" "homogeneous"
  "rgb sigma_a" [0.05 0.1 0.1] "rgb sigma_s" [0.6 0.4 0.8] "float g" [0.4]
)" + test::lamp_over_floor() +
                    "MediumInterface \"fog\" \"\"\n" + kWater);
}

/// A lamp that shines to the right, on a mirror, which throws its light on water behind the lamp.
std::string lamp_by_a_mirror() {
  return over_water(R"(AttributeBegin
  AreaLightSource "diffuse" "rgb L" [8 7 6]
  Shape "trianglemesh" "point P" [0.4 0.9 -0.4  0.4 1.7 -0.4  0.4 1.7 0.4  0.4 0.9 0.4]
    "integer indices" [0 1 2 0 2 3] "normal N" [1 0 0  1 0 0  1 0 0  1 0 0]
AttributeEnd
Material "mirror"
Shape "trianglemesh" "point P" [1 -1 -2  1 3 -2  1 3 2  1 -1 2] "integer indices" [0 1 2 0 2 3]
)" + kPoolFloor + kWater);
}

struct SeedsCase {
  const char* name;
  std::string text;
};
void PrintTo(const SeedsCase& c, std::ostream* out) { *out << c.name; }

class ManifoldSeedsOf : public ::testing::TestWithParam<SeedsCase> {};

/// Light of samples in each part of the picture, and, last, in all of it.
class Tiles {
 public:
  explicit Tiles(const Scene& scene) : size_(scene.camera().resolution()) {}
  void add(const Path& path, double brings) {
    const auto along = [](float share) {
      return std::clamp(static_cast<int>(share * kTiles), 0, kTiles - 1);
    };
    const int tile = along(path.raster.y / size_.y) * kTiles + along(path.raster.x / size_.x);
    of_sample_[static_cast<std::size_t>(tile)] += brings;
    of_sample_.back() += brings;
  }
  void end_sample() {
    for (std::size_t i = 0; i < moments_.size(); ++i) moments_[i].add(of_sample_[i]);
    of_sample_.fill(0.0);
  }
  std::span<const Moments> moments() const { return moments_; }

 private:
  static constexpr int kTiles = 3;
  Vec2 size_;
  std::array<double, kTiles * kTiles + 1> of_sample_{};
  std::array<Moments, kTiles * kTiles + 1> moments_;
};

/// For each that may run into the light, of a render; here each is tried as often.
constexpr double kTries = 0.5;

double error_of_difference(const Moments& a, const Moments& b) {
  return std::hypot(a.standard_error(), b.standard_error());
}

void join_by_manifolds(const Scene& scene, std::uint32_t tries, Tiles& joined,
                       int longest = test::kPathSampleDepth) {
  const SpecularPhotons photons(scene);
  PathBounds bounds = test::path_sample_bounds(scene);
  bounds.max_depth = longest;
  ManifoldSeeds seeds(scene, photons, bounds, kTries);
  for (std::uint32_t i = 0; i < tries; ++i) {
    IndependentSource source({8, i, 8, i});
    const Vec2 raster =
        bounds.area.raster(source.get_pair({Stream::Camera, 0, kEmissionDirection}));
    const auto key = hash_numbers(77, i);
    for (const ManifoldSeeds::Seed& seed : seeds.sample(source, raster, key)) {
      ASSERT_TRUE(is_hit_only(seed.path));
      const double light = contribution(scene, seed.path).log_luminance() + seed.log_factor;
      joined.add(seed.path, std::exp(light) * seeds.inverse_chance(seed));
    }
    joined.end_sample();
  }
}

TEST_P(ManifoldSeedsOf, AddTheLightMissedByUnidirectionalHits) {
  const auto scene = test::scene_from(GetParam().text);
  const SpecularPhotons photons(*scene);
  const PathBounds bounds = test::path_sample_bounds(*scene);
  ManifoldSeeds seeds(*scene, photons, bounds, kTries);
  Tiles hits(*scene);
  test::for_samples(
      *scene, 150000, [&](std::uint32_t sample, const std::vector<test::WeightedPath>& paths) {
        for (const test::WeightedPath& weighted : paths) {
          if (!is_hit_only(weighted.path)) continue;
          const auto edges = static_cast<std::uint64_t>(weighted.path.depth());
          const double share = seeds.hit_share(weighted.path, hash_numbers(78, sample, edges));
          hits.add(weighted.path, weighted.weight * (1.0 - share));
        }
        hits.end_sample();
      });
  Tiles joined(*scene);
  join_by_manifolds(*scene, 60000, joined);
  for (std::size_t i = 0; i < hits.moments().size(); ++i) {
    const Moments& a = hits.moments()[i];
    const Moments& b = joined.moments()[i];
    EXPECT_LT(std::abs(a.mean() - b.mean()), 5.0 * error_of_difference(a, b)) << "tile " << i;
  }
  const Moments& all = hits.moments().back();
  EXPECT_LT(5.0 * error_of_difference(all, joined.moments().back()), 0.2 * all.mean())
      << "too noisy to notice what it is for";
}

/// A seed has a large weight if its chain is hard to find. But where a ray may run into the lamp,
/// its weight is no more than that of such a ray.
TEST(ManifoldSeeds, AreNoBrighterThanUnidirectionalHits) {
  const auto scene = test::scene_from(over_water(test::lamp_over_floor() + waves()));
  const SpecularPhotons photons(*scene);
  const PathBounds bounds = test::path_sample_bounds(*scene);
  ManifoldSeeds seeds(*scene, photons, bounds, kTries);
  int found = 0;
  double most = 0.0;
  for (std::uint32_t i = 0; i < 20000; ++i) {
    IndependentSource source({9, i, 9, i});
    const Vec2 raster =
        bounds.area.raster(source.get_pair({Stream::Camera, 0, kEmissionDirection}));
    for (const ManifoldSeeds::Seed& seed : seeds.sample(source, raster, hash_numbers(79, i))) {
      ++found;
      ASSERT_GT(seed.least_hit_share, 0.0);
      most = std::max(most, seeds.inverse_chance(seed) * seed.least_hit_share);
    }
  }
  EXPECT_GT(found, 1000);
  EXPECT_GT(most, 0.5) << "no chain is so hard to find that it matters";
  EXPECT_LT(most, 1.0 + 1e-6);
}

/// A lamp without extent, and one that is as good as the same.
struct PointCase {
  const char* name;
  std::string point;
  std::string small;
  std::string world;
  std::uint32_t tries;
};
void PrintTo(const PointCase& c, std::ostream* out) { *out << c.name; }

/// A sphere that shines as a point does.
std::string small_sphere(const char* at, double radius, double intensity = 1.0) {
  const std::string r = std::to_string(radius);
  const std::string radiance = std::to_string(intensity / (std::numbers::pi * radius * radius));
  return "AttributeBegin\nTranslate " + std::string(at) +
         "\nAreaLightSource \"diffuse\" \"rgb L\" [" + radiance + " " + radiance + " " + radiance +
         "]\nShape \"sphere\" \"float radius\" [" + r + "]\nAttributeEnd\n";
}

class ManifoldSeedsOfPoints : public ::testing::TestWithParam<PointCase> {};

TEST_P(ManifoldSeedsOfPoints, MatchSmallLamps) {
  const auto point = test::scene_from(over_water(GetParam().point + GetParam().world));
  const auto small = test::scene_from(over_water(GetParam().small + GetParam().world));
  Tiles a(*point);
  Tiles b(*small);
  join_by_manifolds(*point, GetParam().tries, a);
  join_by_manifolds(*small, GetParam().tries, b);
  for (std::size_t i = 0; i < a.moments().size(); ++i) {
    EXPECT_LT(std::abs(a.moments()[i].mean() - b.moments()[i].mean()),
              5.0 * error_of_difference(a.moments()[i], b.moments()[i]))
        << "tile " << i;
  }
  const Moments& all = b.moments().back();
  EXPECT_LT(5.0 * error_of_difference(a.moments().back(), all), 0.2 * all.mean())
      << "too noisy to notice what it is for";
}

/// The weight of a chain of waves is the number of guesses to find it again: of each place on the
/// floor, all that come in one of fifty guesses.
TEST(ManifoldConnection, CountsGuessesByTheChanceToFindAChain) {
  const auto scene = test::scene_from(over_water(test::lamp_over_floor() + waves()));
  const SpecularPhotons photons(*scene);
  ManifoldConnection connection(*scene, photons);
  const Light& light = *scene->lights().front();
  const auto lit = light.sample_emission({0.5F, {0.4F, 0.3F}, {0.2F, 0.3F}});
  ASSERT_TRUE(lit);
  int chains = 0;
  for (const float x : {-0.8F, -0.1F, 0.7F}) {
    const auto hit = scene->intersect({Vec3(x, 0.3F, 0.2F), Vec3(0.F, -1.F, 0.F)});
    ASSERT_TRUE(hit);
    InnerVertex seen;
    seen.hit = *hit;
    seen.hit.material->bsdf(seen.hit.point, seen.bsdf);
    const ManifoldConnection::Ends ends{light, lit->point, seen, 3};
    constexpr std::uint64_t kGuesses = 20000;
    struct Found {
      std::vector<InnerVertex> chain;
      double times = 0.0;
    };
    std::vector<Found> all;
    for (std::uint64_t i = 0; i < kGuesses; ++i) {
      if (!connection.find(ends, hash_numbers(5, i))) continue;
      const auto chain = connection.chain();
      const auto same = std::find_if(all.begin(), all.end(), [&](const Found& known) {
        return known.chain.size() == chain.size() &&
               length(known.chain.front().p() - chain.front().p()) < 1e-3F;
      });
      if (same == all.end()) {
        all.push_back({{chain.begin(), chain.end()}, 1.0});
      } else {
        same->times += 1.0;
      }
    }
    for (const Found& found : all) {
      const double chance = found.times / kGuesses;
      if (chance < 0.02) continue;
      ++chains;
      Moments guesses;
      for (std::uint64_t i = 0; i < 400; ++i) {
        guesses.add(connection.inverse_chance(ends, found.chain, 1.0, hash_numbers(6, i)));
      }
      const double error =
          std::hypot(guesses.standard_error() * chance, 1.0 / std::sqrt(found.times));
      EXPECT_NEAR(guesses.mean() * chance, 1.0, 5.0 * error);
    }
  }
  EXPECT_GT(chains, 3) << "one at each place says little";
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, ManifoldSeedsOf,
    ::testing::Values(SeedsCase{"Lenses", test::path_scene("Lenses")},
                      SeedsCase{"Instances", test::path_scene("Instances")},
                      SeedsCase{"Water", over_water(test::lamp_over_floor() + kWater)},
                      SeedsCase{"WaterUnderASky", over_water(kSky + kPoolFloor + kWater)},
                      SeedsCase{"Waves", over_water(test::lamp_over_floor() + waves())},
                      SeedsCase{"FoggyWater", foggy_water()},
                      SeedsCase{"LampByAMirror", lamp_by_a_mirror()}),
    [](const auto& scene_info) { return std::string(scene_info.param.name); });

/// Lit by a mirror alone: direct light of the lamp is blocked.
std::string lit_by_a_mirror() {
  return R"(Material "mirror"
Shape "trianglemesh" "point P" [1 -1 -2  1 3 -2  1 3 2  1 -1 2] "integer indices" [0 1 2 0 2 3]
Material "matte" "rgb Kd" [0 0 0]
Shape "trianglemesh" "point P" [-0.03 1.4 -0.1  0.42 1.4 -0.1  0.42 1.4 0.5  -0.03 1.4 0.5]
  "integer indices" [0 1 2 0 2 3]
)" + kPoolFloor +
         kWater;
}

const std::string kPointLamp =
    "LightSource \"point\" \"point from\" [0.3 1.6 0.2] \"rgb I\" [1 1 1]\n";
/// Toward the mirror; most of the floor lies outside of its cone.
const std::string kSpotLamp =
    R"(LightSource "spot" "point from" [0.3 1.6 0.2] "point to" [1.3 1.6 0.2]
  "float coneangle" [80] "float conedeltaangle" [0.001] "rgb I" [1 1 1]
)";
const std::string kDistantLamp = R"(LightSource "distant" "point from" [0.3 0.9 0.316227766]
  "point to" [0 0 0] "rgb L" [1 1 1]
)";
const std::string kSphereLamp = small_sphere("0.3 1.6 0.2", 0.02);
const std::string kFarLamp = R"(LightSource "point" "point from" [3000 9000 3162.27766]
  "rgb I" [1e8 1e8 1e8]
)";
INSTANTIATE_TEST_SUITE_P(
    Lamps, ManifoldSeedsOfPoints,
    ::testing::Values(PointCase{"Point", kPointLamp, kSphereLamp, kPoolFloor + kWater, 20000},
                      PointCase{"PointOverWaves", kPointLamp, kSphereLamp, kPoolFloor + waves(),
                                120000},
                      PointCase{"Spot", kSpotLamp, kPointLamp, lit_by_a_mirror(), 20000},
                      PointCase{"Distant", kDistantLamp, kFarLamp, kPoolFloor + kWater, 20000}),
    [](const auto& lamps) { return std::string(lamps.param.name); });

/// Guesses from far away are much as those from infinity, though fewer photons guide them.
TEST(ManifoldConnection, FindsChainsFromAfarAsFromInfinity) {
  const auto finds = [](const std::string& lamp) {
    const auto scene = test::scene_from(over_water(lamp + kPoolFloor + waves()));
    const SpecularPhotons photons(*scene);
    ManifoldConnection connection(*scene, photons);
    const Light& light = *scene->lights().front();
    double found = 0.0;
    for (const float x : {-0.8F, -0.1F, 0.7F}) {
      const auto hit = scene->intersect({Vec3(x, 0.3F, 0.2F), Vec3(0.F, -1.F, 0.F)});
      InnerVertex seen;
      seen.hit = hit.value();
      seen.hit.material->bsdf(seen.hit.point, seen.bsdf);
      for (std::uint64_t i = 0; i < 4000; ++i) {
        found +=
            connection.find({light, light.only_point(), seen, 3}, hash_numbers(9, i)) ? 1.0 : 0.0;
      }
    }
    return found;
  };
  const double from_infinity = finds(kDistantLamp);
  ASSERT_GT(from_infinity, 2000.0);
  // At a thousand, and a million times the size of the scene.
  for (const char* lamp :
       {"LightSource \"point\" \"point from\" [3e3 9e3 3.16227766e3] \"rgb I\" [1e8 1e8 1e8]\n",
        "LightSource \"point\" \"point from\" [3e6 9e6 3.16227766e6] \"rgb I\" [1e14 1e14 "
        "1e14]\n"}) {
    EXPECT_GT(finds(lamp), 0.5 * from_infinity) << lamp;
  }
}

/// Nor do bidirectional mutations make it, so chains of it do without them.
TEST(PointLampsThroughWater, AreNotForBidirectionalMutations) {
  const auto scene = test::scene_from(over_water(kPointLamp + kPoolFloor + kWater));
  test::RenderOptions options;
  options.min_depth = options.max_depth = 4;
  options.integrator = "mlt";
  options.parameters = {{"bootstrap", "5000"}};
  options.samples = 4;
  const MethodReport report = test::render(*scene, options).integrator->report();
  for (const auto& move : report["acceptance"]["by_move"]) {
    const bool walks = move["move"] == "manifold";
    EXPECT_EQ(move["proposals"].get<std::uint64_t>() > 0, walks) << move;
    if (walks) {
      EXPECT_GT(move["acceptance"].get<double>(), 0.5);
    }
  }
}

/// Light that no technique makes is in the pictures of those that find it, beside `bdpt`'s light of
/// a sky, and where there is nothing else: of four edges, over a floor that is the only thing to
/// scatter light.
TEST(PointLampsThroughWater, AreInThePictures) {
  constexpr int kEdges = 4;
  const std::string pool = kPointLamp + kPoolFloor + kWater;
  const auto scene =
      test::scene_from(over_water(pool + "LightSource \"infinite\" \"rgb L\" [0.02 0.02 0.02]\n"));
  const auto by_night = test::scene_from(over_water(pool));
  test::RenderOptions options;
  options.min_depth = kEdges;
  options.max_depth = kEdges;
  const auto means_of = [&](const Scene& lit, const char* integrator, int samples,
                            const std::map<std::string, std::string>& parameters) {
    options.integrator = integrator;
    options.samples = samples;
    options.parameters = parameters;
    Moments means;
    for (options.seed = 1; options.seed <= 6; ++options.seed) {
      means.add(test::render(lit, options).mean());
    }
    return means;
  };
  const Moments others = means_of(*scene, "bdpt", 64, {});
  // By night, since they find some of the light of a sky, too, which others make.
  Tiles joined(*by_night);
  join_by_manifolds(*by_night, 20000, joined, kEdges);
  const Spectrum floor(0.7F, 0.6F, 0.5F);  // 0.6 on average
  const double of_luminance = 0.6 / static_cast<double>(luminance(floor));
  const Moments& all = joined.moments().back();
  const double missing = all.mean() * of_luminance;
  ASSERT_GT(missing, others.mean()) << "there is too little of it to be missed";
  struct Case {
    const char* integrator;
    int samples;
    std::map<std::string, std::string> parameters;
  };
  for (const Case& c : {Case{"mlt", 16, {{"bootstrap", "20000"}}},
                        Case{"erpt", 64, {{"bootstrap", "2000"}}}, Case{"selective", 32, {}}}) {
    const Moments means = means_of(*scene, c.integrator, c.samples, c.parameters);
    const double error = std::hypot(means.standard_error(), others.standard_error(),
                                    all.standard_error() * of_luminance);
    EXPECT_NEAR(means.mean(), others.mean() + missing, 5.0 * error) << c.integrator;
    EXPECT_LT(5.0 * error, 0.6 * missing)
        << c.integrator << ": too noisy to notice what is missing";
  }
  // Its pilot is black then.
  const Moments alone = means_of(*by_night, "selective", 32, {});
  const double error = std::hypot(alone.standard_error(), all.standard_error() * of_luminance);
  EXPECT_NEAR(alone.mean(), missing, 5.0 * error);
  EXPECT_LT(5.0 * error, 0.6 * missing) << "too noisy to notice what is missing";
}

}  // namespace
}  // namespace ajar
