#pragma once
#include <cmath>
#include <numbers>

#include "core/frame.h"
#include "core/vector.h"

namespace ajar {

/// Sizes of perturbations between two bounds, each order of magnitude as often as any other, in
/// uniform directions. Source: Veach 1997, section 11.4.3.
struct PerturbationLaw {
  double smallest;
  double largest;

  double size(double u) const { return largest * std::exp(-u * std::log(largest / smallest)); }
  /// Sizes that are measured after a move differ by rounding from those that were drawn: every
  /// proposal must have a density.
  bool reaches(double size) const {
    constexpr double kRounding = 1e-3;
    return size >= smallest * (1.0 - kRounding) && size <= largest * (1.0 + kRounding);
  }

  /// A place around the origin of a plane.
  Vec2 in_plane(const Vec2& u) const {
    const double r = size(static_cast<double>(u.x));
    const double phi = 2.0 * std::numbers::pi * static_cast<double>(u.y);
    return {static_cast<float>(r * std::cos(phi)), static_cast<float>(r * std::sin(phi))};
  }
  /// Density per area at this distance from the origin, within reach.
  double log_density_in_plane(double distance) const {
    return -std::log(2.0 * std::numbers::pi * distance * distance * std::log(largest / smallest));
  }
  /// A direction around another; sizes are angles.
  Vec3 around(const Vec3& w, const Vec2& u) const {
    const double theta = size(static_cast<double>(u.x));
    const double phi = 2.0 * std::numbers::pi * static_cast<double>(u.y);
    const Frame frame = Frame::around(w);
    const double sine = std::sin(theta);
    return normalize(frame.to_world({static_cast<float>(sine * std::cos(phi)),
                                     static_cast<float>(sine * std::sin(phi)),
                                     static_cast<float>(std::cos(theta))}));
  }
  /// Density per solid angle at this angle, within reach.
  double log_density_around(double angle) const {
    return -std::log(2.0 * std::numbers::pi * angle * std::sin(angle) *
                     std::log(largest / smallest));
  }
};

/// Perturbation of raster positions, for the size of the image.
PerturbationLaw raster_law(const Vec2i& pixels);

/// Between unit vectors; exact for small ones.
inline double small_angle(const Vec3& a, const Vec3& b) {
  const double half_chord = 0.5 * (Vec3d(a) - Vec3d(b)).length();
  return 2.0 * std::asin(std::min(1.0, half_chord));
}

}  // namespace ajar
