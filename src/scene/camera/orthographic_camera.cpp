#include <cmath>

#include "core/warp.h"
#include "scene/camera/models.h"
#include "scene/camera/screen.h"

namespace ajar {

namespace {

/// Parallel projection, with a telecentric lens if one is given (see `make_camera`). Each lens
/// point l stands for one direction, l toward (0, 0, focal distance), seen by the whole film: an
/// endpoint at infinity, with few directions. The film point of a ray is where it started minus l.
class OrthographicCamera final : public Camera {
 public:
  OrthographicCamera(const desc::Camera& camera, const desc::OrthographicCamera& node,
                     Vec2i resolution)
      : Camera(resolution, node.lens_radius),
        screen_(node.window, node.aspect, resolution, 1.F, camera.where),
        directions_(camera.to_world),
        position_(transform_point(camera.to_world, Vec3(0.F))),
        film_(cross(directions_.vector_to_world({1.F, 0.F, 0.F}),
                    directions_.vector_to_world({0.F, 1.F, 0.F}))),
        focal_distance_(node.focal_distance) {}

  bool at_infinity() const override { return true; }
  bool discrete_position() const override { return lens_radius() == 0.F; }
  Box3 bounds() const override {
    // The window, and as far around it as the lens is wide.
    Imath::Box2f starts(screen_.to_plane({0.F, 0.F}));
    starts.extendBy(screen_.to_plane({1.F, 1.F}));
    const Vec2 low = starts.min - Vec2(lens_radius());
    const Vec2 high = starts.max + Vec2(lens_radius());
    Box3 box;
    for (const float x : {low.x, high.x}) {
      for (const float y : {low.y, high.y}) {
        box.extendBy(position_ + directions_.vector_to_world({x, y, 0.F}));
      }
    }
    return box;
  }

  std::optional<EmissionSample> sample_emission(const EmissionUniforms& u) const override {
    const Vec2 lens = sample_lens(u.position);
    const Vec3 w = direction_from(lens);
    const Vec2 start = screen_.to_plane(u.direction) + lens;
    const EndpointPoint point = point_at({start.x, start.y, 0.F}, lens, w);
    return EmissionSample{point,         point.surface.p,  w,
                          Spectrum(1.F), direction_pdf(w), Pdf<Departure>(film_pdf(w))};
  }

  EmissionPdf emission_pdf(const EndpointPoint& point, const Vec3& w) const override {
    return {direction_pdf(w), Pdf<Departure>(raster(point, w) ? film_pdf(w) : 0.F)};
  }

  Spectrum emitted(const EndpointPoint& point, const Vec3& w) const override {
    return raster(point, w) ? Spectrum(direction_pdf(w).value() * film_pdf(w)) : Spectrum();
  }

  std::optional<ConnectionSample> sample_connection(const Vec3& reference,
                                                    const ConnectionUniforms& u) const override {
    const Vec2 lens = sample_lens(u.position);
    const Vec3 w = direction_from(lens);
    const Vec3 local = directions_.vector_to_local(reference - position_);
    if (!(local.z > 0.F)) return std::nullopt;
    const Vec2 slope = direction_slope(lens);
    const EndpointPoint point =
        point_at({local.x - slope.x * local.z, local.y - slope.y * local.z, 0.F}, lens, w);
    if (!raster(point, w)) return std::nullopt;
    return ConnectionSample{point, -w, length(point.surface.p - reference), Spectrum(film_pdf(w)),
                            direction_pdf(w)};
  }

  Pdf<VertexMeasure> connection_pdf(const Vec3& /*reference*/,
                                    const EndpointPoint& point) const override {
    return direction_pdf(-point.toward);
  }

  std::optional<Vec2> raster(const EndpointPoint& point, const Vec3& /*w*/) const override {
    const Vec3 start = directions_.vector_to_local(point.surface.p - position_);
    return screen_.to_raster(Vec2(start.x, start.y) - point.surface.uv);
  }

 private:
  Vec2 sample_lens(const Vec2& u) const {
    return lens_radius() == 0.F ? Vec2(0.F) : warp::uniform_disk(u) * lens_radius();
  }
  /// (dx/dz, dy/dz) of the rays of a lens point, in camera space.
  Vec2 direction_slope(const Vec2& lens) const {
    return lens_radius() == 0.F ? Vec2(0.F) : lens * (-1.F / focal_distance_);
  }
  Vec3 direction_from(const Vec2& lens) const {
    const Vec2 slope = direction_slope(lens);
    return directions_.to_world({slope.x, slope.y, 1.F});
  }
  EndpointPoint point_at(const Vec3& local, const Vec2& lens, const Vec3& w) const {
    EndpointPoint point = EndpointPoint::at_infinity(-w, lens);
    point.surface.p = position_ + directions_.vector_to_world(local);
    return point;
  }
  /// Density of a direction of the lens: dA_lens / dω = f² / cos³ θ.
  Pdf<VertexMeasure> direction_pdf(const Vec3& w) const {
    if (lens_radius() == 0.F) return Pdf<VertexMeasure>(1.F);
    const DirectionMap::Local local = directions_.to_local(w);
    const float relative = focal_distance_ / lens_radius();
    return Pdf<VertexMeasure>(local.stretch * relative * relative /
                              (kPi * local.w.z * local.w.z * local.w.z));
  }
  /// Per area perpendicular to w.
  float film_pdf(const Vec3& w) const { return 1.F / (screen_.area() * abs_dot(film_, w)); }

  Screen screen_;
  DirectionMap directions_;
  Vec3 position_;
  Vec3 film_;  ///< normal of the film plane, as long as the world area of a unit square of it
  float focal_distance_;
};

}  // namespace

std::unique_ptr<Camera> make_orthographic_camera(const desc::Camera& camera,
                                                 const desc::OrthographicCamera& node,
                                                 Vec2i resolution) {
  return std::make_unique<OrthographicCamera>(camera, node, resolution);
}

}  // namespace ajar
