#pragma once
#include <memory>
#include <optional>

#include "scene/desc/scene_desc.h"
#include "scene/endpoint.h"

namespace ajar {

class Medium;

/// A camera is an endpoint that emits importance. Raster coordinates are in pixels of the full
/// image, x to the right, y down, (0,0) the top left corner of the top left pixel.
///
/// `EmissionUniforms::direction` times the full resolution IS the raster position (so callers
/// choose the pixel by choosing these two numbers); `position` samples the lens.
///
/// Importance is normalised so that the measurement of a pixel with filter h is
/// I = ∫ h(raster) · L · W_e · cos, with W_e such that uniform raster positions have weight 1:
/// `sample_emission(...).weight` = 1 (a pixel value is the plain mean of the radiance of its rays
/// when ∫h = 1 over pixels). Hence W_e · cos dA dω = (raster area element) / (number of pixels):
/// connection weights of light tracing must be multiplied by the number of pixels of the full image
/// when they are divided by the count of light paths per image.
///
/// `to_world` may be any invertible affine map: lens and directions are stretched with it,
/// densities follow. Source: pbrt-v3, section 16.1.1 (there normalised per film area).
class Camera : public Endpoint {
 public:
  /// Raster position of the ray that leaves `point` in direction `w` (away from the camera); empty
  /// if outside of the full image.
  virtual std::optional<Vec2> raster(const EndpointPoint& point, const Vec3& w) const = 0;
  /// Box of the points where its rays start.
  virtual Box3 bounds() const = 0;
  Vec2i resolution() const { return resolution_; }
  std::optional<EmissionUniforms> invert_emission(const EndpointPoint& point, const Vec3& through,
                                                  const Vec3& w,
                                                  const EmissionUniforms& fresh) const final;
  std::optional<ConnectionUniforms> invert_connection(const Vec3& reference,
                                                      const EndpointPoint& point,
                                                      const ConnectionUniforms& fresh) const final;

  const Medium* medium = nullptr;

 protected:
  /// `lens_radius`: in camera space; 0 without a lens. `uv` of a point of an endpoint is where it
  /// is on the lens.
  explicit Camera(Vec2i resolution, float lens_radius = 0.F)
      : resolution_(resolution), lens_radius_(lens_radius) {}
  float lens_radius() const { return lens_radius_; }

 private:
  /// The numbers of a point on the lens.
  Vec2 invert_lens(const EndpointPoint& point, const Vec2& fresh) const;

  Vec2i resolution_;
  float lens_radius_;
};

/// Perspective: a pinhole (lens radius 0) or thin lens; fov belongs to the shorter image side.
///
/// Orthographic: rays start on the plane z = 0 of the camera; its vertex is their direction. With a
/// lens it is telecentric: film point q is seen from q + l toward q + (0, 0, focal distance), l
/// uniform on the lens. Depth of field is the same all over the image and the direction does not
/// depend on q. (In pbrt-v3 all rays then start on one lens around the origin, as in perspective.)
///
/// Environment: all directions from one point, latitude–longitude.
///
/// Raises SceneError for a transform without inverse, an empty screen window, a field of view
/// outside (0, 180) degrees, a lens without a positive focal distance, and for all of these and the
/// place if they are too large. The bounds are for models that start rays outside of the scene;
/// none of these does.
std::unique_ptr<Camera> make_camera(const desc::Camera& camera, Vec2i resolution,
                                    const Vec3& bounds_center, float bounds_radius);

}  // namespace ajar
