#pragma once
#include <optional>

#include "core/frame.h"
#include "core/pdf.h"
#include "core/warp.h"
#include "scene/light/light.h"

namespace ajar {

/// The disk through which a light at infinity shines on the scene: perpendicular to the rays, as
/// wide as the bounding sphere and just outside of it.
class BoundingDisk {
 public:
  explicit BoundingDisk(const BoundingSphere& sphere) : sphere_(sphere) {
    // A scene of one point still needs a finite density.
    if (!(sphere_.radius > 0.F)) sphere_.radius = 1.F;
  }
  /// Uniform point of the disk in unit direction `toward` from the scene.
  Vec3 sample(const Vec3& toward, const Vec2& u) const {
    const Vec2 disk = warp::uniform_disk(u) * sphere_.radius;
    return sphere_.center +
           Frame::around(toward).to_world({disk.x, disk.y, 1.001F * sphere_.radius});
  }
  /// The numbers of the ray along −`toward` through a point; empty if it misses the disk.
  std::optional<Vec2> invert(const Vec3& toward, const Vec3& through) const {
    const Vec3 local = Frame::around(toward).to_local(through - sphere_.center) / sphere_.radius;
    constexpr float kRounding = 1e-4F;
    if (!(local.x * local.x + local.y * local.y < 1.F + kRounding)) return std::nullopt;
    return warp::uniform_disk_inverse({local.x, local.y});
  }
  float area() const { return kPi * sphere_.radius * sphere_.radius; }
  Pdf<Departure> pdf() const { return Pdf<Departure>(1.F / area()); }

 private:
  BoundingSphere sphere_;
};

}  // namespace ajar
