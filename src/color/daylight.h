#pragma once
#include "core/vector.h"

/// The clear sky and the sun, in closed form, as CIE XYZ. Source: Preetham, Shirley and Smits 1999,
/// "A practical analytic model for daylight".
namespace ajar {

/// Lumens of a spectrum that is 1 W/nm everywhere: 683 lm/W times the integral of CIE ȳ, in nm.
inline constexpr double kLumensPerEvenWatt = 683.0 * 106.857;

/// The sky above the horizon. `turbidity` says how hazy it is: 2 is clear, 10 all but fog. The
/// model was fitted from 2 to 6.
class ClearSky {
 public:
  /// Angle of the sun from the zenith in radians, from 0 to π/2.
  ClearSky(double turbidity, double sun_zenith);

  /// Luminance as XYZ, kcd/m². `zenith` and `from_sun` are the angles from the zenith (below π/2)
  /// and from the sun, in radians. Equations 3 and 4.
  Vec3d luminance(double zenith, double from_sun) const;

 private:
  /// F of equation 3.
  struct Distribution {
    double a, b, c, d, e;
    double at(double zenith, double from_sun) const;
  };
  /// Y and the chromaticities x and y: their distributions, and their values over F in the zenith.
  Distribution distributions_[3];
  double scales_[3];
};

/// The clear sky over z, with the sun over x, as linear RGB.
class SunnySky {
 public:
  /// `elevation` of the sun over the horizon, degrees, from 0 to 90.
  SunnySky(double turbidity, double elevation);
  /// Colour of 1 for 1 kcd/m², in a unit direction; black below the horizon.
  Vec3d color(const Vec3d& w) const;

 private:
  double sun_zenith_;
  ClearSky sky_;
};

/// Illuminance by the sun as XYZ, klx, on a surface that faces it; `zenith` as above, smaller than
/// π/2. Appendix A.1, of which the oxygen and the water vapour, which absorb beyond 680 nm, are
/// left out; the sun above the atmosphere is a black body of 5778 K.
Vec3d sun_illuminance(double turbidity, double zenith);

}  // namespace ajar
