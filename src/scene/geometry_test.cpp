#include "scene/geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "core/random.h"
#include "core/warp.h"
#include "scene/desc/models.h"
#include "scene/shape/quadric.h"
#include "scene/testing/quadrics.h"
#include "scene/testing/small_world.h"

namespace ajar {
namespace {

using testing::cube;
using testing::kInfinity;
using testing::mesh_shape;
using testing::rotation;
using testing::scaling;
using testing::shape;
using testing::square;
using testing::translation;
using testing::World;
using testing::world_of;

TEST(Geometry, EmptySceneIsHitNowhere) {
  const World world = world_of({});
  EXPECT_FALSE(world.hit({0, 0, 0}, {0, 0, 1}));
  EXPECT_FALSE(world.occluded({0, 0, 0}, {0, 0, 1}));
  EXPECT_TRUE(world.geometry->bounds().isEmpty());
}

TEST(Geometry, ReportsDistanceShapeAndPoint) {
  const World world =
      world_of({shape(testing::sphere_node(), translation(0, 0, 5)), mesh_shape(cube())});
  const auto box = world.hit({0.25F, 0.5F, -4}, {0, 0, 1});
  ASSERT_TRUE(box);
  EXPECT_EQ(box->shape, 1U);
  EXPECT_TRUE(world.geometry->has_place_of(*box));
  GeometryHit beyond = *box;
  beyond.point.primitive = 12;
  EXPECT_FALSE(world.geometry->has_place_of(beyond)) << "a cube has triangles 0 to 11";
  beyond = *box;
  beyond.shape = 2;
  EXPECT_FALSE(world.geometry->has_place_of(beyond));
  EXPECT_EQ(box->instance_id, 0U);
  EXPECT_NEAR(box->t, 3.F, 1e-6F);
  EXPECT_LT(length(box->point.p - Vec3(0.25F, 0.5F, -1)), 1e-6F);
  EXPECT_LT(length(box->point.ng - Vec3(0, 0, -1)), 1e-6F);
  const auto ball = world.hit({0, 0, 9}, {0, 0, -1});
  ASSERT_TRUE(ball);
  EXPECT_EQ(ball->shape, 0U);
  EXPECT_NEAR(ball->t, 3.F, 1e-6F);
  EXPECT_LT(length(ball->point.ng - Vec3(0, 0, 1)), 1e-6F);
  EXPECT_LE((world.geometry->bounds().min - Vec3(-1, -1, -1)).length(), 1e-5F);
  EXPECT_LE((world.geometry->bounds().max - Vec3(1, 1, 6)).length(), 1e-4F);
}

void expect_box(const Box3& box, const Vec3& low, const Vec3& high) {
  EXPECT_LT(length(box.min - low), 1e-4F) << box.min;
  EXPECT_LT(length(box.max - high), 1e-4F) << box.max;
}

TEST(Geometry, HasTheBoundsOfItsReceivers) {
  EXPECT_TRUE(world_of({}).geometry->receivers().isEmpty());
  desc::Shape sun = shape(testing::sphere_node(), translation(0, 0, 90));
  sun.emission = desc::Emission{{}, desc::emission_node("area")};
  EXPECT_TRUE(world_of({sun}).geometry->receivers().isEmpty());
  expect_box(world_of({sun, mesh_shape(cube())}).geometry->receivers(), Vec3(-1.F), Vec3(1.F));
  expect_box(
      world_of({shape(testing::sphere_node(), translation(5, 0, 0)), sun}).geometry->receivers(),
      {4, -1, -1}, {6, 1, 1});

  // Instances do not emit, even with emissive shapes.
  desc::SceneDesc scene;
  scene.shapes = {sun, mesh_shape(cube())};
  desc::Object object;
  object.shapes = {mesh_shape(cube())};
  object.shapes.front().emission = sun.emission;
  scene.objects.push_back(object);
  scene.instances.push_back({.object = 0, .to_world = translation(0, 7, 0), .where = {}});
  expect_box(World(std::move(scene)).geometry->receivers(), Vec3(-1.F), {1, 8, 1});
}

TEST(Geometry, OcclusionRespectsTheEndOfTheRay) {
  const World world = world_of({shape(testing::disk_node(0, 1, 0, 360))});
  EXPECT_TRUE(world.occluded({0, 0, -1}, {0, 0, 1}));
  EXPECT_FALSE(world.occluded({0, 0, -1}, {0, 0, 1}, 0.999F));
  EXPECT_FALSE(world.occluded({0, 0, -1}, {0, 0, 1}, -1.F));
  EXPECT_FALSE(world.occluded({0, 0, -1}, {0, 0, 1}, 0.F));
}

/// Random rays between points well away; the nearest of all roots in object space is the oracle.
TEST(Geometry, QuadricsAgreeWithTheirRootsUnderAnyTransform) {
  const Mat4 m = scaling(1.5, 0.5, -2) * rotation({1, 2, 3}, 0.7) * translation(3, 1, -2);
  const desc::Node sphere = testing::sphere_node(1, -0.5F, 1, 300);
  const Quadric quadric = *testing::quadric_of(sphere);
  const Placement placement = *Placement::make(m);
  const World world = world_of({shape(sphere, m)});
  Rng rng(1);
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 o = warp::uniform_sphere({rng.next(), rng.next()}) * 6.F + Vec3(3, 1, -2);
    const Vec3 d =
        normalize(warp::uniform_sphere({rng.next(), rng.next()}) * 1.5F + Vec3(3, 1, -2) - o);
    const Quadric::Roots roots = quadric.intersect(placement.point_to_object(Vec3d(o)),
                                                   placement.vector_to_object(Vec3d(d)));
    const auto found = world.hit(o, d);
    const double* end = roots.t + roots.count;
    const double* first = std::find_if(roots.t, end, [](double t) { return t > 0.0; });
    ASSERT_EQ(found.has_value(), first != end);
    EXPECT_EQ(world.occluded(o, d), found.has_value());
    if (!found) continue;
    ++hits;
    EXPECT_NEAR(found->t, *first, 1e-5);
    EXPECT_LT((Vec3d(found->point.p) - (Vec3d(o) + Vec3d(d) * *first)).length(), 1e-5);
    EXPECT_NEAR(abs_dot(found->point.ng, normalize(cross(found->point.dpdu, found->point.dpdv))),
                1.F, 1e-4F);
  }
  EXPECT_GT(hits, 1000);
}

// ---------------------------------------------------------------- leaving surfaces

/// Directions on the side of `n`, by the same rounded product that decides about the offset;
/// grazing ones included.
Vec3 direction_on_side(Rng& rng, const Vec3& n, float grazing_share) {
  while (true) {
    Vec3 d = face_forward(warp::uniform_sphere({rng.next(), rng.next()}), n);
    if (rng.next() < grazing_share) d = normalize(d - n * (dot(d, n) * 0.9999F));
    if (dot(n, d) > 0.F) return d;
  }
}

/// From every point of a convex shape, rays that leave it never meet it again.
void expect_no_self_hits(const World& world, const Vec3& center, float radius, int count = 20000) {
  Rng rng(5);
  int tested = 0;
  for (int i = 0; i < count; ++i) {
    const Vec3 o = center + warp::uniform_sphere({rng.next(), rng.next()}) * (3.F * radius);
    const Vec3 target =
        center + warp::uniform_sphere({rng.next(), rng.next()}) * (radius * rng.next());
    const auto found = world.hit(o, target - o);
    if (!found) continue;
    ++tested;
    const Vec3 d = direction_on_side(rng, found->point.ng, 0.3F);
    const Vec3 start = offset_ray_origin(found->point.p, found->point.ng, d);
    ASSERT_FALSE(world.hit(start, d)) << "at " << found->point.p << " towards " << d;
    ASSERT_FALSE(world.occluded(start, d));
  }
  EXPECT_GT(tested, count / 10);
}

TEST(SelfIntersection, SpheresOfAllScales) {
  for (const double size : {1e-12, 1e-2, 1.0, 1e4}) {
    for (const double away : {0.0, 3.0, 1e3}) {
      const Mat4 m =
          scaling(size, size, size) * translation(away * size, -2 * away * size, 0.5 * away * size);
      expect_no_self_hits(world_of({shape(testing::sphere_node(), m)}),
                          Vec3(Placement::make(m)->point(Vec3d(0.0))), static_cast<float>(size));
    }
  }
}

TEST(SelfIntersection, StretchedSphere) {
  const Mat4 m = scaling(10, 0.1, 1) * rotation({1, 1, 0}, 1.0) * translation(100, 20, 3);
  expect_no_self_hits(world_of({shape(testing::sphere_node(), m)}), {100, 20, 3}, 1.F);
}

TEST(SelfIntersection, TiltedSquaresOfAllSizesAndPlaces) {
  for (const float size : {1e-8F, 0.1F, 10.F, 1e5F}) {
    for (const float from : {0.F, 1e-3F, 2.F, 1e5F}) {
      const float away = size < 1e-3F ? from * size : from;
      const Mat4 m = rotation({0.3, 1, 0.2}, 0.9) * translation(away, -0.3 * away, 0.7 * away);
      expect_no_self_hits(world_of({mesh_shape(square(size), m)}),
                          {away, -0.3F * away, 0.7F * away}, size);
    }
  }
}

TEST(SelfIntersection, HugeFloorNearTheOrigin) {
  const World world = world_of({mesh_shape(square(1e6F))});
  expect_no_self_hits(world, {0, 0, 0}, 10.F);
}

TEST(SelfIntersection, InstancesFarAway) {
  desc::SceneDesc scene;
  scene.objects.push_back({"box", {}, {}});
  scene.objects[0].shapes.push_back(mesh_shape(cube()));
  scene.objects.push_back({"ball", {}, {}});
  scene.objects[1].shapes.push_back(shape(testing::sphere_node()));
  scene.instances.push_back({0, rotation({1, 2, 3}, 0.7) * translation(2000, 0.5, -1000), {}});
  scene.instances.push_back({1, rotation({1, 2, 3}, 0.7) * translation(-2000, 0.5, -1000), {}});
  const World world(std::move(scene));
  expect_no_self_hits(world, {2000, 0.5F, -1000}, 1.F);
  expect_no_self_hits(world, {-2000, 0.5F, -1000}, 1.F);
}

/// Objects far from their own origin are rounded there, by more than in the place of their
/// instance.
TEST(SelfIntersection, InstancesFarFromTheirObjectOrigin) {
  const Mat4 far = rotation({3, 1, 2}, 0.4) * translation(5000, 4000, 3000);
  desc::Mesh triangle = square(1.F);
  triangle.indices.pop_back();
  for (const double size : {1e-6, 1.0, 1e6}) {
    for (const desc::Shape& shape :
         {mesh_shape(triangle, far), testing::shape(testing::sphere_node(), far)}) {
      desc::SceneDesc scene;
      scene.objects.push_back({"far", {}, {shape}});
      scene.instances.push_back(
          {0, translation(-5000, -4000, -3000) * scaling(size, size, size), {}});
      expect_no_self_hits(World(std::move(scene)), Vec3(0.F), static_cast<float>(size));
    }
  }
}

/// The ground of many scenes is a sphere as large as the earth.
TEST(SelfIntersection, WhereAHugeSphereTouchesTheOrigin) {
  const double radius = 6.4e6;
  const World world = world_of(
      {shape(testing::sphere_node(6.4e6F, -6.4e6F, 6.4e6F, 360), translation(0, -radius, 0))});
  Rng rng(6);
  for (int i = 0; i < 20000; ++i) {
    const float near = std::pow(10.F, -6.F * rng.next());
    const Vec3 at(near * (2.F * rng.next() - 1.F), 0.F, near * (2.F * rng.next() - 1.F));
    const auto found = world.hit(at + Vec3(0.3F, 1.F, 0.2F), Vec3(-0.3F, -1.F, -0.2F));
    ASSERT_TRUE(found);
    const Vec3 d = direction_on_side(rng, found->point.ng, 0.3F);
    ASSERT_FALSE(world.occluded(offset_ray_origin(found->point.p, found->point.ng, d), d)) << i;
  }
}

/// Two points of one convex shape's outside, or of a plane and anywhere above it, see each other.
TEST(SelfIntersection, RaysEndBeforeTheSurfaceTheyAimAt) {
  for (const float size : {1e-8F, 1.F, 1e4F}) {
    for (const float away : {0.F, 1.F, 300.F}) {
      const Vec3 center = Vec3(away, -0.3F * away, 0.7F * away) * size;
      const Mat4 turned = rotation({0.3, 1, 0.2}, 0.9) * translation(center);
      const World world = world_of({mesh_shape(square(size), turned)});
      Rng rng(7);
      int tested = 0;
      for (int i = 0; i < 20000; ++i) {
        const Vec3 start = center + warp::uniform_sphere({rng.next(), rng.next()}) *
                                        (size * std::pow(10.F, 4.F * rng.next()));
        const Vec3 aim = center + warp::uniform_sphere({rng.next(), rng.next()}) * (0.5F * size);
        const auto found = world.hit(start, aim - start);
        if (!found) continue;
        ++tested;
        // Back to where it came from, or along the surface to as far away.
        Vec3 w = normalize(start - found->point.p);
        if (rng.next() < 0.5F) {
          const Vec3 n = face_forward(found->point.ng, w);
          w = normalize(w - n * (0.999F * dot(w, n)));
        }
        const float distance = length(start - found->point.p);
        const Vec3 from = found->point.p + w * distance;
        const Ray ray =
            ray_between(from, offset_ray_end(found->point.p, found->point.ng, w, distance));
        ASSERT_FALSE(world.geometry->occluded(ray)) << size << " " << away << " " << i;
      }
      EXPECT_GT(tested, 500);
    }
  }
}

/// Light bouncing inside a closed box never gets out. (Rays nearly parallel to an edge and within
/// 10⁻⁶ of it can slip between Embree's roundings of its two faces; no offset prevents that, so
/// they are not provoked here.)
void expect_no_leaks(const Mat4& m) {
  const World world = world_of({mesh_shape(cube(), m)});
  const Placement placement = *Placement::make(m);
  Rng rng(8);
  Vec3 o(placement.point(Vec3d(0.1, 0.2, 0.3)));
  Vec3 d = normalize(Vec3(1, 2, 3));
  for (int i = 0; i < 100000; ++i) {
    const auto found = world.hit(o, d);
    ASSERT_TRUE(found) << "bounce " << i << " from " << o << " towards " << d;
    d = direction_on_side(rng, -found->point.ng, 0.F);
    o = offset_ray_origin(found->point.p, found->point.ng, d);
  }
}

TEST(ClosedBox, NeverLeaks) { expect_no_leaks(Mat4()); }
TEST(ClosedBox, NeverLeaksWhenTurnedAndFar) {
  expect_no_leaks(scaling(7, 3, 5) * rotation({1, 2, 3}, 0.7) * translation(300, -20, 100));
}
TEST(ClosedBox, NeverLeaksWhenTiny) {
  expect_no_leaks(scaling(1e-8, 2e-8, 1e-8) * rotation({3, 2, 1}, 0.4));
}
TEST(ClosedBox, NeverLeaksWhenHuge) {
  expect_no_leaks(scaling(1e5, 2e5, 1e5) * rotation({3, 2, 1}, 0.4));
}

// ---------------------------------------------------------------- instances

TEST(Instances, PlacePointsAndNormalsAsBakedShapesDo) {
  const Mat4 placed = scaling(-1.5, 0.7, 2) * rotation({1, 0.2, 0.4}, 1.1) * translation(4, -3, 2);
  desc::Mesh mesh = cube();
  for (const Vec3& p : mesh.positions) {
    mesh.normals.push_back(normalize(p));
    mesh.uvs.emplace_back(p.x + 0.3F * p.z, p.y + 0.5F * p.z);
  }
  desc::SceneDesc instanced;
  instanced.objects.push_back({"thing", {}, {}});
  instanced.objects[0].shapes.push_back(
      shape(testing::sphere_node(0.5F, -0.5F, 0.5F, 360), translation(0, 0, 4)));
  instanced.objects[0].shapes.push_back(mesh_shape(mesh));
  instanced.shapes.push_back(shape(testing::sphere_node(), translation(100, 0, 0)));
  instanced.instances.push_back({0, Mat4() * translation(0, 50, 0), {}});
  instanced.instances.push_back({0, placed, {}});
  const World world(std::move(instanced));
  const World baked =
      world_of({shape(testing::sphere_node(0.5F, -0.5F, 0.5F, 360), translation(0, 0, 4) * placed),
                mesh_shape(mesh, placed)});
  EXPECT_EQ(world.geometry->counts().triangles, 12U);
  EXPECT_EQ(world.geometry->counts().instanced_triangles, 24U);
  EXPECT_EQ(world.geometry->counts().instances, 2U);
  EXPECT_EQ(world.geometry->counts().quadrics, 2U);
  EXPECT_EQ(world.geometry->object_base(0), 1U);
  Rng rng(4);
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 o = warp::uniform_sphere({rng.next(), rng.next()}) * 15.F + Vec3(4, -3, 2);
    const Vec3 d = warp::uniform_sphere({rng.next(), rng.next()}) * 3.F + Vec3(4, -3, 2) - o;
    const auto a = world.hit(o, d);
    const auto b = baked.hit(o, d);
    if (!a || !b) continue;
    ++hits;
    ASSERT_EQ(a->instance_id, 2U);
    EXPECT_TRUE(world.geometry->has_place_of(*a));
    for (const std::uint32_t instance : {0U, 1U, 3U, ~0U}) {
      GeometryHit elsewhere = *a;
      elsewhere.instance_id = instance;
      EXPECT_EQ(world.geometry->has_place_of(elsewhere), instance == 1U) << instance;
    }
    ASSERT_EQ(a->shape - 1, b->shape);
    ASSERT_LT(length(a->point.p - b->point.p), 1e-4F);
    ASSERT_GT(dot(a->point.ng, b->point.ng), 0.9999F);
    ASSERT_GT(dot(a->point.ns, b->point.ns), 0.9999F);
    ASSERT_LT(length(a->point.dpdu - b->point.dpdu), 1e-3F * length(b->point.dpdu));
    ASSERT_LT(length(a->point.dndu - b->point.dndu), 1e-2F * length(b->point.dndu) + 1e-3F);
    ASSERT_LT((a->point.uv - b->point.uv).length(), 1e-4F);
  }
  EXPECT_GT(hits, 500);
}

