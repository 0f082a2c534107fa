#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "core/distribution.h"
#include "scene/bsdf/bsdf_catalogue.h"
#include "scene/camera/camera.h"
#include "scene/light/lamps_test_support.h"
#include "scene/light/light_sampler.h"
#include "scene/light/models.h"
#include "scene/medium/phase.h"
#include "scene/shape/make_surface_sampler.h"
#include "scene/testing/image_file.h"
#include "scene/testing/inverse_checks.h"
#include "scene/testing/quadrics.h"
#include "scene/testing/transforms.h"

/// Every sampling routine below transport, against its inverse.
namespace ajar {
namespace {

using namespace testing;

double distance_of(const Vec3& a, const Vec3& b) { return double{length(a - b)}; }

void add_warps(std::vector<InverseCase>& all) {
  const auto add = [&](const std::string& name, const auto& sample, const auto& invert) {
    all.push_back({name, 2, 1e-5, [=](const InverseNumbers& u, const InverseNumbers&) {
                     const auto x = sample(Vec2(u[0], u[1]));
                     const Vec2 v = invert(x);
                     return std::optional(RoundTrip{
                         true, {v.x, v.y}, static_cast<double>((sample(v) - x).length())});
                   }});
  };
  add("disk", warp::uniform_disk, warp::uniform_disk_inverse);
  add("sphere", warp::uniform_sphere, warp::uniform_sphere_inverse);
  add("triangle", warp::uniform_triangle, warp::uniform_triangle_inverse);
  for (const float g : {-0.7F, 0.F, 0.4F, 0.95F}) {
    const Vec3 wo = direction(70.F, 20.F);
    add(
        "phase function " + std::to_string(g),
        [=](const Vec2& u) { return phase::sample_henyey_greenstein(g, wo, u); },
        [=](const Vec3& w) { return phase::invert_henyey_greenstein(g, wo, w); });
    // Strong scattering: single precision in the cosine next to one is 3e-4 in the angle.
    all.back().tolerance = 2e-3;
  }
}

void add_distributions(std::vector<InverseCase>& all) {
  Rng rng(3);
  std::vector<float> weights;
  for (int i = 0; i < 48; ++i) {
    weights.push_back(rng.next() < 0.3F ? 0.F : std::exp(4.F * rng.next()));
  }
  const Distribution1D line(weights);
  all.push_back({"1-D distribution", 1, 0.0, [=](const InverseNumbers& u, const InverseNumbers& v) {
                   // Samples keep the cell only, not the place in it.
                   const std::size_t cell = line.choose(u[0]).index;
                   const float number = line.invert(cell, v[0]);
                   return std::optional(
                       RoundTrip{true, {number}, line.choose(number).index == cell ? 0.0 : 1.0});
                 }});
  const Distribution2D grid(weights, 8, 6);
  all.push_back({"2-D distribution", 2, 1e-4, [=](const InverseNumbers& u, const InverseNumbers&) {
                   const Vec2 at = grid.sample({u[0], u[1]}).uv;
                   const Vec2 number = grid.invert(at);
                   const Vec2 again = grid.sample(number).uv;
                   return std::optional(RoundTrip{
                       true, {number.x, number.y}, static_cast<double>((again - at).length())});
                 }});
}

void add_bsdfs(std::vector<InverseCase>& all) {
  for (const float tilt : {0.F, 25.F}) {
    for (const NamedBsdf& named : catalogue(tilt)) {
      for (const Vec3& wo :
           {direction(20.F, 10.F), direction(75.F, 200.F), direction(125.F, 70.F)}) {
        const Bsdf bsdf = named.bsdf;
        const std::string name = named.name + ", tilt " + std::to_string(tilt) + ", wo " +
                                 std::to_string(wo.x) + " " + std::to_string(wo.z);
        all.push_back(
            {name, 3, 2e-3,
             [=](const InverseNumbers& u, const InverseNumbers& v) -> std::optional<RoundTrip> {
               const auto s = bsdf.sample(wo, {u[0], {u[1], u[2]}}, TransportMode::Radiance);
               if (!s) return std::nullopt;
               const auto n = bsdf.invert(wo, s->wi, s->event(), {v[0], {v[1], v[2]}});
               if (!n) return RoundTrip{};
               const auto again = bsdf.sample(wo, *n, TransportMode::Radiance);
               const bool same = again && again->event() == s->event();
               return RoundTrip{same,
                                {n->lobe, n->direction.x, n->direction.y},
                                same ? distance_of(again->wi, s->wi) : 0.0};
             },
             wo.z < 0.5F});
      }
    }
  }
}

/// Emission, and connections from a few places.
void add_endpoint(std::vector<InverseCase>& all, const std::string& name, const Endpoint& endpoint,
                  double tolerance = 2e-3) {
  const auto uniforms = [](const InverseNumbers& u) {
    return EmissionUniforms{u[0], {u[1], u[2]}, {u[3], u[4]}};
  };
  all.push_back({name + ", emission", 5, tolerance,
                 [&endpoint, uniforms](const InverseNumbers& u,
                                       const InverseNumbers& v) -> std::optional<RoundTrip> {
                   const auto s = endpoint.sample_emission(uniforms(u));
                   if (!s) return std::nullopt;
                   // Anywhere on the ray.
                   const Vec3 through = s->origin + s->w * (10.F * u[0]);
                   const auto n = endpoint.invert_emission(s->point, through, s->w, uniforms(v));
                   if (!n) return RoundTrip{};
                   const auto again = endpoint.sample_emission(*n);
                   const InverseNumbers numbers{n->primitive, n->position.x, n->position.y,
                                                n->direction.x, n->direction.y};
                   if (!again) return RoundTrip{false, numbers, 0.0};
                   return RoundTrip{
                       true, numbers,
                       distance_of(again->w, s->w) + distance_of(again->origin, s->origin)};
                 }});
  for (const Vec3& reference : {Vec3(0.3F, -0.2F, -1.F), Vec3(-0.7F, 0.4F, 0.5F)}) {
    if (!endpoint.sample_connection(reference, {0.5F, {0.5F, 0.5F}})) continue;
    all.push_back(
        {name + ", connection", 3, tolerance,
         [&endpoint, reference](const InverseNumbers& u,
                                const InverseNumbers& v) -> std::optional<RoundTrip> {
           const auto s = endpoint.sample_connection(reference, {u[0], {u[1], u[2]}});
           if (!s) return std::nullopt;
           const auto n = endpoint.invert_connection(reference, s->point, {v[0], {v[1], v[2]}});
           if (!n) return RoundTrip{};
           const auto again = endpoint.sample_connection(reference, *n);
           const InverseNumbers numbers{n->primitive, n->position.x, n->position.y};
           if (!again) return RoundTrip{false, numbers, 0.0};
           return RoundTrip{true, numbers,
                            distance_of(again->w, s->w) +
                                distance_of(again->point.surface.p, s->point.surface.p)};
         }});
  }
}

/// Away from all lights, for those that are aimed.
constexpr BoundingSphere kReceivers{Vec3(0.F, 0.F, -12.F), 4.F};

/// Lights of every model, and their supports.
struct AllLights {
  std::vector<std::unique_ptr<ImageFile>> images;
  std::vector<BuiltShape> shapes;
  std::vector<std::unique_ptr<SurfaceSampler>> surfaces;
  std::vector<std::pair<std::string, std::unique_ptr<Light>>> lights;
  /// Models that have a case here.
  std::set<const desc::Model*> models;

