#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/random.h"
#include "support/oracle_path.h"
#include "support/render.h"
#include "support/small_scenes.h"
#include "transport/sources.h"

namespace ajar {
namespace {

using test::OraclePath;

/// Rebuilds each sampled path from what the sampler reports, vertex by vertex, and compares its MIS
/// weight with the definition.
class CheckingSink final : public PathSink {
 public:
  CheckingSink(const Scene& scene, const PathSamplerSettings& settings)
      : scene_(scene), settings_(settings) {}

  void begin(const Vec2& raster) {
    raster_ = raster;
    camera_ = {};
    light_.clear();
  }

  void started(Stream stream, const Endpoint& endpoint, const EndpointPoint& point) override {
    if (stream == Stream::Light) light_.emplace_back();
    Subpath& subpath = current(stream);
    subpath.endpoint = &endpoint;
    subpath.point = point;
  }
  void vertex(Stream stream, const PathVertex& vertex) override {
    current(stream).vertices.push_back(vertex);
  }
  void scattered(Stream stream, const PathVertex&, const Flight& flight) override {
    current(stream).flights.push_back(flight);
  }

  void add(const Contribution& contribution) override {
    ASSERT_TRUE(contribution.value.is_finite());
    const auto [s, t] = contribution.technique;
    if (contribution.technique.depth() == 1) {
      EXPECT_EQ(contribution.mis_weight, 1.0);
      return;
    }
    const OraclePath path = rebuild(contribution, s, t);
    const double expected = test::mis_weight(scene_, settings_, path, contribution.technique);
    // Positions are floats: what is left are roundings of distances and cosines.
    EXPECT_NEAR(contribution.mis_weight, expected, 2e-3 + 2e-3 * expected)
        << "technique (" << s << ", " << t << ")";
    ++checked[{s, t}];
  }

  std::map<std::pair<int, int>, int> checked;

 private:
  struct Subpath {
    const Endpoint* endpoint = nullptr;
    EndpointPoint point = EndpointPoint::at(Vec3(0.F));
    std::vector<PathVertex> vertices;
    std::vector<Flight> flights;
  };
  Subpath& current(Stream stream) { return stream == Stream::Light ? light_.back() : camera_; }

  OraclePath rebuild(const Contribution& contribution, int s, int t) const {
    OraclePath path;
    static const Subpath kNone;
    const Subpath& camera = camera_;
    const Subpath& light =
        s >= 2 ? light_[static_cast<std::size_t>(contribution.light_subpath)] : kNone;
    path.light = s >= 2 ? static_cast<const Light*>(light.endpoint) : contribution.light;
    path.light_point = s >= 2 ? light.point : *contribution.light_point;
    path.camera_point = t >= 2 ? camera.point : *contribution.camera_point;
    path.raster = t >= 2 ? raster_ : contribution.raster;

    std::vector<const PathVertex*> vertices;
    std::vector<const Flight*> flights;  // null where the connection is
    const auto add_vertices = [&](const Subpath& subpath, int count) {
      for (int i = 0; i < count; ++i) {
        const auto index = static_cast<std::size_t>(i);
        vertices.push_back(&subpath.vertices[index]);
        flights.push_back(i + 1 < count ? &subpath.flights[index] : nullptr);
      }
    };
    add_vertices(light, std::max(0, s - 1));
    const std::size_t from_light = vertices.size();
    // Technique (0, t): the last camera vertex is on the light; the one before it scattered freely.
    const int camera_count = s == 0 ? t - 2 : t - 1;
    add_vertices(camera, std::max(0, camera_count));
    std::reverse(vertices.begin() + static_cast<std::ptrdiff_t>(from_light), vertices.end());
    std::reverse(flights.begin() + static_cast<std::ptrdiff_t>(from_light), flights.end());
    if (s == 0) flights[from_light] = &camera.flights[static_cast<std::size_t>(t - 3)];

    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const PathVertex& v = *vertices[i];
      const Vec3 to_light =
          i > 0 ? normalize(vertices[i - 1]->p - v.p) : toward(*path.light, path.light_point, v.p);
      const Vec3 to_camera = i + 1 < vertices.size()
                                 ? normalize(vertices[i + 1]->p - v.p)
                                 : toward(scene_.camera(), path.camera_point, v.p);
      OraclePath::Node node;
      node.p = v.p;
      node.ng = v.in_medium ? Vec3(0.F, 0.F, 0.F) : v.bsdf.ng();
      node.medium = v.in_medium ? v.medium : nullptr;
      const bool of_light = i < from_light;
      if (flights[i] != nullptr && flights[i]->specular) {
        node.specular = true;
        node.toward_camera = of_light ? flights[i]->departure : flights[i]->reverse_previous;
        node.toward_light = of_light ? flights[i]->reverse_previous : flights[i]->departure;
      } else {
        node.toward_camera = v.pdf(to_light, to_camera).value();
        node.toward_light = v.pdf(to_camera, to_light).value();
      }
      path.nodes.push_back(node);
    }
    RayCounts rays;
    for (std::size_t i = 0; i <= vertices.size(); ++i) {
      path.segments.push_back(segment(path, vertices, i, rays));
    }
    return path;
  }

