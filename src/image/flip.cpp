#include "image/flip.h"

#include <ImathMatrix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "core/parallel_for.h"
#include "image/plane.h"
#include "image/tone_curve.h"

namespace ajar {

namespace {
constexpr double kPi = 3.14159265358979323846;
// Names in the paper, sections 4.1 (colour) and 4.2 (features), on the right.
constexpr double kColorExponent = 0.7;    // q_c
constexpr double kFeatureExponent = 0.5;  // q_f
constexpr double kColorShare = 0.4;       // p_c
constexpr double kErrorShare = 0.95;      // p_t
constexpr double kFeatureWidth = 0.082;   // w, degrees

/// One Gaussian of a contrast sensitivity in the spatial domain: the weight
/// `a·sqrt(π/b)·exp(−π²d²/b)` at d degrees from the centre.
struct Sensitivity {
  double a;
  double b;
};
constexpr Sensitivity kAchromatic{1.0, 0.0047};
constexpr Sensitivity kRedGreen{1.0, 0.0053};
constexpr std::array<Sensitivity, 2> kBlueYellow{{{34.1, 0.04}, {13.5, 0.025}}};
constexpr double kWidest = 0.04;

/// Linear RGB (Rec. 709) → XYZ divided by the XYZ of white, for row vectors. Not color/color.h,
/// whose matrix is rounded otherwise: here the fractions by which the paper's colours are defined.
const Imath::M33d& relative_xyz_from_rgb() {
  static const Imath::M33d matrix = [] {
    const std::array<Vec3d, 3> rows{{{30406656, 26366430, 13305225},  // X
                                     {15678432, 52732860, 5322090},   // Y
                                     {1425312, 8788810, 70074185}}};  // Z
    Imath::M33d result;
    for (int i = 0; i < 3; ++i) {
      const Vec3d& row = rows[static_cast<std::size_t>(i)];
      for (int j = 0; j < 3; ++j) result[j][i] = row[j] / (row.x + row.y + row.z);
    }
    return result;
  }();
  return matrix;
}
const Imath::M33d& rgb_from_relative_xyz() {
  static const Imath::M33d matrix = relative_xyz_from_rgb().inverse();
  return matrix;
}
/// L*a*b*, or the linear opponent space YCxCz, of relative XYZ: the same but for the curve.
Vec3d opponent(const Vec3d& xyz) {
  return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}
Vec3d relative_xyz(const Vec3d& opponent) {
  const double y = (opponent.x + 16) / 116;
  return {y + opponent.y / 500, y, y - opponent.z / 200};
}
double lab_curve(double t) {
  constexpr double kDelta = 6.0 / 29.0;
  return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29.0;
}

/// L*a*b* of linear RGB with the adjustment of Hunt: colours fade with luminance.
Vec3d hunt_lab(const Vec3d& rgb) {
  const Vec3d xyz = rgb * relative_xyz_from_rgb();
  const Vec3d lab = opponent({lab_curve(xyz.x), lab_curve(xyz.y), lab_curve(xyz.z)});
  const double fading = 0.01 * lab.x;
  return {lab.x, fading * lab.y, fading * lab.z};
}

/// Distance for large colour differences. Source: Abasi et al. 2020, eq. 4.
double hyab(const Vec3d& a, const Vec3d& b) {
  return std::abs(a.x - b.x) + std::sqrt((a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

using Planes = std::array<Plane, 3>;

Planes opponent_planes(std::span<const float> display, Vec2i size) {
  Planes planes{Plane(size), Plane(size), Plane(size)};
  parallel_for(planes[0].values.size(), [&](std::size_t i) {
    const auto linear = [&](std::size_t c) {
      // Written so that NaN becomes zero.
      const float value = display[3 * i + c];
      return double{linear_from_srgb(value > 0.F ? std::min(value, 1.F) : 0.F)};
    };
    const Vec3d color = opponent(Vec3d(linear(0), linear(1), linear(2)) * relative_xyz_from_rgb());
    for (int c = 0; c < 3; ++c) {
      planes[static_cast<std::size_t>(c)].values[i] = static_cast<float>(color[c]);
    }
  });
  return planes;
}

/// A Gaussian as a kernel whose weights add up to `total`.
SeparableKernel normalised(std::vector<double> weights, double total) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  SeparableKernel kernel;
  for (const double w : weights) {
    kernel.y.push_back(static_cast<float>(w / sum));
    kernel.x.push_back(static_cast<float>(total * w / sum));
  }
  return kernel;
}

/// Filters with a sum of Gaussians whose weights together add up to 1.
Plane see(const Plane& plane, std::span<const Sensitivity> sensitivities, double ppd) {
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(kWidest / (2 * kPi * kPi)) * ppd));
  std::vector<std::vector<double>> gaussians;
  std::vector<double> totals;
  for (const Sensitivity& s : sensitivities) {
    gaussians.push_back(gaussian_weights(radius, ppd * std::sqrt(s.b / 2) / kPi));
    const double sum = std::accumulate(gaussians.back().begin(), gaussians.back().end(), 0.0);
    totals.push_back(s.a * std::sqrt(kPi / s.b) * sum * sum);
  }
  const double total = std::accumulate(totals.begin(), totals.end(), 0.0);
  Plane result(plane.size);
  for (std::size_t i = 0; i < gaussians.size(); ++i) {
    const Plane part = filter_plane(plane, normalised(gaussians[i], totals[i] / total));
    std::transform(result.values.begin(), result.values.end(), part.values.begin(),
                   result.values.begin(), std::plus<>());
  }
  return result;
}

/// Colours of an image as the eye resolves them, in Hunt-adjusted L*a*b*.
std::vector<Vec3d> seen_colors(const Planes& planes, double ppd) {
  const Planes seen{see(planes[0], std::span(&kAchromatic, 1), ppd),
                    see(planes[1], std::span(&kRedGreen, 1), ppd),
                    see(planes[2], kBlueYellow, ppd)};
  std::vector<Vec3d> colors(planes[0].values.size());
  parallel_for(colors.size(), [&](std::size_t i) {
    const Vec3d filtered(seen[0].values[i], seen[1].values[i], seen[2].values[i]);
    Vec3d rgb = relative_xyz(filtered) * rgb_from_relative_xyz();
    for (int c = 0; c < 3; ++c) rgb[c] = std::clamp(rgb[c], 0.0, 1.0);
    colors[i] = hunt_lab(rgb);
  });
  return colors;
}

/// Colour difference in 0…1: the lower 40 % of what is possible get 95 % of the range.
double color_difference(const Vec3d& a, const Vec3d& b) {
  static const double largest =
      std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), kColorExponent);
  const double limit = kColorShare * largest;
  const double difference = std::pow(hyab(a, b), kColorExponent);
  if (difference < limit) return kErrorShare * difference / limit;
  return kErrorShare + (1 - kErrorShare) * (difference - limit) / (largest - limit);
}

