#include <cmath>

#include "core/warp.h"
#include "scene/camera/models.h"
#include "scene/camera/screen.h"

namespace ajar {

namespace {

/// Pinhole or thin lens. The raster is uniform on the window at z = 1, which fixes the direction
/// for each lens point: W_e |cos θ| = (1 / lens area) · (direction density), so that every sampled
/// ray weighs one. Source: pbrt-v3, sections 6.2.2–6.2.3 and 16.1.1.
class PerspectiveCamera final : public Camera {
 public:
  PerspectiveCamera(const desc::Camera& camera, const desc::PerspectiveCamera& node,
                    Vec2i resolution)
      : Camera(resolution, node.lens_radius),
        screen_(node.window, node.aspect, resolution, std::tan(node.fov * (kPi / 360.F)),
                camera.where),
        directions_(camera.to_world),
        position_(transform_point(camera.to_world, Vec3(0.F))),
        // Only the sharpness of a lens needs it; a pinhole is sharp everywhere.
        inverse_focal_distance_(lens_radius() > 0.F ? 1.F / node.focal_distance : 0.F) {
    const Vec3 plane = cross(directions_.vector_to_world({1.F, 0.F, 0.F}),
                             directions_.vector_to_world({0.F, 1.F, 0.F}));
    const Vec3 forward = directions_.vector_to_world({0.F, 0.F, 1.F});
    if (lens_radius() > 0.F) {
      normal_ = face_forward(normalize(plane), forward);
      lens_pdf_ = 1.F / (kPi * lens_radius() * lens_radius() * length(plane));
    }
  }

  bool at_infinity() const override { return false; }
  bool discrete_position() const override { return lens_radius() == 0.F; }
  Box3 bounds() const override {
    Box3 box(position_);
    for (const float x : {-lens_radius(), lens_radius()}) {
      for (const float y : {-lens_radius(), lens_radius()}) {
        box.extendBy(position_ + directions_.vector_to_world({x, y, 0.F}));
      }
    }
    return box;
  }

  std::optional<EmissionSample> sample_emission(const EmissionUniforms& u) const override {
    const EndpointPoint point = lens_point(u.position);
    const Vec2 plane = screen_.to_plane(u.direction);
    const Vec2 aim = plane - point.surface.uv * inverse_focal_distance_;
    const Vec3 w = directions_.to_world({aim.x, aim.y, 1.F});
    std::optional<EmissionSample> result(std::in_place);
    result->point = point;
    result->origin = point.surface.p;
    result->w = w;
    result->weight = Spectrum(1.F);
    result->position_pdf = Pdf<VertexMeasure>(lens_pdf_);
    result->departure_pdf = Pdf<Departure>(direction_pdf(directions_.to_local(w)));
    return result;
  }

  EmissionPdf emission_pdf(const EndpointPoint& point, const Vec3& w) const override {
    return {Pdf<VertexMeasure>(lens_pdf_), Pdf<Departure>(visible_pdf(point, w))};
  }

  Spectrum emitted(const EndpointPoint& point, const Vec3& w) const override {
    const float density = lens_pdf_ * visible_pdf(point, w);
    if (discrete_position()) return Spectrum(density);
    return density > 0.F ? Spectrum(density / abs_dot(normal_, w)) : Spectrum();
  }

  std::optional<ConnectionSample> sample_connection(const Vec3& reference,
                                                    const ConnectionUniforms& u) const override {
    const EndpointPoint point = lens_point(u.position);
    const Vec3 d = point.surface.p - reference;
    const float squared = length_squared(d);
    if (!(squared > 0.F)) return std::nullopt;
    const float distance = std::sqrt(squared);
    const Vec3 w = d / distance;
    // The cosine at the lens and the pdf of the lens point are in W_e already.
    const Spectrum weight(visible_pdf(point, -w) / squared);
    if (weight.is_black() || !weight.is_finite()) return std::nullopt;
    return ConnectionSample{point, w, distance, weight, Pdf<VertexMeasure>(lens_pdf_)};
  }

  Pdf<VertexMeasure> connection_pdf(const Vec3& /*reference*/,
                                    const EndpointPoint& /*point*/) const override {
    return Pdf<VertexMeasure>(lens_pdf_);
  }

  std::optional<Vec2> raster(const EndpointPoint& point, const Vec3& w) const override {
    return local_raster(point, directions_.vector_to_local(w));
  }

 private:
  /// `uv` of the point is where it is on the lens, in camera space.
  EndpointPoint lens_point(const Vec2& u) const {
    EndpointPoint point = EndpointPoint::at(position_);
    if (lens_radius() == 0.F) return point;
    const Vec2 lens = warp::uniform_disk(u) * lens_radius();
    point.surface.p += directions_.vector_to_world({lens.x, lens.y, 0.F});
    point.surface.ng = normal_;
    point.surface.ns = normal_;
    point.surface.uv = lens;
    return point;
  }
  std::optional<Vec2> local_raster(const EndpointPoint& point, const Vec3& local) const {
    if (!(local.z > 0.F)) return std::nullopt;
    return screen_.to_raster(Vec2(local.x, local.y) / local.z +
                             point.surface.uv * inverse_focal_distance_);
  }
  /// Density of a direction of the image, per world solid angle: dA / dω = 1 / cos³ θ at z = 1.
  float direction_pdf(const DirectionMap::Local& local) const {
    return local.stretch / (screen_.area() * local.w.z * local.w.z * local.w.z);
  }
  /// Density of any direction: zero outside of the image.
  float visible_pdf(const EndpointPoint& point, const Vec3& w) const {
    const DirectionMap::Local local = directions_.to_local(w);
    return local_raster(point, local.w) ? direction_pdf(local) : 0.F;
  }

  Screen screen_;
  DirectionMap directions_;
  Vec3 position_;
  float inverse_focal_distance_;
  Vec3 normal_{0.F, 0.F, 0.F};  ///< normal of the lens, forward; zero for a pinhole
  float lens_pdf_ = 1.F;        ///< per world area; one for a pinhole
};

}  // namespace

std::unique_ptr<Camera> make_perspective_camera(const desc::Camera& camera,
                                                const desc::PerspectiveCamera& node,
                                                Vec2i resolution) {
  return std::make_unique<PerspectiveCamera>(camera, node, resolution);
}

}  // namespace ajar
