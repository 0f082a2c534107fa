#include "import/mitsuba/sun_position.h"

#include <algorithm>
#include <cmath>

#include "import/common/degree.h"

namespace ajar::mitsuba {
namespace {

/// Hours of universal time.
double universal_hours(const SunTime& t) {
  return t.hour - t.timezone + (t.minute + t.second / 60.0) / 60.0;
}

/// Days since noon of 1 January 2000.
double days_since_2000(const SunTime& t) {
  const long long early = (static_cast<long long>(t.month) - 14) / 12;
  const long long day_number = 1461 * (t.year + 4800 + early) / 4 +
                               367 * (t.month - 2 - 12 * early) / 12 -
                               3 * ((t.year + 4900 + early) / 100) / 4 + t.day - 32075;
  return static_cast<double>(day_number) - 0.5 + universal_hours(t) / 24.0 - 2451545.0;
}

}  // namespace

SunPosition sun_position(const SunTime& t) {
  const double days = days_since_2000(t);
  // On the ecliptic.
  const double omega = 2.1429 - 0.0010394594 * days;
  const double anomaly = 6.2400600 + 0.0172019699 * days;
  const double longitude = 4.8950630 + 0.017202791698 * days + 0.03341607 * std::sin(anomaly) +
                           0.00034894 * std::sin(2.0 * anomaly) - 0.0001134 -
                           0.0000203 * std::sin(omega);
  const double obliquity = 0.4090928 - 6.2140e-9 * days + 0.0000396 * std::cos(omega);
  // On the sphere of the stars.
  const double ascension =
      std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude));
  const double declination = std::asin(std::sin(obliquity) * std::sin(longitude));
  // Directions are seen from the place.
  const double sidereal_hours = 6.6974243242 + 0.0657098283 * days + universal_hours(t);
  const double hour_angle = (sidereal_hours * 15.0 + t.longitude) * kDegree - ascension;
  const double latitude = t.latitude * kDegree;
  const double cosine = std::cos(latitude) * std::cos(hour_angle) * std::cos(declination) +
                        std::sin(declination) * std::sin(latitude);
  const double zenith = std::acos(std::clamp(cosine, -1.0, 1.0));
  const double azimuth =
      std::atan2(-std::sin(hour_angle), std::tan(declination) * std::cos(latitude) -
                                            std::sin(latitude) * std::cos(hour_angle));
  constexpr double kParallax = 6371.01 / 149597890.0;  // radius of the earth over its distance
  return {zenith + kParallax * std::sin(zenith), azimuth < 0.0 ? azimuth + 2.0 * M_PI : azimuth};
}

}  // namespace ajar::mitsuba