  AllLights() {
    const std::pair<std::string, Mat4> spaces[] = {
        {"rigid", aimed({0.3F, 0.2F, -4.F}, {0, 0, 0})},
        {"stretched", scaling(1, 1.4, -0.8) * aimed({0.3F, 0.2F, -4.F}, {0, 0, 0})}};
    for (const auto& [space, at] : spaces) add_unbounded(space, at);
    add_emitters();
  }

  void add_unbounded(const std::string& space, const Mat4& at) {
    const auto add = [&](const std::string& name, const desc::Node& node) {
      models.insert(&node.model());
      lights.emplace_back(name + " " + space, light_of(node, at));
    };
    const auto map = [&](int width, int height) {
      Rng rng(5);
      std::vector<float> texels;
      for (int i = 0; i < 3 * width * height; ++i) {
        texels.push_back(rng.next() < 0.3F ? 0.F : std::exp(4.F * rng.next()));
      }
      images.push_back(std::make_unique<ImageFile>(width, height, texels));
      return images.back()->path();
    };
    add("point", point_node({1, 2, 3}));
    lights.emplace_back(
        "aimed point " + space,
        make_point_light(Spectrum(1.F), {transform_point(at, Vec3(0.F)), DirectionMap()},
                         Aim(kReceivers)));
    add("spot", spot_node({1, 2, 3}, 40, 25));
    add("sharp spot", spot_node({1, 2, 3}, 40, 40));
    add("soft spot", spot_node({1, 2, 3}, 100, 0));
    add("distant", distant_node({1, 2, 3}));
    add("constant environment", environment_node({1, 2, 3}));
    add("environment map", environment_node({1, 1, 1}, map(8, 6)));
    add("sky", desc::light_node("sky", {{"elevation", 20.F}}));
    add("goniometric", goniometric_node({1, 1, 1}, map(6, 5)));
    add("projection", projection_node({1, 1, 1}, 60, map(7, 4)));
  }

