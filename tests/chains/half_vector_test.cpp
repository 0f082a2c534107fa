#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "mcmc/moments.h"
#include "mcmc/path_space/half_vector_perturbation.h"
#include "support/path_samples.h"
#include "support/render.h"

/// Densities of perturbations through glossy vertices.
namespace ajar {
namespace {

/// A thing that vertices are on.
struct Thing {
  char name;
  /// Radius of a region around a vertex, scene units.
  float radius;
};
constexpr Thing kBall{'b', 0.006F};
constexpr Thing kPlainFloor{'f', 0.025F};
constexpr Thing kWall{'w', 0.09F};
constexpr Thing kPane{'p', 0.015F};
const char* const kFrontCamera =
    "LookAt 0 0.9 -1  0 0 0.1  0 1 0\nCamera \"perspective\" \"float fov\" [50]";
const Vec3 kMiddle(0.F, 0.6F, 0.1F);  ///< centre of the ball

struct HalfVectorCase {
  const char* name;
  std::string things;     ///< pbrt-v3
  std::vector<Thing> on;  ///< things that the vertices of the path are on, from the light
  std::size_t glossy;     ///< index of the glossy vertex
};

void PrintTo(const HalfVectorCase& c, std::ostream* out) { *out << c.name; }

const std::string kMatte = "Material \"matte\" \"rgb Kd\" [0.7 0.6 0.5]\n";
const std::string kMetal =
    "Material \"metal\" \"float roughness\" [0.1] \"bool remaproughness\" \"false\"\n";
const std::string kFrosted = R"(Material "glass" "float index" [2] "bool remaproughness" "false"
  "float uroughness" [0.12] "float vroughness" [0.12]
)";
const std::string kSphere = R"(Translate 0 0.6 0.1 Scale 0.3 0.3 0.3 Shape "sphere"
)";

std::string square_at(const std::string& y) {
  return R"(Shape "trianglemesh" "integer indices" [0 2 1 0 3 2]
  "point P" [-3 )" +
         y + " -3  3 " + y + " -3  3 " + y + " 3  -3 " + y + " 3]\n";
}

std::string spot_on(const std::string& place, const std::string& from = "0.6 1.4 0.1") {
  return R"(LightSource "spot" "rgb I" [8 7 6]
  "float coneangle" [15] "float conedeltaangle" [2] "point to" [)" +
         place + "] \"point from\" [" + from + "]\n";
}

std::vector<HalfVectorCase> cases() {
  const std::string wall = R"(Shape "trianglemesh" "integer indices" [0 2 1 0 3 2]
  "point P" [-3 0 1.5  3 0 1.5  3 3 1.5  -3 3 1.5])";
  return {
      {"MetalBallBeforeFloor",
       spot_on("0 0.6 0.1", "0.8 0.3 -0.5") + kMatte + square_at("0") + kMetal + kSphere,
       {kBall, kPlainFloor},
       0},
      {"WallInMetalFloor",
       spot_on("0 0.5 1.5") + kMetal + square_at("0") + kMatte + wall,
       {kWall, kPlainFloor},
       1},
      {"FloorUnderFrost",
       spot_on("0 0.6 0.1") + kMatte + square_at("0") + kFrosted + square_at("1"),
       {kPane, kPlainFloor},
       0},
  };
}

bool is_on(const Thing& thing, const Vec3& p) {
  constexpr float kNear = 1e-4F;
  switch (thing.name) {
    case 'b':
      return std::abs(length(p - kMiddle) - 0.3F) < kNear;
    case 'w':
      return std::abs(p.z - 1.5F) < kNear;
    default:
      return std::abs(p.y - (thing.name == 'p' ? 1.F : 0.F)) < kNear;
  }
}

