#include "path/visibility.h"

namespace ajar {

namespace {
/// From `origin` to an endpoint in direction `w`.
Ray ray_to_endpoint(const Vec3& origin, const Endpoint& endpoint, const EndpointPoint& point,
                    const Vec3& w) {
  if (endpoint.at_infinity()) return {origin, w};
  const SurfacePoint& end = point.surface;
  return ray_between(origin, offset_ray_end(end.p, end.ng, -w, length(end.p - origin)));
}
}  // namespace

std::optional<Segment> look_along(const Scene& scene, const Path& path, int edge, RayCounts& rays) {
  const Camera& camera = scene.camera();
  const int k = path.depth();
  const bool passes_lights = is_seen_past_lights(scene, path, edge);
  // From the end that is inside the scene.
  if (edge == 0) {
    const Vec3 w = path.toward_light(scene, 1);
    const Vec3 origin = k == 1 ? path.camera_point.surface.p : path.vertex(1).ray_origin(w);
    Ray ray = ray_to_endpoint(origin, *path.light, path.light_point, w);
    ray.passes_lights = passes_lights;
    return connect(scene, ray, k == 1 ? camera.medium : path.vertex(1).medium_toward(w), rays,
                   Heading::AwayFromCamera);
  }
  const InnerVertex& from = path.vertex(edge);
  const Vec3 w = path.toward_camera(scene, edge);
  const Vec3 origin = from.ray_origin(w);
  const auto ray_to_vertex = [&](const InnerVertex& to) {
    return ray_between(origin, to.ray_end(-w, length(to.p() - from.p())));
  };
  Ray ray = edge < k - 1 ? ray_to_vertex(path.vertex(edge + 1))
                         : ray_to_endpoint(origin, camera, path.camera_point, w);
  // Orthographic views begin at the film plane.
  if (edge == k - 1 && camera.at_infinity()) {
    ray.t_max = length(path.camera_point.surface.p - from.p());
  }
  ray.passes_lights = passes_lights;
  return connect(scene, ray, from.medium_toward(w), rays);
}

bool look_along_all(const Scene& scene, Path& path, RayCounts& rays) {
  path.segments.assign(static_cast<std::size_t>(path.depth()), {});
  for (int edge = path.depth() - 1; edge >= 0; --edge) {
    const std::optional<Segment> segment = look_along(scene, path, edge, rays);
    if (!segment) return false;
    path.segments[static_cast<std::size_t>(edge)] = *segment;
  }
  return true;
}

}  // namespace ajar