  void add_emitters() {
    Mat4 turned = scaling(0.7, 0.7, 0.7) * rotation({1, 2, -0.5F}, 0.8);
    turned[3][2] = 2.0;
    const Mat4 stretched = scaling(1.5, 0.6, -0.8) * turned;
    const auto add = [&](const std::string& name, const desc::Node& node) {
      for (const Mat4& at : {turned, stretched}) {
        add_surface((at == turned ? "turned " : "stretched ") + name, node, at);
      }
    };
    add("sphere", sphere_node());
    add("partial sphere", sphere_node(1, -0.4F, 0.9F, 200));
    add("disk", disk_node(0.3F, 1.2F, 0.4F, 300));
    add("disk of radii and angles", disk_node_of("radius_then_angle"));
    add("disk of angles and radii", disk_node_of("angle_then_radius"));
    add("cylinder", cylinder_node(0.6F, -1, 1, 360));
    add("cone", cone_node(0.8F, 1.5F, 360));
    add("paraboloid", paraboloid_node(1, 0, 1.3F, 270));
    add("hyperboloid", hyperboloid_node({1, -1, -1}, {0.5F, 1.5F, 1}, 360));
    auto mesh = std::make_shared<desc::Mesh>();
    mesh->positions = {{-1, -1, 2}, {1, -1, 2.5F}, {1, 1, 2}, {-1, 1, 2}, {3, 1, 1.5F}};
    mesh->indices = {{0, 2, 1}, {0, 3, 2}, {2, 4, 1}};
    add_surface("mesh", desc::mesh_node(mesh), Mat4());
    add_surface("subdivision", desc::shape_node("subdivision", {{"levels", 2}, {"control", mesh}}),
                Mat4());
  }

