#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/random.h"
#include "mcmc/path_space/half_vector_perturbation.h"
#include "mcmc/path_space/make_path_mutations.h"
#include "mcmc/path_space/manifold_perturbation.h"
#include "mcmc/path_space/path_form.h"
#include "mcmc/primary/bootstrap_source.h"
#include "path/manifold_walk.h"
#include "support/path_samples.h"
#include "support/path_scenes.h"
#include "support/render.h"
#include "support/small_scenes.h"

/// Moves by manifold walks: their paths, and the reverse walk to the original path.
namespace ajar {
namespace {

// A ball of glass on the axis of a spot, above a floor that some of its rays have crossed the axis
// before, and others after: scene units.
constexpr double kLampHeight = 2.3;
constexpr double kBallHeight = 0.8;
constexpr double kBallRadius = 0.4;
constexpr double kGlass = 1.4;

std::string ball_on_the_axis() {
  return test::pbrt_scene(
      "LookAt 0 0.25 -0.7  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [22]", 32, 32, R"(
LightSource "spot" "point from" [0 2.3 0] "point to" [0 0 0] "rgb I" [8 7 6]
  "float coneangle" [16] "float conedeltaangle" [1]
Material "matte" "rgb Kd" [0.7 0.6 0.5]
Shape "trianglemesh" "point P" [-2 0 -2  2 0 -2  2 0 2  -2 0 2] "integer indices" [0 2 1 0 3 2]
Material "glass" "float index" [1.4]
Translate 0 0.8 0
Shape "sphere" "float radius" [0.4]
)");
}

/// Distance from the axis at which the ray that leaves the lamp at this angle meets the floor;
/// negative beyond the axis.
double landing(double angle) {
  struct {
    double x, y;
  } d{std::sin(angle), -std::cos(angle)};
  const double b = (kLampHeight - kBallHeight) * d.y;
  const double height = kLampHeight - kBallHeight;
  const double t = -b - std::sqrt(b * b - height * height + kBallRadius * kBallRadius);
  double x = t * d.x;
  double y = height + t * d.y;
  const auto refract = [&](double nx, double ny, double eta) {
    const double cosine = -(d.x * nx + d.y * ny);
    const double along = eta * cosine - std::sqrt(1.0 - eta * eta * (1.0 - cosine * cosine));
    d = {eta * d.x + along * nx, eta * d.y + along * ny};
  };
  refract(x / kBallRadius, y / kBallRadius, 1.0 / kGlass);
  const double way = -2.0 * (x * d.x + y * d.y);
  x += way * d.x;
  y += way * d.y;
  refract(-x / kBallRadius, -y / kBallRadius, kGlass);
  return x - (y + kBallHeight) / d.y * d.x;
}

/// The angle whose ray lands the farthest on its own side: there two chains become one.
double angle_of_fold() {
  double low = 0.0;
  double high = 0.2;
  for (int i = 0; i < 60; ++i) {
    const double a = low + (high - low) / 3.0;
    const double b = high - (high - low) / 3.0;
    (landing(a) < landing(b) ? low : high) = landing(a) < landing(b) ? a : b;
  }
  return 0.5 * (low + high);
}

/// Up to three chains lead from the lamp through the ball to one place on the floor.
enum class Branch : std::uint8_t { Inner, Outer, FromBeyondTheAxis };

Branch branch_of(const InnerVertex& first, const Vec3& on_floor, double fold) {
  const Vec3& p = first.p();
  if (p.x * on_floor.x + p.z * on_floor.z < 0.F) return Branch::FromBeyondTheAxis;
  const double angle = std::atan2(std::hypot(double{p.x}, double{p.z}), kLampHeight - double{p.y});
  return angle < fold ? Branch::Inner : Branch::Outer;
}

bool is_through_ball(const Path& path) {
  return path.depth() == 4 && path.vertex(1).event.specular() &&
         path.vertex(1).event.transmission && path.vertex(2).event.specular() &&
         path.vertex(2).event.transmission && std::abs(path.vertex(3).p().y) < 1e-4F;
}

/// Near the border of the caustic the other chain is within the tolerance of walks.
TEST(ManifoldPerturbation, RejectsWalksThatComeBackToAnotherChain) {
  const auto scene = test::scene_from(ball_on_the_axis());
  const PathBounds bounds = test::path_sample_bounds(*scene);
  ManifoldPerturbation mutation(*scene, bounds.area);
  ManifoldWalk back(*scene);
  const double fold = angle_of_fold();
  const double farthest = landing(fold);
  int made = 0;
  int near_border = 0;
  int elsewhere = 0;
  int one_way = 0;
  float farthest_off = 0.F;
  Path y;
  test::for_samples(
      *scene, 12000, [&](std::uint32_t sample, const std::vector<test::WeightedPath>& paths) {
        for (const test::WeightedPath& weighted : paths) {
          const Path& x = weighted.path;
          if (!is_through_ball(x)) continue;
          const Vec3& end = x.vertex(3).p();
          const double beside = farthest - std::hypot(double{end.x}, double{end.z});
          const Branch branch = branch_of(x.vertex(1), end, fold);
          const bool is_near = std::abs(beside) < 2e-4 && branch != Branch::FromBeyondTheAxis;
          for (std::uint64_t i = 0; i < (is_near ? 64U : 1U); ++i) {
            const auto kept = mutation.propose(x, hash_numbers(8, sample, i), y);
            if (!kept) {
              if (mutation.walk_end() == WalkEnd::OneWay) ++one_way;
              continue;
            }
            ++made;
            if (is_near) ++near_border;
            ASSERT_TRUE(back.walk(chain_start(y, 0), std::span(y.vertices).first(2), end));
            const auto came_to = back.vertices();
            if (branch_of(came_to[0], end, fold) != branch) ++elsewhere;
            float missed = 0.F;
            float moved = 0.F;
            for (std::size_t v = 0; v < 2; ++v) {
              missed = std::max(missed, length(came_to[v].p() - x.vertices[v].p()));
              moved = std::max(moved, length(y.vertices[v].p() - x.vertices[v].p()));
            }
            farthest_off = std::max(farthest_off, missed / moved);
          }
        }
      });
  EXPECT_EQ(elsewhere, 0) << "of " << made << ", " << near_border << " near the border";
  EXPECT_LT(farthest_off, 0.6F) << "of a move: that is no way back";
  EXPECT_GT(near_border, 500);
  EXPECT_GT(one_way, 500);
}

std::string pool_of(const std::string& water) {
  return test::pbrt_scene(
      "LookAt 0 1.6 -3  0 0.4 0.3  0 1 0\nCamera \"perspective\" \"float fov\" [45]", 24, 16,
      test::lamp_over_floor() + R"(
Texture "waves" "float" "wrinkled" "float roughness" [0.5]
Texture "patches" "float" "checkerboard" "float tex1" [1.33] "float tex2" [1.5]
Material "glass" )" +
          water +
          R"(
Shape "trianglemesh" "point P" [-2 0.5 -2  2 0.5 -2  2 0.5 2  -2 0.5 2] "integer indices" [0 2 1 0 3 2]
  "float uv" [0 0  1 0  1 1  0 1]
)");
}

struct Suited {
  int in_form = 0;  ///< paths that light reaches through the water
  int manifold = 0;
  int half_vector = 0;
};
Suited suited(const std::string& text, int depth) {
  const auto scene = test::scene_from(text);
  const PathBounds bounds = test::path_sample_bounds(*scene);
  const ManifoldPerturbation manifold(*scene, bounds.area);
  const HalfVectorPerturbation half_vector(*scene, bounds.area);
  Suited result;
  test::for_samples(*scene, 20000,
                    [&](std::uint32_t, const std::vector<test::WeightedPath>& paths) {
                      for (const test::WeightedPath& weighted : paths) {
                        const Path& path = weighted.path;
                        if (path.depth() != depth || !path.vertex(1).event.specular()) continue;
                        ++result.in_form;
                        if (manifold.suitable(path)) ++result.manifold;
                        if (half_vector.suitable(path)) ++result.half_vector;
                      }
                    });
  return result;
}

/// Where walks can never arrive, steps would be lost.
TEST(ManifoldPerturbation, IsForChainsThatCanHoldTheirConstraints) {
  const Suited flat = suited(pool_of("\"float index\" [1.33]"), 4);
  EXPECT_GT(flat.in_form, 30);
  EXPECT_EQ(flat.manifold, flat.in_form);
  for (const char* water :
       {"\"float index\" [1.33] \"texture bumpmap\" \"waves\"", "\"texture index\" \"patches\""}) {
    const Suited other = suited(pool_of(water), 4);
    EXPECT_GT(other.in_form, 30) << water;
    EXPECT_EQ(other.manifold, 0) << water;
  }
}

/// A floor of metal under the water, in which a wall is seen.
TEST(HalfVectorPerturbation, IsForChainsThatCanHoldTheirConstraints) {
  const auto pool = [](const std::string& water) {
    std::string text = pool_of(water);
    const std::string matte = "Material \"matte\" \"rgb Kd\" [0.7 0.6 0.5]\n";
    const std::size_t at = text.find(matte);
    if (at == std::string::npos) throw std::logic_error("no floor");
    return text.replace(at, matte.size(),
                        matte +
                            "Shape \"trianglemesh\" \"point P\" [-2 0 1.5  2 0 1.5  2 4 1.5  -2 4 "
                            "1.5] \"integer indices\" [0 2 1 0 3 2]\n"
                            "Material \"metal\" \"float roughness\" [0.2] \"bool "
                            "remaproughness\" \"false\"\n");
  };
  const Suited flat = suited(pool("\"float index\" [1.33]"), 5);
  EXPECT_GT(flat.half_vector, 30);
  const Suited rippled = suited(pool("\"float index\" [1.33] \"texture bumpmap\" \"waves\""), 5);
  EXPECT_GT(rippled.in_form, 30);
  EXPECT_EQ(rippled.half_vector, 0);
}

/// Rays set off a little beside the points that they leave. When they ran parallel to the ones that
/// were meant, one walk in eight stopped short of its end, here where coordinates are large.
TEST(ManifoldWalk, ArrivesNearWhereItBegan) {
  const auto scene = test::scene_from(test::pbrt_scene(
      "LookAt 20 12.4 17.8  20 10 20.1  0 1 0\nCamera \"perspective\" \"float fov\" [40]", 24, 16,
      R"(
AttributeBegin
  AreaLightSource "diffuse" "rgb L" [8 7 6] "bool twosided" "true"
  Shape "trianglemesh" "point P" [20 12 20  20 12 22  20 13 22  20 13 20]
    "integer indices" [0 1 2 0 2 3]
AttributeEnd
Translate 20 10 20
Material "matte" "rgb Kd" [0.7 0.6 0.5]
Shape "trianglemesh" "point P" [-2 0 -2  2 0 -2  2 0 2  -2 0 2] "integer indices" [0 2 1 0 3 2]
Material "glass" "float index" [1.33]
Shape "trianglemesh" "point P" [-2 0.5 -2  2 0.5 -2  2 0.6 2  -2 0.4 2] "integer indices" [0 2 1 0 3 2]
  "normal N" [0.2 1 0  -0.2 1 0.1  0.1 1 -0.2  0 1 0.1]
)"));
  ManifoldWalk walk(*scene);
  int walks = 0;
  int arrived = 0;
  test::for_samples(*scene, 60000,
                    [&](std::uint32_t /*sample*/, const std::vector<test::WeightedPath>& paths) {
                      for (const test::WeightedPath& weighted : paths) {
                        const Path& x = weighted.path;
                        const int seen = first_rough_from_light(x);
                        if (seen == 1 || seen == x.depth()) continue;
                        ++walks;
                        const Vec3 beside = x.position(seen) + Vec3(1e-4F, 0.F, 1e-4F);
                        if (walk.walk(chain_start(x, 0), chain_from_light(x, 0, seen), beside))
                          ++arrived;
                      }
                    });
  EXPECT_GT(walks, 500);
  EXPECT_GT(arrived, 0.99 * walks);
}

/// Fog is where vertices of paths can lie outside of all surfaces, from where rays of walks set off
/// nearer: through the same fog.
TEST(ManifoldWalk, StartsInItsMedium) {
  const auto scene = test::scene_from(test::pbrt_scene(
      "LookAt 0 1 -3  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [40]", 8, 8, R"(
MakeNamedMedium "fog" "string type" "homogeneous" "rgb sigma_s" [0.1 0.1 0.1]
MediumInterface "" "fog"
LightSource "point" "point from" [0 2 0] "rgb I" [8 7 6]
MediumInterface "fog" "fog"
Material "matte" "rgb Kd" [0.7 0.6 0.5]
Shape "trianglemesh" "point P" [-2 0 -2  2 0 -2  2 0 2  -2 0 2] "integer indices" [0 2 1 0 3 2]
Material "glass" "float index" [1.33]
Shape "trianglemesh" "point P" [-2 0.5 -2  2 0.5 -2  2 0.5 2  -2 0.5 2] "integer indices" [0 2 1 0 3 2]
)"));
  const Medium* const fog = scene->lights().front()->medium;
  ASSERT_NE(fog, nullptr);
  ManifoldWalk walk(*scene);
  BootstrapSource numbers(1, 0);
  for (const float height : {1.F, 100.F}) {
    InnerVertex vertex;
    vertex.hit.point.p = Vec3(0.1F, height, 0.3F);
    vertex.in_medium = true;
    vertex.medium = fog;
    const ChainStart start{{Vec3d(vertex.p()), Vec3d(0.0), false}, &vertex, Vec3(0.F), nullptr};
    ASSERT_TRUE(walk.set_off(start, Vec3d(0.2, 0.5, 0.3), 4, numbers));
    EXPECT_EQ(walk.vertices().front().medium, fog) << "from a height of " << height;
  }
}

}  // namespace
}  // namespace ajar
