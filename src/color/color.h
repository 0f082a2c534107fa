#pragma once
#include <span>

#include "core/vector.h"

/// From spectra to linear Rec. 709 RGB by the CIE 1931 2° observer.
namespace ajar {

/// Linear Rec. 709 RGB (D65) of CIE XYZ, and back. Source: ITU-R BT.709; the rounding is pbrt-v3's
/// (section 5.2.2), so that colours agree to the last digits.
Vec3d xyz_to_rgb(const Vec3d& xyz);
Vec3d rgb_to_xyz(const Vec3d& rgb);

/// CIE XYZ of a spectrum given at wavelengths in nm (any order), linear between samples and
/// constant beyond the ends. Normalised such that the spectrum that is 1 everywhere has Y = 1.
/// Empty input gives 0.
Vec3d sampled_to_xyz(std::span<const double> wavelengths, std::span<const double> values);
/// Conversion to linear RGB; lanes may be negative for colours outside of the gamut.
Vec3d sampled_to_rgb(std::span<const double> wavelengths, std::span<const double> values);

/// Linear RGB of a spectrum under daylight (CIE illuminant D65), for a reflectance or an index of
/// refraction: the spectrum that is 1 everywhere is white.
Vec3d sampled_to_rgb_in_daylight(std::span<const double> wavelengths,
                                 std::span<const double> values);

/// Spectral radiance of a black body, W·sr⁻¹·m⁻² per m of wavelength (Planck's law).
double blackbody_radiance(double wavelength_nm, double kelvin);
/// XYZ of a black body, scaled such that the peak of its spectrum is 1 (pbrt-v3, section 12.1.1).
Vec3d blackbody_xyz(double kelvin);
/// Linear RGB, with lanes outside of the gamut clamped to 0. Zero for kelvin ≤ 0.
Vec3d blackbody_rgb(double kelvin);

}  // namespace ajar
