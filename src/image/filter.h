#pragma once
#include <array>
#include <cstdint>
#include <memory>

#include "core/vector.h"

namespace ajar {

/// A camera sample of one pixel, relative to the pixel's centre.
struct FilterSample {
  Vec2 offset;   ///< pixels, within [-radius, radius)
  float weight;  ///< h / pdf; negative in the negative lobes of Mitchell and sinc
};

/// A separable reconstruction filter h, normalised so that ∫ h = 1 over the plane (per pixel²).
/// Shapes and radii are those of pbrt-v3 (Pharr et al., "Physically Based Rendering", section 7.8),
/// so that scene files mean here what they mean there; only the normalisation differs. Immutable;
/// copies share their tables.
class Filter {
 public:
  /// Largest radius that is accepted, in pixels.
  static constexpr float kMaxRadius = 32.F;

  /// All factories take radii in pixels and raise SceneError if a radius is not in (0, kMaxRadius]
  /// or the shape vanishes everywhere.
  static Filter box(const Vec2& radius = {0.5F, 0.5F});
  static Filter triangle(const Vec2& radius);
  /// exp(−α x²) − exp(−α r²).
  static Filter gaussian(const Vec2& radius, float alpha);
  /// Mitchell & Netravali 1988, "Reconstruction filters in computer graphics".
  static Filter mitchell(const Vec2& radius, float b, float c);
  /// sinc(x) · sinc(x / τ): the Lanczos window, cut at the radius.
  static Filter sinc(const Vec2& radius, float tau);

  Vec2 radius() const { return {axes_[0].radius, axes_[1].radius}; }
  /// True if pixels share nothing: `box` of its default radius.
  bool is_box_of_pixel() const { return shape_ == Shape::Box && radius() == Vec2(0.5F, 0.5F); }

  /// h at an offset (pixels) from the centre; zero outside [-radius, radius), an interval open to
  /// the right so that box filters of neighbouring pixels do not overlap.
  float eval(const Vec2& offset) const;

  /// One factor of h, along axis 0 or 1: h(x, y) = eval_axis(0, x) · eval_axis(1, y). The caller
  /// knows that the offset is within the radius; it is not checked, so that a film that has chosen
  /// its pixels exactly is not contradicted by the rounding of an offset.
  float eval_axis(int axis, float offset) const;

  /// Offset drawn with density ∝ |h| (box, triangle: exactly; others: from a piecewise linear fit),
  /// and the exact weight h / pdf: E[weight · g(offset)] = ∫ h g for every g. Monotone in both
  /// uniform numbers, so that stratified numbers stay stratified. Source: Ernst, Stamminger,
  /// Greiner 2006, "Filter importance sampling".
  FilterSample sample(const Vec2& u) const;

 private:
  enum class Shape : std::uint8_t { Box, Triangle, Gaussian, Mitchell, Sinc };
  struct Table;
  struct Axis {
    float radius = 0.5F;
    float scale = 1.F;  ///< 1 / integral of the unscaled shape
    float edge = 0.F;   ///< Gaussian: its value at the radius
    std::shared_ptr<const Table> table;
  };
  struct AxisSample {
    float offset, weight;
  };

  Filter(Shape shape, const Vec2& radius, float p0, float p1);
  Axis make_axis(float radius) const;
  double unscaled(const Axis& axis, double x) const;
  float value(const Axis& axis, float x) const;
  AxisSample sample_axis(const Axis& axis, float u) const;

  Shape shape_;
  std::array<float, 2> parameters_;
  std::array<Axis, 2> axes_;
};

}  // namespace ajar