TEST(Instances, ObjectsThatNothingPlacesAreNotBuilt) {
  desc::SceneDesc scene;
  scene.objects.push_back({"unused", {}, {}});
  scene.objects[0].shapes.push_back(mesh_shape(cube()));
  const World world(std::move(scene));
  EXPECT_FALSE(world.geometry->has_shape(0));
  EXPECT_EQ(world.geometry->counts().triangles, 0U);
}

// ---------------------------------------------------------------- alpha

class AlphaTest : public ::testing::Test {
 protected:
  /// A texture that is 0 for u < ½ and 1 beyond.
  static desc::TextureId add_half(desc::SceneDesc& scene) {
    scene.textures.emplace_back().node =
        desc::texture_node("checkerboard", {{"scale_u", 2.F}, {"scale_v", 0.F}, {"offset_u", 1.F}});
    return static_cast<desc::TextureId>(scene.textures.size()) - 1;
  }
};

TEST_F(AlphaTest, CutsTrianglesForAllRays) {
  desc::SceneDesc scene;
  scene.shapes.push_back(mesh_shape(square(1)));
  scene.shapes.back().alpha = add_half(scene);
  const World world(std::move(scene));
  EXPECT_FALSE(world.hit({-0.5F, 0.1F, 2}, {0, 0, -1}));
  EXPECT_FALSE(world.occluded({-0.5F, 0.1F, 2}, {0, 0, -1}));
  EXPECT_TRUE(world.hit({0.5F, 0.1F, 2}, {0, 0, -1}));
  EXPECT_TRUE(world.occluded({0.5F, 0.1F, 2}, {0, 0, -1}));
}

