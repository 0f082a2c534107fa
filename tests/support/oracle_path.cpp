#include "support/oracle_path.h"

namespace ajar::test {

namespace {

/// Density in the vertex measure at `to` of a ray that leaves an endpoint.
double arrival(const Endpoint& endpoint, const EndpointPoint& point, Pdf<Departure> departure,
               const OraclePath::Node& to) {
  if (endpoint.at_infinity()) {
    return departure.value() * (to.medium ? 1.F : abs_dot(to.ng, point.toward));
  }
  const Vec3 d = to.p - point.surface.p;
  const double squared = length_squared(d);
  const double cosine = to.medium ? 1.0 : abs_dot(to.ng, d) / std::sqrt(squared);
  return departure.value() * cosine / squared;
}

double to_vertex(double direction_pdf, const Vec3& from, const OraclePath::Node& to) {
  const Vec3 d = to.p - from;
  const double squared = length_squared(d);
  return direction_pdf * (to.medium ? 1.0 : abs_dot(to.ng, d) / std::sqrt(squared)) / squared;
}

Vec3 away(const Endpoint& endpoint, const EndpointPoint& point, const Vec3& to) {
  return endpoint.at_infinity() ? -point.toward : normalize(to - point.surface.p);
}

double light_side(const Scene& scene, const OraclePath& path, int s) {
  const Light& light = *path.light;
  const auto& nodes = path.nodes;
  if (s == 0) return 1.0;
  if (s == 1) {
    // Only ever asked with at least one inner vertex.
    return static_cast<double>(light.connection_pdf(nodes[0].p, path.light_point).value()) *
           scene.light_sampler().probability(nodes[0].p, light).value();
  }
  const Vec3 w = away(light, path.light_point, nodes[0].p);
  const EmissionPdf emission = light.emission_pdf(path.light_point, w);
  double pdf = static_cast<double>(emission.position.value()) *
               scene.light_sampler().emitter_probability(light).value();
  pdf *= arrival(light, path.light_point, emission.departure, nodes[0]) *
         path.segments[0].distance_pdf(nodes[0].medium);
  for (int i = 1; i + 1 < s; ++i) {  // node index i-1 scatters to node index i
    const auto a = static_cast<std::size_t>(i - 1);
    pdf *= to_vertex(nodes[a].toward_camera, nodes[a].p, nodes[a + 1]) *
           path.segments[a + 1].distance_pdf(nodes[a + 1].medium);
  }
  return pdf;
}

double camera_side(const Scene& scene, const OraclePath& path, int t) {
  const Camera& camera = scene.camera();
  const auto& nodes = path.nodes;
  const auto last = nodes.size() - 1;
  const Vec3 w = away(camera, path.camera_point, nodes[last].p);
  const EmissionPdf emission = camera.emission_pdf(path.camera_point, w);
  double pdf = emission.position.value();
  if (t == 1) return pdf;
  pdf *= arrival(camera, path.camera_point, emission.departure, nodes[last]) *
         path.segments[last + 1].distance_pdf(nodes[last].medium);
  for (int i = 1; i + 1 < t; ++i) {
    const std::size_t a = last - static_cast<std::size_t>(i - 1);
    if (a == 0) {  // runs into the light
      const Segment& segment = path.segments[0];
      if (path.light->at_infinity()) {
        pdf *= nodes[0].toward_light * segment.distance_pdf(nullptr);
      } else {
        OraclePath::Node end;
        end.p = path.light_point.surface.p;
        end.ng = path.light_point.surface.ng;
        pdf *= to_vertex(nodes[0].toward_light, nodes[0].p, end) * segment.distance_pdf(nullptr);
      }
    } else {
      pdf *= to_vertex(nodes[a].toward_light, nodes[a].p, nodes[a - 1]) *
             path.segments[a].distance_pdf(nodes[a - 1].medium);
    }
  }
  return pdf;
}

}  // namespace

double technique_pdf(const Scene& scene, const OraclePath& path, Technique technique) {
  const auto [s, t] = technique;
  const auto inner = static_cast<int>(path.nodes.size());
  if (s == 0 && path.light->discrete_position()) return 0.0;
  // Nodes that the connection touches must scatter into more than single directions: x_{s-1} and
  // x_s.
  for (const int x : {s - 1, s}) {
    if (s > 0 && x >= 1 && x <= inner && path.nodes[static_cast<std::size_t>(x - 1)].specular) {
      return 0.0;
    }
  }
  return light_side(scene, path, s) * camera_side(scene, path, t);
}

double mis_weight(const Scene& scene, const PathSamplerSettings& settings, const OraclePath& path,
                  Technique technique) {
  const Vec2 size(scene.camera().resolution());
  const bool inside = path.raster.x >= 0.F && path.raster.y >= 0.F && path.raster.x < size.x &&
                      path.raster.y < size.y;
  const auto share = [&](Technique other) {
    if (!settings.techniques.enabled(other) || (other.t == 1 && !inside)) return 0.0;
    const double subpaths = other.t == 1   ? settings.light_paths_per_pixel
                            : other.s >= 2 ? settings.light_subpaths
                                           : 1.0;
    const double count = settings.techniques.count(other) * subpaths;
    return h(settings.heuristic, count * technique_pdf(scene, path, other));
  };
  double sum = 0.0;
  for (int s = 0; s <= path.depth(); ++s) sum += share({s, path.depth() + 1 - s});
  return share(technique) / sum;
}

}  // namespace ajar::test