  void add_surface(const std::string& name, const desc::Node& node, const Mat4& at) {
    models.insert(&node.model());
    const Placement placement = *Placement::make(at);
    desc::Shape shape;
    shape.node = node;
    Warnings warnings;
    shapes.push_back(build_shape(shape, placement, warnings));
    if (const auto* quadric = std::get_if<Quadric>(&shapes.back())) {
      surfaces.push_back(make_surface_sampler(*quadric, placement, false));
    } else {
      const auto& mesh = std::get<std::unique_ptr<const TriangleMesh>>(shapes.back());
      surfaces.push_back(make_surface_sampler(*mesh));
    }
    for (const bool two_sided : {false, true}) {
      const desc::Emission emission = area_light({1, 2, 3}, two_sided);
      models.insert(&emission.node.model());
      lights.emplace_back(name + (two_sided ? ", two sides" : ""),
                          make_surface_light(emission, *surfaces.back(), {}));
      if (name != "mesh" && name != "turned sphere") continue;
      lights.emplace_back(name + ", aimed" + (two_sided ? ", two sides" : ""),
                          make_surface_light(emission, *surfaces.back(), {}, kReceivers));
    }
  }
};

TEST(Inverses, HaveCasesForEveryLightEmissionAndShape) {
  const AllLights cases;
  for (const auto kind :
       {desc::ModelKind::Light, desc::ModelKind::Emission, desc::ModelKind::Shape}) {
    for (const desc::Model* model : desc::models(kind)) {
      if (model->name == "curves") continue;  // cannot emit, so nothing is sampled on them
      EXPECT_TRUE(cases.models.contains(model)) << model->name;
    }
  }
}

std::vector<std::pair<std::string, std::unique_ptr<Camera>>> all_cameras() {
  std::vector<std::pair<std::string, std::unique_ptr<Camera>>> cameras;
  const auto add = [&](const std::string& name, const auto& node, const Mat4& to_world) {
    desc::Camera camera;
    camera.to_world = to_world;
    camera.node = node;
    cameras.emplace_back(name, make_camera(camera, {64, 48}, Vec3(0.F), 10.F));
  };
  const Mat4 place = aimed({0.3F, 0.2F, -4.F}, {0, 0, 0});
  for (const auto& [space, at] : {std::pair<std::string, Mat4>{" rigid", place},
                                  {" stretched", scaling(-1, 1.4, 0.8) * place}}) {
    add("pinhole" + space, desc::PerspectiveCamera{50, 0, 1e6F, {}, {}}, at);
    add("thin lens" + space, desc::PerspectiveCamera{50, 0.3F, 3, {}, {}}, at);
    add("orthographic" + space, desc::OrthographicCamera{0, 1e6F, {}, {}}, at);
    add("telecentric" + space, desc::OrthographicCamera{1.2F, 3, {}, {}}, at);
    add("environment" + space, desc::EnvironmentCamera{}, at);
  }
  return cameras;
}

void add_choices(std::vector<InverseCase>& all, const std::string& name,
                 const LightSampler& sampler) {
  all.push_back(
      {name + ", emitters", 1, 0.0, [&sampler](const InverseNumbers& u, const InverseNumbers& v) {
         const Light* light = sampler.choose_emitter(u[0]).light;
         const auto n = sampler.invert_emitter(*light, v[0]);
         if (!n) return std::optional(RoundTrip{});
         return std::optional(
             RoundTrip{true, {*n}, sampler.choose_emitter(*n).light == light ? 0.0 : 1.0});
       }});
  for (const Vec3& reference : {Vec3(0.1F, 0.3F, -0.4F), Vec3(3.F, -2.F, 1.F)}) {
    all.push_back({name + ", seen", 1, 0.0,
                   [&sampler, reference](const InverseNumbers& u, const InverseNumbers& v) {
                     const Light* light = sampler.choose(reference, u[0]).light;
                     const auto n = sampler.invert(reference, *light, v[0]);
                     if (!n) return std::optional(RoundTrip{});
                     const bool same = sampler.choose(reference, *n).light == light;
                     return std::optional(RoundTrip{true, {*n}, same ? 0.0 : 1.0});
                   }});
  }
}

TEST(Inverses, GiveTheNumbersOfWhatWasSampled) {
  std::vector<InverseCase> all;
  add_warps(all);
  add_distributions(all);
  add_bsdfs(all);
  const AllLights lights;
  for (const auto& [name, light] : lights.lights) add_endpoint(all, name, *light);
  const auto cameras = all_cameras();
  for (const auto& [name, camera] : cameras) add_endpoint(all, name, *camera);

  Rng rng(4);
  Lamps lamps = random_lamps(rng, 60, 2.F);
  const LightSampler placed(lamps.lights, kBounds);
  Lamps more = random_lamps(rng, 30, 2.F);
  more.add(light_of(distant_node({1, 2, 3}), Mat4()));
  more.add(light_of(environment_node({1, 2, 3}), Mat4()));
  const LightSampler mixed(more.lights, kBounds);
  Lamps single;
  single.add(light_of(point_node({1, 2, 3}), Mat4()));
  const LightSampler one(single.lights, kBounds);
  add_choices(all, "60 lights", placed);
  add_choices(all, "lights near and at infinity", mixed);
  add_choices(all, "one light", one);

  for (const InverseCase& test : all) check_inverse(test);
}

}  // namespace
}  // namespace ajar