TEST_F(AlphaTest, ShadowAlphaOnlyLetsShadowRaysPass) {
  desc::SceneDesc scene;
  scene.shapes.push_back(mesh_shape(square(1)));
  scene.shapes.back().shadow_alpha = add_half(scene);
  const World world(std::move(scene));
  EXPECT_TRUE(world.hit({-0.5F, 0.1F, 2}, {0, 0, -1}));
  EXPECT_FALSE(world.occluded({-0.5F, 0.1F, 2}, {0, 0, -1}));
  EXPECT_TRUE(world.occluded({0.5F, 0.1F, 2}, {0, 0, -1}));
}

TEST_F(AlphaTest, RaysGoOnToTheFarSideOfQuadrics) {
  desc::SceneDesc scene;
  scene.shapes.push_back(shape(testing::sphere_node()));
  // u < ½ is y > 0: the half that a ray coming from +y meets first.
  scene.shapes.back().alpha = add_half(scene);
  const World world(std::move(scene));
  const auto found = world.hit({0.2F, 3, 0.1F}, {0, -1, 0});
  ASSERT_TRUE(found);
  EXPECT_LT(found->point.p.y, 0.F);
  EXPECT_TRUE(world.occluded({0.2F, 3, 0.1F}, {0, -1, 0}));
  EXPECT_FALSE(world.occluded({0.2F, 3, 0.1F}, {0, -1, 0}, 3.F));
}

