#pragma once
#include <cmath>
#include <optional>

#include "core/frame.h"
#include "core/pdf.h"
#include "core/unit_interval.h"
#include "core/warp.h"
#include "scene/light/light.h"

namespace ajar {

/// Restricts a lamp's emission to the scene's receivers. A lamp far off, such as a disk as the sun,
/// sends nearly all of its light past the scene. So directions are a mixture: uniform in the cone
/// around the sphere of the receivers, and else the lamp's own, since it may also light another
/// lamp (docs/methods/light-sampling.md).
class Aim {
 public:
  /// Directions of a lamp without receivers.
  Aim() = default;
  /// The sphere is around everything that does not emit.
  explicit Aim(const std::optional<BoundingSphere>& receivers) : receivers_(receivers) {}

  /// Direction from `p`. `own` makes the lamp's own of two uniform numbers.
  template <class Own>
  Vec3 sample(const Vec3& p, Vec2 u, const Own& own) const {
    const std::optional<Cone> cone = cone_from(p);
    if (!cone) return own(u);
    if (u.x < kAimed) {
      u.x = std::min(u.x / kAimed, kOneMinusEpsilon);
      return cone->frame.to_world(warp::uniform_cone(u, cone->one_minus_cos));
    }
    u.x = std::min((u.x - kAimed) / (1.F - kAimed), kOneMinusEpsilon);
    return own(u);
  }
  /// Density of the unit vector `w`, of which the lamp's own is `own`.
  Pdf<Departure> pdf(const Vec3& p, const Vec3& w, Pdf<Departure> own) const {
    const std::optional<Cone> cone = cone_from(p);
    if (!cone) return own;
    return Pdf<Departure>(kAimed * cone->pdf(w) + (1.F - kAimed) * own.value());
  }
  /// The numbers by which `sample` gives `w`. By `own_numbers` the lamp's own directions give it,
  /// with the density `own`; `fresh` is uniform, and chooses between the two ways.
  Vec2 invert(const Vec3& p, const Vec3& w, Pdf<Departure> own, Vec2 own_numbers,
              float fresh) const {
    const std::optional<Cone> cone = cone_from(p);
    if (!cone) return own_numbers;
    const double aimed = double{kAimed} * static_cast<double>(cone->pdf(w));
    const double others = (1.0 - double{kAimed}) * static_cast<double>(own.value());
    if (!(aimed + others > 0.0)) return own_numbers;
    if (came_first(aimed, others, fresh)) {
      const Vec2 v = cone->numbers_of(w);
      return {UnitInterval{0.0, double{kAimed}}.at(v.x), v.y};
    }
    const UnitInterval rest{double{kAimed}, 1.0 - double{kAimed}};
    return {rest.at(own_numbers.x), own_numbers.y};
  }

 private:
  /// Share of directions that are aimed. Others bound the variance of light between lamps to 1 / (1
  /// − kAimed) of that without aiming, and cost 1 / kAimed of the rest.
  static constexpr float kAimed = 0.95F;
  /// Sine of half the angle of the narrowest cone: directions are rounded to 10⁻⁷.
  static constexpr float kNarrowest = 1e-3F;

  struct Cone {
    Frame frame;
    float one_minus_cos;

    /// 1 − cos of the angle to `local`, without cancellation.
    static float one_minus_cos_of(const Vec3& local) {
      if (local.z <= 0.F) return 1.F - local.z;
      return (local.x * local.x + local.y * local.y) / (1.F + local.z);
    }
    float pdf(const Vec3& w) const {
      // Rounding at the border counts as a miss of the receivers.
      constexpr float kRounding = 1e-3F;
      if (one_minus_cos_of(frame.to_local(w)) > one_minus_cos * (1.F + kRounding)) return 0.F;
      return warp::uniform_cone_pdf(one_minus_cos);
    }
    Vec2 numbers_of(const Vec3& w) const {
      const Vec3 local = frame.to_local(w);
      return {std::min(one_minus_cos_of(local) / one_minus_cos, kOneMinusEpsilon),
              warp::turn_of({local.x, local.y})};
    }
  };
  /// Empty where the cone would have no more density than a lamp's own directions: 1/π at most.
  std::optional<Cone> cone_from(const Vec3& p) const {
    if (!receivers_) return std::nullopt;
    const Vec3 axis = receivers_->center - p;
    const float distance = length(axis);
    constexpr float kSine60 = 0.866F;
    if (!(receivers_->radius < kSine60 * distance)) return std::nullopt;
    const float sine = std::max(receivers_->radius / distance, kNarrowest);
    return Cone{Frame::around(axis / distance), sine * sine / (1.F + std::sqrt(1.F - sine * sine))};
  }

  std::optional<BoundingSphere> receivers_;
};

}  // namespace ajar
