#include "scene/camera/camera.h"

#include <algorithm>
#include <cmath>

#include "core/warp.h"
#include "scene/camera/models.h"
#include "scene/coordinate_limit.h"

namespace ajar {

namespace {

void check_lens(const desc::Camera& camera, float radius, float focal_distance) {
  if (!(radius >= 0.F) || !std::isfinite(radius)) {
    throw SceneError(camera.where, "the camera's lens radius must be 0 or more");
  }
  if (radius > 0.F && !(focal_distance > 0.F && std::isfinite(focal_distance))) {
    throw SceneError(camera.where, "the camera's focal distance must be more than 0");
  }
  // Slope of directions through the lens, per unit along the axis.
  const float slope = std::max(radius, 1.F) / focal_distance;
  if (radius > 0.F && !(slope <= kMaxCoordinate)) {
    throw SceneError(camera.where, "the camera's focal distance is too small for its lens");
  }
}

struct MakeCamera {
  const desc::Camera& camera;
  Vec2i resolution;

  std::unique_ptr<Camera> operator()(const desc::PerspectiveCamera& node) const {
    if (!(node.fov > 0.F && node.fov < 180.F)) {
      throw SceneError(camera.where,
                       "the camera's field of view must be between 0 and 180 degrees");
    }
    check_lens(camera, node.lens_radius, node.focal_distance);
    return make_perspective_camera(camera, node, resolution);
  }
  std::unique_ptr<Camera> operator()(const desc::OrthographicCamera& node) const {
    check_lens(camera, node.lens_radius, node.focal_distance);
    return make_orthographic_camera(camera, node, resolution);
  }
  std::unique_ptr<Camera> operator()(const desc::EnvironmentCamera& /*node*/) const {
    return make_environment_camera(camera, resolution);
  }
};

}  // namespace

Vec2 Camera::invert_lens(const EndpointPoint& point, const Vec2& fresh) const {
  if (lens_radius_ == 0.F) return fresh;
  return warp::uniform_disk_inverse(point.surface.uv / lens_radius_);
}

std::optional<EmissionUniforms> Camera::invert_emission(const EndpointPoint& point,
                                                        const Vec3& /*through*/, const Vec3& w,
                                                        const EmissionUniforms& fresh) const {
  const std::optional<Vec2> at = raster(point, w);
  if (!at) return std::nullopt;
  return EmissionUniforms{fresh.primitive, invert_lens(point, fresh.position),
                          *at / Vec2(resolution())};
}

std::optional<ConnectionUniforms> Camera::invert_connection(const Vec3& /*reference*/,
                                                            const EndpointPoint& point,
                                                            const ConnectionUniforms& fresh) const {
  return ConnectionUniforms{fresh.primitive, invert_lens(point, fresh.position)};
}

std::unique_ptr<Camera> make_camera(const desc::Camera& camera, Vec2i resolution,
                                    const Vec3& /*bounds_center*/, float /*bounds_radius*/) {
  if (resolution.x <= 0 || resolution.y <= 0) {
    throw SceneError(camera.where, "the image has no pixels");
  }
  if (!DirectionMap::invertible(camera.to_world)) {
    throw SceneError(camera.where,
                     "the transform of the camera cannot be inverted in single precision");
  }
  auto made = std::visit(MakeCamera{camera, resolution}, camera.node);
  check_reach(camera.where, "the camera", reach_of(made->bounds()));
  return made;
}

}  // namespace ajar
