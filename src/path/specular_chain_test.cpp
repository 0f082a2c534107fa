#include "path/specular_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "path/manifold_walk.h"
#include "path/testing/plain_scene.h"
#include "scene/testing/small_world.h"

/// Chains and walks against what rays do.
namespace ajar {
namespace {

struct Case {
  std::string name;
  std::vector<desc::Shape> shapes;
  std::vector<bool> transmissions;  ///< one per event
  double eta = 1.5;
  Vec3 start{0.3F, -0.2F, 4.F};
  Vec3 direction{-0.06F, 0.09F, -1.F};
  std::vector<OffsetNormal> offsets = {};  ///< offsets of rough surfaces; none if they are smooth
};

/// Triangles over [−2, 2]² whose normals are those of waves.
desc::Mesh waves() {
  constexpr int kCells = 24;
  desc::Mesh mesh;
  for (int j = 0; j <= kCells; ++j) {
    for (int i = 0; i <= kCells; ++i) {
      const float x = 4.F * static_cast<float>(i) / kCells - 2.F;
      const float y = 4.F * static_cast<float>(j) / kCells - 2.F;
      mesh.positions.emplace_back(x, y, 0.04F * std::sin(2.F * x) * std::cos(1.5F * y));
      mesh.normals.push_back(normalize(Vec3(-0.08F * std::cos(2.F * x) * std::cos(1.5F * y),
                                            0.06F * std::sin(2.F * x) * std::sin(1.5F * y), 1.F)));
    }
  }
  const auto at = [](int i, int j) { return static_cast<unsigned>(j * (kCells + 1) + i); };
  for (int j = 0; j < kCells; ++j) {
    for (int i = 0; i < kCells; ++i) {
      mesh.indices.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.indices.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return mesh;
}

std::vector<Case> cases() {
  const Vec3 start{0.3F, -0.2F, 4.F};
  const Vec3 direction{-0.06F, 0.09F, -1.F};
  const auto ball = testing::shape(testing::sphere_node(1.F));
  const auto egg =
      testing::shape(testing::sphere_node(1.F),
                     testing::scaling(1.3, 0.9, 0.8) * testing::rotation({1.F, 1.F, 0.F}, 0.4));
  desc::Mesh tilted = testing::square(3.F);
  const auto pane = [&](double z, double tilt) {
    return testing::mesh_shape(
        tilted, testing::rotation({0.F, 1.F, 0.F}, tilt) * testing::translation(0.0, 0.0, z));
  };
  return {{"Ball", {ball}, {true, true}},
          {"Egg", {egg}, {true, true}, 1.33},
          {"MirrorBall", {ball}, {false}},
          {"InsideOfBall", {ball}, {true, false, true}},
          {"Slab", {pane(0.5, 0.0), pane(-0.4, std::numbers::pi)}, {true, true}},
          {"Prism", {pane(0.5, 0.2), pane(-0.4, std::numbers::pi - 0.1)}, {true, true}},
          {"Waves", {testing::mesh_shape(waves())}, {true}, 1.33},
          {"RoughBall", {ball}, {true, true}, 1.5, start, direction, {{0.2, -0.1}, {-0.1, 0.25}}},
          {"RoughMetalBall", {ball}, {false}, 1.5, start, direction, {{0.3, 0.4}}},
          {"RoughEgg", {egg}, {true, false}, 1.33, start, direction, {{-0.2, 0.1}, {0.3, 0.2}}},
          {"RoughWaves",
           {testing::mesh_shape(waves())},
           {true},
           1.33,
           start,
           direction,
           {{0.3, -0.2}}}};
}

desc::SceneDesc description_of(const Case& c) {
  desc::SceneDesc scene;
  scene.shapes = c.shapes;
  desc::Material& glass = scene.materials.emplace_back();
  const float roughness = c.offsets.empty() ? 0.F : 0.3F;
  glass.node = desc::material_node("dielectric",
                                   {{"eta", static_cast<float>(c.eta)}, {"roughness", roughness}});
  for (desc::Shape& shape : scene.shapes) shape.material = 0;
  desc::Light& light = scene.lights.emplace_back();
  light.node = desc::light_node("point", {{"intensity", Vec3(1.F)}});
  scene.camera.node = desc::PerspectiveCamera{60.F, 0.F, 1e6F, {}, {}};
  scene.film.resolution = {4, 4};
  return scene;
}

std::unique_ptr<Scene> scene_of(const Case& c) {
  Warnings warnings;
  return std::make_unique<Scene>(description_of(c), BuildOptions{}, warnings);
}

/// A traced ray: its vertices, and the ray that leaves the last of them.
struct Traced {
  std::vector<InnerVertex> vertices;
  Vec3d last;
  Vec3d w;
};

std::optional<Traced> trace(const Scene& scene, const Case& c, const Vec3d& direction) {
  Traced traced;
  Ray ray{c.start, Vec3(direction.normalized())};
  for (std::size_t i = 0; i < c.transmissions.size(); ++i) {
    const auto hit = scene.intersect(ray);
    if (!hit) return std::nullopt;
    InnerVertex& vertex = traced.vertices.emplace_back();
    vertex.hit = *hit;
    vertex.hit.material->bsdf(vertex.hit.point, vertex.bsdf);
    std::optional<Vec3d> w;
    if (c.offsets.empty()) {
      vertex.event = {0, c.transmissions[i]};
      const auto sample =
          vertex.bsdf.specular(-ray.direction, vertex.event, TransportMode::Radiance);
      if (sample) w = Vec3d(sample->wi);
    } else {
      vertex.event.transmission = c.transmissions[i];
      w = turn(vertex, c.transmissions[i], c.offsets[i], Vec3d(-ray.direction));
    }
    if (!w) return std::nullopt;
    ray = {vertex.ray_origin(Vec3(*w)), Vec3(*w)};
  }
  traced.last = Vec3d(traced.vertices.back().p());
  traced.w = Vec3d(ray.direction).normalized();
  return traced;
}

/// From where a ray passes to a place, across the ray; empty if the place is behind.
std::optional<Vec3d> miss(const Traced& traced, const Vec3d& place) {
  const double ahead = (place - traced.last).dot(traced.w);
  if (!(ahead > 0.0)) return std::nullopt;
  return place - traced.last - traced.w * ahead;
}

struct Turned {
  Vec3d x, y;
};
Turned around(const Vec3d& w) {
  const Vec3d x = Vec3d(0.0, 1.0, 0.0).cross(w).normalized();
  return {x, w.cross(x)};
}

TEST(SpecularChain, SpreadAndMovesAreThoseOfRaysBeside) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const auto scene = scene_of(c);
    const Vec3d w = Vec3d(c.direction).normalized();
    const auto middle = trace(*scene, c, w);
    ASSERT_TRUE(middle);
    const Vec3d end = middle->last + middle->w * 2.0;
    SpecularChain chain(*scene);
    ASSERT_TRUE(chain.set({Vec3d(c.start)}, middle->vertices, {end}, c.offsets));
    // Where the rays beside cross the plane through the end.
    constexpr double kTurn = 1e-3;
    const Turned sides = around(w);
    Vec3d ends[2];
    int side = 0;
    for (const Vec3d& by_turn : {sides.x, sides.y}) {
      Vec3d crossing[2];
      std::vector<Vec3d> places[2];
      int which = 0;
      for (const double sign : {-1.0, 1.0}) {
        const auto beside = trace(*scene, c, w + by_turn * (sign * kTurn));
        ASSERT_TRUE(beside);
        const double way = (end - beside->last).dot(middle->w) / beside->w.dot(middle->w);
        crossing[which] = beside->last + beside->w * way;
        for (const InnerVertex& vertex : beside->vertices) {
          places[which].push_back(Vec3d(vertex.p()));
        }
        ++which;
      }
      const Vec3d by = crossing[1] - crossing[0];
      ends[side++] = by;
      for (std::size_t i = 0; i < middle->vertices.size(); ++i) {
        const Vec3d moved = places[1][i] - places[0][i];
        EXPECT_LT((chain.moved(i, by) - moved).length(), 5e-3 * moved.length())
            << "vertex " << i << " of " << moved;
      }
    }
    const double area = ends[0].cross(ends[1]).length();
    EXPECT_NEAR(chain.spread() * area / (4.0 * kTurn * kTurn), 1.0, 1e-2);
  }
}

/// Beyond a focus neighbouring rays have crossed, and beyond two again: the constraints change sign
/// with the orientation of a bundle of rays.
TEST(SpecularChain, IsMirroredWhereRaysBesideHaveCrossed) {
  int once = 0;
  int not_or_twice = 0;
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const auto scene = scene_of(c);
    std::optional<bool> known;
    for (const Vec3d& by : {Vec3d(0.0), Vec3d(0.02, 0.01, 0.0), Vec3d(-0.03, 0.05, 0.0)}) {
      const Vec3d w = (Vec3d(c.direction).normalized() + by).normalized();
      const auto middle = trace(*scene, c, w);
      ASSERT_TRUE(middle);
      const Turned sides = around(w);
      for (const double distance : {0.1, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
        const Vec3d end = middle->last + middle->w * distance;
        Vec3d moved[2];
        int side = 0;
        for (const Vec3d& by_turn : {sides.x, sides.y}) {
          const auto beside = trace(*scene, c, w + by_turn * 1e-3);
          ASSERT_TRUE(beside);
          const double way = (end - beside->last).dot(middle->w) / beside->w.dot(middle->w);
          moved[side++] = beside->last + beside->w * way - end;
        }
        const double area = moved[0].cross(moved[1]).dot(middle->w);
        // Near a focus it is undefined.
        if (std::abs(area) < 0.05 * moved[0].length() * moved[1].length()) continue;
        SpecularChain chain(*scene);
        ASSERT_TRUE(chain.set({Vec3d(c.start)}, middle->vertices, {end}, c.offsets));
        ++(area < 0.0 ? once : not_or_twice);
        const bool differs = chain.is_mirrored() != (area < 0.0);
        if (!known) known = differs;
        EXPECT_EQ(differs, *known) << "at " << distance << ", turned by " << by;
      }
    }
  }
  EXPECT_GT(once, 10);
  EXPECT_GT(not_or_twice, 10);
}

/// Its derivatives would have to know how the index goes on.
TEST(SpecularChain, IsNoneWhereTheIndexOfRefractionIsATexture) {
  const Case c = cases().front();
  desc::SceneDesc description = description_of(c);
  desc::Texture& squares = description.textures.emplace_back();
  squares.node =
      desc::texture_node("checkerboard", {{"first", Vec3(1.5F)}, {"second", Vec3(1.3F)}});
  description.materials[0].node = desc::material_node("dielectric", {{"eta", desc::TextureRef{0}}});
  Warnings warnings;
  const Scene scene(std::move(description), BuildOptions{}, warnings);
  const auto traced = trace(scene, c, Vec3d(c.direction));
  ASSERT_TRUE(traced);
  SpecularChain chain(scene);
  EXPECT_FALSE(chain.set({Vec3d(c.start)}, traced->vertices, {traced->last + traced->w * 2.0}));
}

/// Étendue is kept: of chains without shading normals η_a² dω_a / dA_b is η_b² dω_b / dA_a.
TEST(SpecularChain, SpreadIsReciprocal) {
  for (const Case& c : cases()) {
    // Not with normals that are not those of the triangles, nor with facets.
    if (c.name == "Waves" || !c.offsets.empty()) continue;
    SCOPED_TRACE(c.name);
    const auto scene = scene_of(c);
    const auto traced = trace(*scene, c, Vec3d(c.direction));
    ASSERT_TRUE(traced);
    const ChainEnd start{Vec3d(c.start)};
    const ChainEnd end{traced->last + traced->w * 2.0};
    SpecularChain forth(*scene);
    SpecularChain back(*scene);
    std::vector<InnerVertex> reversed(traced->vertices.rbegin(), traced->vertices.rend());
    ASSERT_TRUE(forth.set(start, traced->vertices, end));
    ASSERT_TRUE(back.set(end, reversed, start));
    EXPECT_NEAR(forth.spread() / back.spread(), 1.0, 1e-3);
  }
}

/// Directions in a cone around one, by a grid that closes in on each place where the miss is least.
std::vector<Vec3d> search(const Scene& scene, const Case& c, const Vec3d& target) {
  const Vec3d w = Vec3d(c.direction).normalized();
  const Turned sides = around(w);
  const auto missed = [&](double x, double y) {
    const auto traced = trace(scene, c, w + sides.x * x + sides.y * y);
    const auto by = traced ? miss(*traced, target) : std::nullopt;
    return by ? by->length() : 1e9;
  };
  constexpr int kSide = 60;
  constexpr double kCell = 0.01;
  constexpr int kSteps = 28;  // until a cell is 1e-8 wide
  std::vector<Vec3d> found;
  for (int j = -kSide; j <= kSide; ++j) {
    for (int i = -kSide; i <= kSide; ++i) {
      double x = i * kCell;
      double y = j * kCell;
      double least = missed(x, y);
      if (least > 0.2) continue;
      double cell = kCell;
      for (int step = 0; step < kSteps; ++step, cell *= 0.6) {
        const double middle_x = x;
        const double middle_y = y;
        for (int b = -2; b <= 2; ++b) {
          for (int a = -2; a <= 2; ++a) {
            const double here = missed(middle_x + 0.5 * a * cell, middle_y + 0.5 * b * cell);
            if (here >= least) continue;
            least = here;
            x = middle_x + 0.5 * a * cell;
            y = middle_y + 0.5 * b * cell;
          }
        }
      }
      if (least < 1e-4) found.push_back((w + sides.x * x + sides.y * y).normalized());
    }
  }
  return found;
}

/// A walk arrives at one of the chains that there are, and returns to its own.
TEST(ManifoldWalk, ReachesTheChainOfASearchAndReturns) {
  for (const Case& c : cases()) {
    if (!c.name.ends_with("Ball") && c.name != "Slab" && !c.name.ends_with("Waves")) continue;
    if (c.name == "MirrorBall" || c.name == "InsideOfBall") continue;
    SCOPED_TRACE(c.name);
    const auto scene = scene_of(c);
    const auto from = trace(*scene, c, Vec3d(c.direction));
    ASSERT_TRUE(from);
    // Before the focus of a ball: beyond there are several chains, and walks may converge to any.
    const Vec3d old_end = from->last + from->w * 0.3;
    ChainStart start;
    start.end = {Vec3d(c.start)};
    ManifoldWalk walk(*scene);
    int walked = 0;
    for (const Vec3d& by : {Vec3d(0.003, 0.0, 0.0), Vec3d(0.0, 0.03, 0.0), Vec3d(0.1, 0.05, 0.02),
                            Vec3d(-0.2, 0.1, -0.1)}) {
      const Vec3 target(old_end + by);
      if (!walk.walk(start, from->vertices, target, c.offsets)) continue;
      ++walked;
      const std::vector<InnerVertex> there(walk.vertices().begin(), walk.vertices().end());
      const Vec3d direction = (Vec3d(there.front().p()) - Vec3d(c.start)).normalized();
      double nearest = 1e9;
      for (const Vec3d& solution : search(*scene, c, Vec3d(target))) {
        nearest = std::min(nearest, (solution - direction).length());
      }
      EXPECT_LT(nearest, 2e-5 + walk.uncertainty()) << "by " << by;
      ASSERT_TRUE(walk.walk(start, there, Vec3(old_end), c.offsets));
      const auto near = static_cast<float>(2e-5 + walk.uncertainty());
      for (std::size_t i = 0; i < there.size(); ++i) {
        EXPECT_LT((walk.vertices()[i].p() - from->vertices[i].p()).length(), near);
      }
    }
    EXPECT_GE(walked, 3);
  }
}

TEST(ManifoldWalk, GivesUpWithoutASolution) {
  const Case c = cases().front();
  const auto scene = scene_of(c);
  const auto from = trace(*scene, c, Vec3d(c.direction));
  ASSERT_TRUE(from);
  ChainStart start;
  start.end = {Vec3d(c.start)};
  ManifoldWalk walk(*scene);
  EXPECT_FALSE(walk.walk(start, from->vertices, Vec3(0.3F, -0.2F, 9.F))) << "behind the start";
}

}  // namespace
}  // namespace ajar
