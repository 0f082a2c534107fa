#include "color/color.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "color/cie_1931.h"
#include "color/cie_illuminants.h"

namespace ajar {
namespace {

/// Equal power at every wavelength.
double equal_energy(double /*wavelength*/) { return 1.0; }

double daylight(double wavelength) {
  const double x = std::clamp((wavelength - kCieFirst) / kD65Step, 0.0, kD65Samples - 1.0);
  const auto i = std::min(static_cast<std::size_t>(x), kD65.size() - 2);
  const double t = x - static_cast<double>(i);
  return (1.0 - t) * kD65[i] + t * kD65[i + 1];
}

/// Integrates a spectrum against the observer and an illuminant at 1 nm, all piecewise linear.
template <typename Spectrum>
Vec3d integrate(const Spectrum& spectrum, double (*illuminant)(double) = equal_energy) {
  constexpr int kSubsteps = static_cast<int>(kCieStep);
  Vec3d xyz(0.0, 0.0, 0.0);
  double y_of_one = 0.0;
  for (int i = 0; i < kCieSamples; ++i) {
    for (int s = 0; s < (i + 1 < kCieSamples ? kSubsteps : 1); ++s) {
      const double t = static_cast<double>(s) / kSubsteps;
      const auto& a = kCie1931[static_cast<std::size_t>(i)];
      const auto& b = kCie1931[static_cast<std::size_t>(std::min(i + 1, kCieSamples - 1))];
      const double wavelength = kCieFirst + kCieStep * (i + t);
      const double light = illuminant(wavelength);
      const double value = spectrum(wavelength) * light;
      for (unsigned c = 0; c < 3; ++c) {
        xyz[static_cast<int>(c)] += value * ((1.0 - t) * a[c] + t * b[c]);
      }
      y_of_one += light * ((1.0 - t) * a[1] + t * b[1]);
    }
  }
  return xyz / y_of_one;
}

}  // namespace

Vec3d xyz_to_rgb(const Vec3d& xyz) {
  return {3.240479 * xyz.x - 1.537150 * xyz.y - 0.498535 * xyz.z,
          -0.969256 * xyz.x + 1.875991 * xyz.y + 0.041556 * xyz.z,
          0.055648 * xyz.x - 0.204043 * xyz.y + 1.057311 * xyz.z};
}

Vec3d rgb_to_xyz(const Vec3d& rgb) {
  return {0.412453 * rgb.x + 0.357580 * rgb.y + 0.180423 * rgb.z,
          0.212671 * rgb.x + 0.715160 * rgb.y + 0.072169 * rgb.z,
          0.019334 * rgb.x + 0.119193 * rgb.y + 0.950227 * rgb.z};
}

namespace {

/// Calls `use` with the function of wavelength that connects the samples.
template <typename Use>
Vec3d with_samples(std::span<const double> wavelengths, std::span<const double> values,
                   const Use& use) {
  const std::size_t count = std::min(wavelengths.size(), values.size());
  if (count == 0) return {0.0, 0.0, 0.0};
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return wavelengths[a] < wavelengths[b]; });
  std::size_t next = 0;  // first sample beyond the wavelength, which only grows
  return use([&](double wavelength) {
    while (next < count && wavelengths[order[next]] <= wavelength) ++next;
    if (next == 0) return values[order[0]];
    if (next == count) return values[order[count - 1]];
    const std::size_t a = order[next - 1];
    const std::size_t b = order[next];
    const double t = (wavelength - wavelengths[a]) / (wavelengths[b] - wavelengths[a]);
    return (1.0 - t) * values[a] + t * values[b];
  });
}

}  // namespace

Vec3d sampled_to_xyz(std::span<const double> wavelengths, std::span<const double> values) {
  return with_samples(wavelengths, values,
                      [](const auto& spectrum) { return integrate(spectrum); });
}

Vec3d sampled_to_rgb_in_daylight(std::span<const double> wavelengths,
                                 std::span<const double> values) {
  const Vec3d xyz = with_samples(
      wavelengths, values, [](const auto& spectrum) { return integrate(spectrum, daylight); });
  // Our matrix and table differ in the fifth digit of white.
  const Vec3d white = xyz_to_rgb(integrate(equal_energy, daylight));
  const Vec3d rgb = xyz_to_rgb(xyz);
  return {rgb.x / white.x, rgb.y / white.y, rgb.z / white.z};
}

Vec3d sampled_to_rgb(std::span<const double> wavelengths, std::span<const double> values) {
  return xyz_to_rgb(sampled_to_xyz(wavelengths, values));
}

double blackbody_radiance(double wavelength_nm, double kelvin) {
  constexpr double kPlanck = 6.62606957e-34;
  constexpr double kLightSpeed = 299792458.0;
  constexpr double kBoltzmann = 1.3806488e-23;
  if (kelvin <= 0.0) return 0.0;
  const double wavelength = wavelength_nm * 1e-9;
  const double fifth = wavelength * wavelength * wavelength * wavelength * wavelength;
  return 2.0 * kPlanck * kLightSpeed * kLightSpeed /
         (fifth * std::expm1(kPlanck * kLightSpeed / (wavelength * kBoltzmann * kelvin)));
}

Vec3d blackbody_xyz(double kelvin) {
  if (kelvin <= 0.0) return {0.0, 0.0, 0.0};
  constexpr double kWien = 2.8977721e-3;  // m·K
  const double peak = blackbody_radiance(kWien / kelvin * 1e9, kelvin);
  if (!(peak > 0.0) || !std::isfinite(peak)) return {0.0, 0.0, 0.0};
  return integrate(
      [&](double wavelength) { return blackbody_radiance(wavelength, kelvin) / peak; });
}

Vec3d blackbody_rgb(double kelvin) {
  const Vec3d rgb = xyz_to_rgb(blackbody_xyz(kelvin));
  return {std::max(rgb.x, 0.0), std::max(rgb.y, 0.0), std::max(rgb.z, 0.0)};
}

}  // namespace ajar