TEST_F(AlphaTest, SolidTexturesSeeInstancesInTheWorld) {
  desc::SceneDesc scene;
  const Mat4 tenth = scaling(0.1, 0.1, 0.1);
  scene.textures.emplace_back().node = desc::texture_node(
      "solid_checkerboard", {{"world_to_texture", std::make_shared<const Mat4>(tenth)}});
  scene.objects.push_back({"square", {}, {}});
  scene.objects[0].shapes.push_back(mesh_shape(square(1)));
  scene.objects[0].shapes[0].alpha = 0;
  scene.instances.push_back({0, translation(5, 5, 5), {}});
  scene.instances.push_back({0, translation(15, 5, 5), {}});
  const World world(std::move(scene));
  EXPECT_TRUE(world.hit({5, 5, 9}, {0, 0, -1}));
  EXPECT_FALSE(world.hit({15, 5, 9}, {0, 0, -1}));
}

TEST_F(AlphaTest, ShapeThatIsCutAwayEverywhereIsDropped) {
  desc::SceneDesc scene;
  scene.textures.emplace_back().node = desc::texture_node("constant", {{"value", Vec3(0.F)}});
  scene.shapes.push_back(mesh_shape(square(1)));
  scene.shapes.back().alpha = 0;
  const World world(std::move(scene));
  EXPECT_FALSE(world.geometry->has_shape(0));
  EXPECT_EQ(world.warnings.count(), 1U);
}

