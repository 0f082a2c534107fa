#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/random.h"
#include "mcmc/moments.h"
#include "mcmc/path_space/make_path_mutations.h"
#include "support/path_samples.h"
#include "support/render.h"

/// Densities of moves with a specular chain, where the chain has a closed form.
namespace ajar {
namespace {

/// A specular vertex and its neighbours: that toward the camera, and that toward the light.
struct Corner {
  Vec3d before, at, after;
  double length_before() const { return (before - at).length(); }
  double length_after() const { return (after - at).length(); }
};

/// Densities leave out the delta of a specular vertex, and have |cos θ| / d² of both its edges.
/// Their ratio to the density by the area of the vertex beyond, across the ray: of a plane mirror
/// in z, whose images are as far as the way is long.
double in_a_mirror(const Corner& c) {
  const double way = c.length_before() + c.length_after();
  const double cosine = std::abs((c.before - c.at).z) / c.length_before();
  return cosine * way * way / std::pow(c.length_before() * c.length_after(), 2);
}

constexpr double kWaterIndex = 1.33;
/// A level surface of water, seen from below: by the radius r(θ) at which the ray of an angle comes
/// out above, dω / dA = sin θ dθ / (r dr cos θ′).
double out_of_water(const Corner& c) {
  const double depth = (c.at - c.before).y;
  const double height = (c.after - c.at).y;
  const double cosine = depth / c.length_before();
  const double cosine_above = height / c.length_after();
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const double radius =
      depth * sine / cosine + height * std::sqrt(1.0 - cosine_above * cosine_above) / cosine_above;
  const double widening =
      depth / (cosine * cosine) + height * kWaterIndex * cosine / std::pow(cosine_above, 3);
  const double spread = sine / (radius * widening * cosine_above);
  return cosine / std::pow(c.length_before() * c.length_after(), 2) / spread;
}

/// A disc around a vertex.
struct Disc {
  std::size_t vertex;  ///< in `Path::vertices`
  float radius;
};

struct SpecularCase {
  const char* name;
  const char* mutation;
  std::string text;
  std::vector<bool> specular;  ///< specular vertices of the path, from the light
  std::vector<Disc> discs;     ///< where vertices are in
  double (*edges_over_density)(const Corner& corner);
  std::uint64_t proposals = 200000;
};
void PrintTo(const SpecularCase& c, std::ostream* out) { *out << c.name; }

std::string plane(const std::string& points) {
  return "Shape \"trianglemesh\" \"integer indices\" [0 2 1 0 3 2] \"point P\" [" + points + "]\n";
}
std::string spot(const std::string& from, const std::string& to) {
  return "LightSource \"spot\" \"rgb I\" [8 7 6] \"float coneangle\" [40] \"point from\" [" + from +
         "] \"point to\" [" + to + "]\n";
}

std::vector<SpecularCase> specular_cases() {
  const std::string matte = "Material \"matte\" \"rgb Kd\" [0.7 0.6 0.5]\n";
  const std::string mirror =
      "Material \"mirror\"\n" + plane("-3 0 1.5  3 0 1.5  3 3 1.5  -3 3 1.5");
  const std::string floor = matte + plane("-3 0 -3  3 0 -3  3 0 3  -3 0 3");
  const std::string camera = "\"perspective\" \"float fov\" [50]";
  const std::string from_above = "LookAt 0 0.9 -1  0 0 0.3  0 1 0\nCamera " + camera;
  return {
      {"ByAMirror",
       "manifold",
       test::pbrt_scene(from_above, 48, 32, spot("0.4 1.3 0.2", "0.2 0.6 1.5") + floor + mirror),
       {true, false},
       {{1, 0.025F}},
       in_a_mirror},
      {"ThroughWater",
       "manifold",
       test::pbrt_scene("LookAt 0 0.7 -1  0 0 0.3  0 1 0\nCamera " + camera, 48, 32,
                        spot("0.5 2 0.4", "0.2 0 0.2") + floor +
                            "Material \"glass\" \"float index\" [1.33]\n" +
                            plane("-3 0.8 -3  3 0.8 -3  3 0.8 3  -3 0.8 3")),
       {true, false},
       {{1, 0.025F}},
       out_of_water},
      {"FloorBeforeAMirror",
       "multi-chain",
       test::pbrt_scene(from_above, 48, 32,
                        spot("0.3 1.4 0.3", "0 0.8 -1.5") + floor +
                            plane("-3 0 -1.5  3 0 -1.5  3 3 -1.5  -3 3 -1.5") + mirror),
       {false, true, false},
       {{2, 0.035F}, {0, 0.07F}},
       in_a_mirror,
       1000000},
  };
}

bool is_of_form(const SpecularCase& c, const Path& path) {
  if (path.vertices.size() != c.specular.size()) return false;
  for (std::size_t v = 0; v < c.specular.size(); ++v) {
    if (path.vertices[v].event.specular() != c.specular[v]) return false;
  }
  // Far from the edges of the picture, and on the floor.
  return path.raster.x > 10.F && path.raster.x < 38.F && path.raster.y > 10.F &&
         path.raster.y < 24.F && std::abs(path.vertices.back().p().y) < 1e-4F;
}

Path path_of_form(const Scene& scene, const SpecularCase& c, const PathMutation& mutation) {
  std::optional<Path> found;
  test::for_samples(scene, 20000, [&](std::uint32_t, const std::vector<test::WeightedPath>& paths) {
    for (const test::WeightedPath& weighted : paths) {
      if (!found && is_of_form(c, weighted.path) && mutation.suitable(weighted.path)) {
        found = weighted.path;
      }
    }
  });
  if (!found) throw std::logic_error("no such path");
  return *found;
}

/// By a move of middle size.
Path beside(const Path& x, const SpecularCase& c, PathMutation& mutation) {
  Path y;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    if (!mutation.propose(x, hash_numbers(6, i), y)) continue;
    const float on_film = (y.raster - x.raster).length();
    const float first = length(y.vertices.front().p() - x.vertices.front().p());
    const bool is_middling = c.discs.size() == 1 || (first > 0.08F && first < 0.16F);
    if (on_film > 1.2F && on_film < 1.8F && is_middling) return y;
  }
  throw std::logic_error("no such move");
}

Corner corner_of(const Path& path, const SpecularCase& c) {
  std::size_t v = 0;
  while (!c.specular[v]) ++v;
  const Vec3& after = v == 0 ? path.light_point.surface.p : path.vertices[v - 1].p();
  return {Vec3d(path.vertices[v + 1].p()), Vec3d(path.vertices[v].p()), Vec3d(after)};
}

class SpecularDensity : public ::testing::TestWithParam<SpecularCase> {};

/// The mean over proposals of 1/T is the size of the region that they are in, if T is their
/// density.
TEST_P(SpecularDensity, IsThatOfTheClosedForm) {
  const SpecularCase& c = GetParam();
  const auto scene = test::scene_from(c.text);
  const PathBounds bounds = test::path_sample_bounds(*scene);
  std::unique_ptr<PathMutation> mutation;
  for (const PathMutationInfo& info : path_mutations()) {
    if (info.name == c.mutation) mutation = info.make(*scene, bounds);
  }
  ASSERT_TRUE(mutation);
  const Path x = path_of_form(*scene, c, *mutation);
  const Path middle = beside(x, c, *mutation);
  double size = 1.0;
  for (const Disc& disc : c.discs) size *= std::numbers::pi * std::pow(double{disc.radius}, 2);
  Moments found;
  Path y;
  for (std::uint64_t i = 0; i < c.proposals; ++i) {
    const auto kept = mutation->propose(x, hash_numbers(5, i), y);
    bool inside = kept && y.vertices.size() == x.vertices.size();
    for (const Disc& disc : c.discs) {
      inside = inside &&
               length(y.vertices[disc.vertex].p() - middle.vertices[disc.vertex].p()) < disc.radius;
    }
    if (!inside) {
      found.add(0.0);
      continue;
    }
    const double edges = c.edges_over_density(corner_of(y, c));
    found.add(edges * std::exp(-mutation->log_density(x, y, *kept)) / size);
  }
  const double error = found.standard_error();
  EXPECT_NEAR(found.mean(), 1.0, 5.0 * error);
  EXPECT_LT(5.0 * error, 0.3) << "too noisy to notice what it should";
}

INSTANTIATE_TEST_SUITE_P(Chains, SpecularDensity, ::testing::ValuesIn(specular_cases()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace ajar
