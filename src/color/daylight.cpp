#include "color/daylight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "color/cie_1931.h"
#include "color/cie_illuminants.h"
#include "color/color.h"

namespace ajar {
namespace {

/// Values of the zenith, eq. 2 of appendix A.2: a polynomial of the sun's angle per power of the
/// turbidity, the highest first.
using Polynomials = std::array<std::array<double, 4>, 3>;
constexpr Polynomials kZenithX = {{{0.00166, -0.00375, 0.00209, 0.0},
                                   {-0.02903, 0.06377, -0.03202, 0.00394},
                                   {0.11693, -0.21196, 0.06052, 0.25886}}};
constexpr Polynomials kZenithY = {{{0.00275, -0.00610, 0.00317, 0.0},
                                   {-0.04214, 0.08970, -0.04153, 0.00516},
                                   {0.15346, -0.26756, 0.06670, 0.26688}}};

double chromaticity_in_zenith(const Polynomials& rows, double turbidity, double sun) {
  double value = 0.0;
  for (const auto& row : rows) {
    value = value * turbidity + ((row[0] * sun + row[1]) * sun + row[2]) * sun + row[3];
  }
  return value;
}

/// kcd/m².
double luminance_in_zenith(double turbidity, double sun) {
  const double chi = (4.0 / 9.0 - turbidity / 120.0) * (M_PI - 2.0 * sun);
  return (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192;
}

/// Absorption by ozone, 1/cm, from 440 nm in steps of 20 nm. Source: Preetham et al. 1999, table 2,
/// after Iqbal 1983, "An introduction to solar radiation".
constexpr double kOzoneFirst = 440.0;
constexpr double kOzoneStep = 20.0;
constexpr std::array<double, 18> kOzone = {0.002, 0.006, 0.014, 0.030, 0.048, 0.075,
                                           0.103, 0.120, 0.125, 0.105, 0.079, 0.057,
                                           0.036, 0.023, 0.014, 0.010, 0.007, 0.0};

double ozone_absorption(double wavelength) {
  const double place = (wavelength - kOzoneFirst) / kOzoneStep;
  if (place <= 0.0 || place >= static_cast<double>(kOzone.size() - 1)) return 0.0;
  const auto i = static_cast<std::size_t>(place);
  const double rest = place - static_cast<double>(i);
  return kOzone[i] * (1.0 - rest) + kOzone[i + 1] * rest;
}

/// Share of light of a wavelength (nm) that comes through `mass` atmospheres.
double transmittance(double wavelength, double turbidity, double mass) {
  constexpr double kOzoneColumn = 0.35;   // cm
  constexpr double kParticleSizes = 1.3;  // Ångström's exponent
  const double micrometres = wavelength * 1e-3;
  const double rayleigh = 0.008735 * std::pow(micrometres, -4.08);
  const double haze = (0.04608 * turbidity - 0.04586) * std::pow(micrometres, -kParticleSizes);
  return std::exp(-mass * (rayleigh + haze + kOzoneColumn * ozone_absorption(wavelength)));
}

}  // namespace

double ClearSky::Distribution::at(double zenith, double from_sun) const {
  const double cosine = std::cos(from_sun);
  // Towards the horizon the first factor tends to 1.
  const double height = std::max(std::cos(zenith), 1e-4);
  return (1.0 + a * std::exp(b / height)) *
         (1.0 + c * std::exp(d * from_sun) + e * cosine * cosine);
}

ClearSky::ClearSky(double t, double sun_zenith)
    : distributions_{{0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251,
                      0.1206 * t - 2.5771, -0.0670 * t + 0.3703},
                     {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125,
                      -0.0641 * t - 0.8989, -0.0033 * t + 0.0452},
                     {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102,
                      -0.0441 * t - 1.6537, -0.0109 * t + 0.0529}},
      scales_{luminance_in_zenith(t, sun_zenith), chromaticity_in_zenith(kZenithX, t, sun_zenith),
              chromaticity_in_zenith(kZenithY, t, sun_zenith)} {
  for (int i = 0; i < 3; ++i) scales_[i] /= distributions_[i].at(0.0, sun_zenith);
}

Vec3d ClearSky::luminance(double zenith, double from_sun) const {
  double values[3];
  for (int i = 0; i < 3; ++i) values[i] = scales_[i] * distributions_[i].at(zenith, from_sun);
  return chromaticity_to_xyz(values[1], values[2]) * std::max(values[0], 0.0);
}

Vec3d sun_illuminance(double turbidity, double zenith) {
  constexpr double kKelvin = 5778.0;
  constexpr double kRadius = 0.2665 * M_PI / 180.0;
  constexpr double kPerNanometre = 1e-9;
  const double solid_angle = M_PI * std::sin(kRadius) * std::sin(kRadius);
  // Kasten 1966.
  const double mass =
      1.0 / (std::cos(zenith) + 0.15 * std::pow(93.885 - zenith * 180.0 / M_PI, -1.253));
  std::vector<double> wavelengths, values;
  for (int i = 0; i < kCieSamples; ++i) {
    const double wavelength = kCieFirst + i * kCieStep;
    wavelengths.push_back(wavelength);
    values.push_back(blackbody_radiance(wavelength, kKelvin) * kPerNanometre * solid_angle *
                     transmittance(wavelength, turbidity, mass));
  }
  return sampled_to_xyz(wavelengths, values) * (kLumensPerEvenWatt * 1e-3);
}

SunnySky::SunnySky(double turbidity, double elevation)
    : sun_zenith_((90.0 - elevation) * M_PI / 180.0), sky_(turbidity, sun_zenith_) {}

Vec3d SunnySky::color(const Vec3d& w) const {
  if (w.z <= 0.0) return Vec3d(0.0);
  const Vec3d sun(std::sin(sun_zenith_), 0.0, std::cos(sun_zenith_));
  const Vec3d rgb = xyz_to_rgb(
      sky_.luminance(std::acos(std::min(w.z, 1.0)), std::acos(std::clamp(w.dot(sun), -1.0, 1.0))));
  return {std::max(rgb.x, 0.0), std::max(rgb.y, 0.0), std::max(rgb.z, 0.0)};
}

}  // namespace ajar