// ---------------------------------------------------------------- curves

desc::Shape curve_shape(const std::string& type) {
  auto curve = std::make_shared<desc::Curves>();
  curve->control_points = {{-1, 0, 0}, {-0.3F, 0, 0}, {0.3F, 0, 0}, {1, 0, 0}};
  curve->widths = {0.2F, 0.2F, 0.2F, 0.2F};
  if (type == "ribbon") curve->normals.assign(4, {0, 0.6F, 0.8F});
  return shape(desc::shape_node("curves", {{"type", type}, {"curves", curve}}));
}

TEST(Curves, AreHitAtTheirWidthWithNormalsAndCoordinates) {
  for (const std::string type : {"flat", "cylinder", "ribbon"}) {
    const World world = world_of({curve_shape(type)});
    const auto middle = world.hit({0, 0.05F, 3}, {0, 0, -1});
    ASSERT_TRUE(middle) << type;
    EXPECT_FALSE(world.hit({0, 0.12F, 3}, {0, 0, -1}));
    EXPECT_NEAR(middle->point.uv.x, 0.5F, 1e-2F);
    EXPECT_NEAR(std::abs(middle->point.uv.y - 0.5F), type == "ribbon" ? 0.3125F : 0.25F, 0.02F);
    EXPECT_NEAR(length(middle->point.ng), 1.F, 1e-5F);
    EXPECT_NEAR(dot(middle->point.ng, Vec3(1, 0, 0)), 0.F, 1e-2F);
    EXPECT_GT(middle->point.ng.z, 0.5F);
    EXPECT_GT(length(middle->point.dpdu), 0.5F);
    EXPECT_NEAR(length(middle->point.dpdv), 0.2F, 1e-3F);
    // Rays that leave to the viewer's side are free.
    const Vec3 start = offset_ray_origin(middle->point.p, middle->point.ng, {0, 0, 1});
    EXPECT_FALSE(world.hit(start, {0.1F, 0.2F, 1}));
  }
}