  static Vec3 toward(const Endpoint& endpoint, const EndpointPoint& point, const Vec3& from) {
    return endpoint.at_infinity() ? point.toward : normalize(point.surface.p - from);
  }

  /// Segment i leaves node i - 1 (the light for i = 0); traced from the side that is inside the
  /// scene.
  Segment segment(const OraclePath& path, const std::vector<const PathVertex*>& vertices,
                  std::size_t i, RayCounts& rays) const {
    const bool at_light = i == 0;
    const PathVertex& from = *vertices[at_light ? 0 : i - 1];
    Ray ray;
    if (at_light && path.light->at_infinity()) {
      ray.direction = path.light_point.toward;
      ray.origin = from.ray_origin(ray.direction);
    } else if (i == vertices.size() && scene_.camera().at_infinity()) {
      ray.direction = path.camera_point.toward;
      ray.origin = from.ray_origin(ray.direction);
    } else {
      const EndpointPoint& endpoint = at_light ? path.light_point : path.camera_point;
      const bool to_endpoint = at_light || i == vertices.size();
      const Vec3 w = normalize((to_endpoint ? endpoint.surface.p : vertices[i]->p) - from.p);
      const Vec3 target = to_endpoint
                              ? offset_ray_origin(endpoint.surface.p, endpoint.surface.ng, -w)
                              : vertices[i]->ray_origin(-w);
      ray.origin = from.ray_origin(w);
      ray.t_max = length(target - ray.origin);
      ray.direction = (target - ray.origin) / ray.t_max;
      ray.t_max *= 0.999999F;
    }
    return connect(scene_, ray, from.medium_toward(ray.direction), rays).value();
  }

  const Scene& scene_;
  const PathSamplerSettings& settings_;
  Vec2 raster_{0.F, 0.F};
  Subpath camera_;
  std::vector<Subpath> light_;
};

class MisWeights : public ::testing::TestWithParam<test::SmallScene> {};

TEST_P(MisWeights, EqualTheSlowOracleOnRandomPaths) {
  const auto scene = test::scene_from(GetParam().text);
  for (const char* techniques :
       {"pt", "lt", "ibpt", "bdpt", "implicit,light", "implicit,explicit*3,light*0.5,inner*0.25",
        "(0,*),(1,3),(2,1)*0.5,(2,*),(3,2)*0.75,(*,1)"}) {
    const TechniqueSet set = TechniqueSet::parse(techniques);
    for (const Heuristic heuristic : {Heuristic::Balance, Heuristic::Power}) {
      PathSamplerSettings settings;
      settings.techniques = set;
      settings.heuristic = heuristic;
      settings.max_depth = 7;
      settings.light_subpaths = 1.5;
      settings.light_paths_per_pixel = 0.5;
      PathSampler sampler(*scene, settings);
      CheckingSink sink(*scene, settings);
      const Vec2 size(scene->camera().resolution());
      for (std::uint32_t i = 0; i < 600; ++i) {
        IndependentSource source({1, i, 2, i});
        const Vec2 raster = source.get_pair({Stream::Camera, 0, kEmissionDirection}) * size;
        sink.begin(raster);
        if (!set.any(TechniqueClass::Inner)) sampler.sample_light(source, sink);
        sampler.sample(source, raster, sink);
        if (HasFailure()) return;
      }
      EXPECT_FALSE(sink.checked.empty()) << "no path was checked";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, MisWeights, ::testing::ValuesIn(test::small_scenes()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace ajar
