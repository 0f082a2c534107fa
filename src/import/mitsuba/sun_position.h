#pragma once

namespace ajar::mitsuba {

/// When and where; Mitsuba's defaults.
struct SunTime {
  int year = 2010, month = 7, day = 10;
  double hour = 15.0, minute = 0.0, second = 0.0;   ///< local time
  double latitude = 35.6894, longitude = 139.6917;  ///< degrees, to the north and to the east
  double timezone = 9.0;                            ///< hours ahead of UTC
};

/// Radians.
struct SunPosition {
  double zenith;
  double azimuth;  ///< from north toward east, in [0, 2π)
};

/// To half an arc minute for 1999 to 2015. Source: Blanco-Muriel et al. 2001, "Computing the solar
/// vector", whose algorithm Mitsuba uses.
SunPosition sun_position(const SunTime& time);

}  // namespace ajar::mitsuba