TEST(Curves, CannotEmit) {
  const World world = world_of({curve_shape("flat")});
  EXPECT_TRUE(world.geometry->has_shape(0));
  EXPECT_EQ(world.geometry->make_sampler(0), nullptr);
  EXPECT_EQ(world.geometry->counts().curves, 1U);
}

TEST(Curves, CountsThatDoNotFitAreAnError) {
  auto curve = std::make_shared<desc::Curves>();
  curve->control_points.assign(5, {0, 0, 0});
  curve->widths.assign(5, 1.F);
  EXPECT_THROW(world_of({shape(desc::shape_node("curves", {{"curves", curve}}))}), SceneError);
}

// ---------------------------------------------------------------- faulty input

TEST(FaultyShapes, SingularTransformsAreDroppedWithAWarning) {
  const World world =
      world_of({mesh_shape(cube(), scaling(1, 0, 1)), shape(testing::sphere_node(0, 0, 0, 360))});
  EXPECT_FALSE(world.geometry->has_shape(0));
  EXPECT_FALSE(world.geometry->has_shape(1));
  EXPECT_EQ(world.warnings.count(), 2U);
  EXPECT_FALSE(world.hit({0, 0, 5}, {0, 0, -1}));
}

TEST(FaultyShapes, AreReportedInTheOrderOfTheFile) {
  std::vector<desc::Shape> shapes;
  const auto file = std::make_shared<const std::string>("a.pbrt");
  for (int i = 0; i < 400; ++i) {
    // Some take longer than others.
    shapes.push_back(i % 10 == 0 ? mesh_shape(cube(), scaling(1, 0, 1))
                                 : shape(testing::sphere_node(0, 0, 0, 360)));
    shapes.back().where = {file, i + 1, 1};
  }
  const World world = world_of(std::move(shapes));
  const std::vector<Warning> warnings = world.warnings.kept();
  ASSERT_EQ(warnings.size(), Warnings::kMaxKept);
  for (int i = 0; i < 200; ++i) EXPECT_EQ(warnings[static_cast<std::size_t>(i)].where.line, i + 1);
}

TEST(FaultyShapes, TrianglesWithoutAreaAreHarmless) {
  desc::Mesh mesh = square(1);
  mesh.indices.emplace_back(0, 0, 0);
  mesh.indices.emplace_back(0, 1, 1);
  mesh.positions.push_back({0, 0, 0});
  const World world = world_of({mesh_shape(mesh)});
  Rng rng(2);
  for (int i = 0; i < 2000; ++i) {
    const auto found = world.hit({2.F * rng.next() - 1.F, 2.F * rng.next() - 1.F, 1}, {0, 0, -1});
    ASSERT_TRUE(!found || (is_finite(found->point.ng) && is_finite(found->point.p)));
  }
  ASSERT_TRUE(world.hit({0.5F, -0.5F, 1}, {0, 0, -1}));
}

TEST(FaultyShapes, InstanceOfNothingIsAnError) {
  desc::SceneDesc scene;
  scene.instances.push_back({3, Mat4(), {}});
  EXPECT_THROW(World{std::move(scene)}, SceneError);
}

}  // namespace
}  // namespace ajar