OffsetNormal offset_of(const Path& path, std::size_t v) {
  const Vec3 p = path.vertices[v].p();
  const Vec3 light = v == 0 ? path.light_point.surface.p : path.vertices[v - 1].p();
  const bool is_last = v + 1 == path.vertices.size();
  const Vec3 camera = is_last ? path.camera_point.surface.p : path.vertices[v + 1].p();
  return *offset_normal(path.vertices[v], Vec3d(normalize(camera - p)),
                        Vec3d(normalize(light - p)));
}

/// One of the case, away from the edges of the picture, with half vectors near the normals.
Path path_of(const Scene& scene, const HalfVectorCase& c, const PathMutation& mutation) {
  std::optional<Path> found;
  test::for_samples(
      scene, 200000, [&](std::uint32_t, const std::vector<test::WeightedPath>& paths) {
        for (const test::WeightedPath& weighted : paths) {
          if (found) break;
          const Path& path = weighted.path;
          bool fits = path.vertices.size() == c.on.size() && path.raster.x > 8.F &&
                      path.raster.x < 40.F && path.raster.y > 8.F && path.raster.y < 24.F;
          for (std::size_t i = 0; fits && i < c.on.size(); ++i) {
            fits = is_on(c.on[i], path.vertices[i].p());
          }
          if (!fits) continue;
          const OffsetNormal offset = offset_of(path, c.glossy);
          fits = std::hypot(offset.x, offset.y) < 0.03;
          if (fits && mutation.suitable(path)) found = path;
        }
      });
  if (!found) throw std::logic_error("no such path");
  return *found;
}

class HalfVector : public ::testing::TestWithParam<HalfVectorCase> {};

/// A move of `x` that is neither near the least nor near the largest.
Path moved(const Path& x, const HalfVectorCase& c, PathMutation& mutation) {
  const OffsetNormal old = offset_of(x, c.glossy);
  Path y;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    if (!mutation.propose(x, hash_numbers(6, i), y) || !mutation.suitable(y)) continue;
    const float on_film = (y.raster - x.raster).length();
    const OffsetNormal offset = offset_of(y, c.glossy);
    const double turn = std::hypot(offset.x - old.x, offset.y - old.y);
    if (on_film > 0.9F && on_film < 1.4F && turn > 0.03 && turn < 0.05) return y;
  }
  throw std::logic_error("no such move");
}

/// The mean over proposals of 1/T is the size of the region that they are in, if T is their
/// density: here the product of discs, which have the same area on a sphere as on a plane.
TEST_P(HalfVector, FollowsItsDensity) {
  const HalfVectorCase& c = GetParam();
  const auto scene = test::scene_from(test::pbrt_scene(kFrontCamera, 48, 32, c.things));
  const PathBounds bounds = test::path_sample_bounds(*scene);
  HalfVectorPerturbation mutation(*scene, bounds.area);
  const Path x = path_of(*scene, c, mutation);
  const Path middle = moved(x, c, mutation);
  double size = 1.0;
  for (const Thing& thing : c.on) {
    size *= std::numbers::pi * double{thing.radius} * double{thing.radius};
  }
  Moments found;
  int unsuitable = 0;
  Path y;
  for (std::uint64_t i = 0; i < 400000; ++i) {
    const auto kept = mutation.propose(x, hash_numbers(5, i), y);
    bool inside = kept.has_value();
    for (std::size_t v = 0; inside && v < c.on.size(); ++v) {
      inside = length(y.vertices[v].p() - middle.vertices[v].p()) < c.on[v].radius;
    }
    if (inside && !mutation.suitable(y)) ++unsuitable;
    found.add(inside ? std::exp(-mutation.log_density(x, y, *kept)) / size : 0.0);
  }
  EXPECT_EQ(unsuitable, 0) << "the region is too large";
  const double error = found.standard_error();
  EXPECT_NEAR(found.mean(), 1.0, 5.0 * error);
  EXPECT_LT(5.0 * error, 0.4) << "too noisy to notice what it should";
}

INSTANTIATE_TEST_SUITE_P(Chains, HalfVector, ::testing::ValuesIn(cases()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace ajar