/// Divides such that the positive weights add up to 1 and the negative ones to −1.
std::vector<float> balanced(const std::vector<double>& weights) {
  double positive = 0.0;
  double negative = 0.0;
  for (const double w : weights) (w > 0 ? positive : negative) += std::abs(w);
  std::vector<float> result;
  result.reserve(weights.size());
  for (const double w : weights)
    result.push_back(static_cast<float>(w / (w > 0 ? positive : negative)));
  return result;
}

/// Strength of edges (first derivative) or points (second derivative) in an achromatic plane.
enum class Feature { Edge, Point };
std::vector<float> feature_strength(const Plane& luminance, Feature feature, double ppd) {
  const double sigma = 0.5 * kFeatureWidth * ppd;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  const std::vector<double> gaussian = gaussian_weights(radius, sigma);
  std::vector<double> derivative = gaussian;
  for (std::size_t i = 0; i < derivative.size(); ++i) {
    const double x = static_cast<double>(i) - radius;
    derivative[i] *= feature == Feature::Edge ? -x : x * x / (sigma * sigma) - 1;
  }
  const SeparableKernel across{balanced(derivative), normalised(gaussian, 1.0).y};
  const Plane along_x = filter_plane(luminance, across);
  const Plane along_y = filter_plane(luminance, SeparableKernel{across.y, across.x});
  std::vector<float> strength(luminance.values.size());
  parallel_for(strength.size(), [&](std::size_t i) {
    const float x = along_x.values[i];
    const float y = along_y.values[i];
    strength[i] = std::sqrt(x * x + y * y);
  });
  return strength;
}

Plane achromatic(const Plane& y) {
  Plane plane = y;
  for (float& v : plane.values) v = (v + 16.F) / 116.F;
  return plane;
}
}  // namespace

std::vector<float> flip_map(std::span<const float> image, std::span<const float> reference,
                            Vec2i size, double pixels_per_degree) {
  const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  if (size.x < 1 || size.y < 1 || image.size() != 3 * pixels || reference.size() != 3 * pixels) {
    throw std::invalid_argument("flip_map: an image does not have the size");
  }
  if (!(pixels_per_degree > 0)) throw std::invalid_argument("flip_map: pixels per degree");
  const Planes image_planes = opponent_planes(image, size);
  const Planes reference_planes = opponent_planes(reference, size);
  const std::vector<Vec3d> image_colors = seen_colors(image_planes, pixels_per_degree);
  const std::vector<Vec3d> reference_colors = seen_colors(reference_planes, pixels_per_degree);
  const Plane image_y = achromatic(image_planes[0]);
  const Plane reference_y = achromatic(reference_planes[0]);
  std::vector<float> features(pixels);
  for (const Feature feature : {Feature::Edge, Feature::Point}) {
    const std::vector<float> a = feature_strength(image_y, feature, pixels_per_degree);
    const std::vector<float> r = feature_strength(reference_y, feature, pixels_per_degree);
    for (std::size_t i = 0; i < pixels; ++i) {
      features[i] = std::max(features[i], std::abs(a[i] - r[i]));
    }
  }
  std::vector<float> map(pixels);
  parallel_for(pixels, [&](std::size_t i) {
    const double color = color_difference(image_colors[i], reference_colors[i]);
    const double feature = std::pow(features[i] / std::sqrt(2.0), kFeatureExponent);
    map[i] = static_cast<float>(std::pow(color, 1 - feature));
  });
  return map;
}

double map_mean(std::span<const float> map) {
  return std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
}

}  // namespace ajar
