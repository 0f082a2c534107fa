#include "image/filter.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/number_text.h"

namespace ajar {

namespace {
constexpr int kCells = 128;
constexpr int kGuides = 1024;

/// sin(πx)/(πx).
template <typename Real>
Real normalised_sinc(Real x) {
  const Real t = static_cast<Real>(3.14159265358979323846) * x;
  return std::abs(t) < static_cast<Real>(1e-5) ? Real{1} : std::sin(t) / t;
}

/// `x` in units of half the radius, so that the support is [0, 2).
template <typename Real>
Real mitchell_netravali(Real x, Real b, Real c) {
  constexpr Real sixth = Real{1} / Real{6};
  if (x > 2) return 0;
  if (x > 1) {
    return ((((-b - 6 * c) * x + (6 * b + 30 * c)) * x + (-12 * b - 48 * c)) * x +
            (8 * b + 24 * c)) *
           sixth;
  }
  return (((12 - 9 * b - 6 * c) * x + (-18 + 12 * b + 6 * c)) * x * x + (6 - 2 * b)) * sixth;
}
}  // namespace

/// Piecewise linear density on [0, radius], the same for the other side. Cells are equally wide in
/// x, so that tails are fitted as well as the peak; a guide finds them, in O(1) on average (Chen &
/// Asau 1974). Densities are relative to the cell's mean.
struct Filter::Table {
  struct Cell {
    float start;         ///< cumulative probability before the cell
    float per_width;     ///< 1 / probability of the cell
    float left;          ///< density at its left end
    float left_squared;  ///< its square, and the rise of squares to the right end
    float squared_rise;
    float weight;  ///< 1 / (mean density over both sides, in pixels^-1)
  };
  std::array<Cell, kCells> cells;
  std::array<std::uint8_t, kGuides> guide;  ///< cell that holds u = i / kGuides
};

Filter::Filter(Shape shape, const Vec2& radius, float p0, float p1)
    : shape_(shape), parameters_{p0, p1} {
  axes_[0] = make_axis(radius.x);
  axes_[1] = radius.y == radius.x ? axes_[0] : make_axis(radius.y);
}

Filter Filter::box(const Vec2& radius) { return {Shape::Box, radius, 0.F, 0.F}; }
Filter Filter::triangle(const Vec2& radius) { return {Shape::Triangle, radius, 0.F, 0.F}; }
Filter Filter::gaussian(const Vec2& radius, float alpha) {
  return {Shape::Gaussian, radius, alpha, 0.F};
}
Filter Filter::mitchell(const Vec2& radius, float b, float c) {
  return {Shape::Mitchell, radius, b, c};
}
Filter Filter::sinc(const Vec2& radius, float tau) { return {Shape::Sinc, radius, tau, 0.F}; }

Filter::Axis Filter::make_axis(float radius) const {
  if (!(radius > 0.F && radius <= kMaxRadius)) {
    throw SceneError("filter radius " + number_text(double{radius}) + " is not in (0, " +
                     std::to_string(static_cast<int>(kMaxRadius)) + "] pixels");
  }
  Axis axis;
  axis.radius = radius;
  if (shape_ == Shape::Gaussian) axis.edge = std::exp(-parameters_[0] * radius * radius);

  // Simpson's rule: exact for box, triangle and Mitchell, whose pieces meet where cells meet.
  const double step = radius / static_cast<double>(kCells);
  constexpr int kSteps = 16;
  double integral = 0.0;
  for (int i = 0; i < kCells * kSteps; ++i) {
    const double a = i * step / kSteps;
    const double b = (i + 1) * step / kSteps;
    integral += (unscaled(axis, a) + 4.0 * unscaled(axis, 0.5 * (a + b)) + unscaled(axis, b)) *
                (b - a) / 6.0;
  }
  integral *= 2.0;
  if (!(integral > 1e-12) || !std::isfinite(integral)) {
    throw SceneError("filter with these parameters vanishes or is not finite");
  }
  axis.scale = static_cast<float>(1.0 / integral);
  if (shape_ == Shape::Box || shape_ == Shape::Triangle) return axis;

  // The floor keeps the weights finite where h has its zeros; it takes about a millionth of the
  // samples.
  std::array<double, kCells + 1> density;
  for (int i = 0; i <= kCells; ++i) density[i] = std::abs(unscaled(axis, i * step));
  const double peak = *std::max_element(density.begin(), density.end());
  double total = 0.0;
  for (double& d : density) d = std::max(d, 1e-6 * peak);
  for (int i = 0; i < kCells; ++i) total += 0.5 * (density[i] + density[i + 1]);

  auto table = std::make_shared<Table>();
  double sum = 0.0;
  for (int i = 0; i < kCells; ++i) {
    const double mean = 0.5 * (density[i] + density[i + 1]);
    const double left = density[i] / mean;
    const double right = density[i + 1] / mean;
    table->cells[i] = {static_cast<float>(sum / total),
                       static_cast<float>(total / mean),
                       static_cast<float>(left),
                       static_cast<float>(left * left),
                       static_cast<float>(right * right - left * left),
                       static_cast<float>(2.0 * step * total / mean)};
    sum += mean;
  }
  std::uint8_t cell = 0;
  for (int i = 0; i < kGuides; ++i) {
    const float u = static_cast<float>(i) / kGuides;
    while (cell + 1 < kCells && table->cells[cell + 1].start <= u) ++cell;
    table->guide[i] = cell;
  }
  axis.table = std::move(table);
  return axis;
}

double Filter::unscaled(const Axis& axis, double x) const {
  x = std::abs(x);
  const double r = axis.radius;
  const double p0 = parameters_[0];
  switch (shape_) {
    case Shape::Box:
      return 1.0;
    case Shape::Triangle:
      return std::max(0.0, r - x);
    case Shape::Gaussian:
      return std::max(0.0, std::exp(-p0 * x * x) - std::exp(-p0 * r * r));
    case Shape::Mitchell:
      return mitchell_netravali(2.0 * x / r, p0, double{parameters_[1]});
    case Shape::Sinc:
      return normalised_sinc(x) * normalised_sinc(x / p0);
  }
  return 0.0;
}

float Filter::value(const Axis& axis, float x) const {
  x = std::abs(x);
  switch (shape_) {
    case Shape::Box:
      return axis.scale;
    case Shape::Triangle:
      return axis.scale * std::max(0.F, axis.radius - x);
    case Shape::Gaussian:
      return axis.scale * std::max(0.F, std::exp(-parameters_[0] * x * x) - axis.edge);
    case Shape::Mitchell:
      return axis.scale * mitchell_netravali(2.F * x / axis.radius, parameters_[0], parameters_[1]);
    case Shape::Sinc:
      return axis.scale * normalised_sinc(x) * normalised_sinc(x / parameters_[0]);
  }
  return 0.F;
}

float Filter::eval_axis(int axis, float offset) const { return value(axes_[axis], offset); }

float Filter::eval(const Vec2& offset) const {
  const Vec2 r = radius();
  if (!(offset.x >= -r.x && offset.x < r.x && offset.y >= -r.y && offset.y < r.y)) return 0.F;
  return eval_axis(0, offset.x) * eval_axis(1, offset.y);
}

Filter::AxisSample Filter::sample_axis(const Axis& axis, float u) const {
  const float t = 2.F * u - 1.F;
  if (shape_ == Shape::Box) return {axis.radius * t, 1.F};
  // The left end of the interval is u = 0, which would be probability 1 on its side.
  const float s = std::min(std::abs(t), kOneMinusEpsilon);
  if (shape_ == Shape::Triangle)
    return {std::copysign(axis.radius * (1.F - std::sqrt(1.F - s)), t), 1.F};

  const Table& table = *axis.table;
  int i = table.guide[static_cast<int>(s * kGuides)];
  while (i + 1 < kCells && table.cells[i + 1].start <= s) ++i;
  const Table::Cell& cell = table.cells[i];
  const float local = std::min((s - cell.start) * cell.per_width, 1.F);
  // Inversion of a linear density of mean 1; this form has no cancellation when the ends are equal.
  const float root = std::sqrt(cell.left_squared + local * cell.squared_rise);
  const float within = std::min(2.F * local / (cell.left + root), 1.F);
  const float x = std::min((static_cast<float>(i) + within) * (axis.radius * (1.F / kCells)),
                           axis.radius * kOneMinusEpsilon);
  return {std::copysign(x, t), value(axis, x) * cell.weight / root};
}

FilterSample Filter::sample(const Vec2& u) const {
  const AxisSample x = sample_axis(axes_[0], u.x);
  const AxisSample y = sample_axis(axes_[1], u.y);
  return {{x.offset, y.offset}, x.weight * y.weight};
}

}  // namespace ajar
