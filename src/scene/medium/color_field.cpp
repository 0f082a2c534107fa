#include "scene/medium/color_field.h"

#include <algorithm>

#include "scene/medium/cubic.h"
#include "scene/medium/thinnest.h"

namespace ajar {

namespace {

Vec3d lanes_of(const Spectrum& s) { return Vec3d(Vec3(s[0], s[1], s[2])); }

Spectrum spectrum_of(const Vec3d& lanes) {
  const auto finite = [](double x) {
    return static_cast<float>(std::min(x, double{std::numeric_limits<float>::max()}));
  };
  return {finite(lanes.x), finite(lanes.y), finite(lanes.z)};
}

Vec3d at_least(const Vec3d& v, double least) {
  return {std::max(v.x, least), std::max(v.y, least), std::max(v.z, least)};
}

/// With a little of `most` in place of vacuum.
Spectrum positive(const Vec3d& lanes, const Spectrum& most) {
  Spectrum result = spectrum_of(lanes);
  for (int lane = 0; lane < 3; ++lane) {
    result.set(lane, std::max(result[lane], kThinnest * most[lane]));
  }
  return result;
}

}  // namespace

Spectrum ColorField::Coefficient::most() const {
  if (factors->empty()) return spectrum_of(unit);
  Vec3d result(0.0);
  for (std::size_t i = 0; i < factors->size(); ++i) {
    for (int lane = 0; lane < 3; ++lane) result[lane] = std::max(result[lane], at(i)[lane]);
  }
  return spectrum_of(result);
}

ColorField::ColorField(const desc::Density& colors, const Spectrum& sigma_a,
                       const Spectrum& sigma_s)
    : grid_(colors.grid),
      lattice_(colors),
      sigma_a_{&grid_->absorption, lanes_of(sigma_a)},
      sigma_s_{&grid_->scattering, lanes_of(sigma_s)},
      bricks_(lattice_,
              [this](const Lattice::Cell& point) {
                return lattice_.value(
                    point, [this](std::size_t i) { return sigma_a_.at(i) + sigma_s_.at(i); },
                    sigma_a_.beyond() + sigma_s_.beyond());
              }),
      most_sigma_s_(sigma_s_.most()),
      most_sigma_t_(sigma_a_.most() + most_sigma_s_) {}

std::array<Vec3d, 8> ColorField::extinction(const Lattice::Cell& cell) const {
  return lattice_.corners(
      cell, [this](std::size_t i) { return sigma_a_.at(i) + sigma_s_.at(i); },
      sigma_a_.beyond() + sigma_s_.beyond());
}

Spectrum ColorField::sigma_t(const Vec3& p) const {
  const Lattice::Place place = lattice_.locate(p);
  return positive(cubic::trilinear(extinction(place.cell), place.inside), most_sigma_t_);
}

Spectrum ColorField::sigma_s(const Vec3& p) const {
  const Lattice::Place place = lattice_.locate(p);
  const std::array<Vec3d, 8> corners = lattice_.corners(
      place.cell, [this](std::size_t i) { return sigma_s_.at(i); }, sigma_s_.beyond());
  return positive(cubic::trilinear(corners, place.inside), most_sigma_s_);
}

Crossing ColorField::along(const Ray& ray, float distance, int lane, float most) const {
  const auto limit = static_cast<double>(most);
  Vec3d sum(0.0);
  Crossing crossing{distance, {}, false};
  const auto visit = [&](const auto& sigma_t, double from, double to) {
    const Vec3d whole = cubic::integral(sigma_t, from, to);
    if (sum[lane] + whole[lane] > limit) {
      const auto of_lane = [&](double at) { return sigma_t(at)[lane]; };
      const double at = cubic::invert_integral(of_lane, from, to, whole[lane], limit - sum[lane]);
      sum += cubic::integral(sigma_t, from, at);
      sum[lane] = limit;
      crossing.distance = static_cast<float>(at);
      crossing.reached = true;
      return true;
    }
    sum += whole;
    return false;
  };
  const Lattice::Inside inside = lattice_.clip(ray, distance);
  lattice_.walk(inside, bricks_,
                [&](const Bricks::Brick& brick, const Lattice::Cell& cell, double from, double to) {
                  if (brick.is_uniform()) {
                    return visit([&](double) { return brick.uniform; }, from, to);
                  }
                  const std::array<Vec3d, 8> c = extinction(cell);
                  return visit(
                      [&](double at) {
                        return at_least(cubic::trilinear(c, inside.at(at) - Vec3d(cell)), 0.0);
                      },
                      from, to);
                });
  crossing.depth = spectrum_of(sum);
  return crossing;
}

}  // namespace ajar
