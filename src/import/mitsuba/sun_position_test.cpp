#include "import/mitsuba/sun_position.h"

#include <gtest/gtest.h>

#include <cmath>

#include "import/common/degree.h"

namespace ajar::mitsuba {
namespace {

constexpr double kTilt = 23.44;

SunTime noon_of(int month, int day, double latitude) {
  return {.year = 2010,
          .month = month,
          .day = day,
          .hour = 12.0,
          .latitude = latitude,
          .longitude = 0.0,
          .timezone = 0.0};
}

TEST(SunPosition, AtNoonFollowsTheSeasons) {
  // At the solstices the sun stands over the tropics, at the equinoxes over the equator. Noon is
  // off by the equation of time, up to 8 minutes on these days: little in height, and some in
  // azimuth.
  const auto height = [](int month, int day, double latitude) {
    return sun_position(noon_of(month, day, latitude)).zenith / kDegree;
  };
  EXPECT_NEAR(height(6, 21, 50.0), 50.0 - kTilt, 0.05);
  EXPECT_NEAR(height(12, 22, 50.0), 50.0 + kTilt, 0.05);
  EXPECT_NEAR(height(3, 20, 50.0), 50.0, 0.3);
  EXPECT_NEAR(sun_position(noon_of(6, 21, 50.0)).azimuth / kDegree, 180.0, 2.0);
  EXPECT_NEAR(std::cos(sun_position(noon_of(12, 22, -50.0)).azimuth), 1.0, 0.01) << "in the north";
}

TEST(SunPosition, RisesInTheEastAndKnowsTimeZones) {
  SunTime morning = noon_of(3, 20, 0.0);
  morning.hour = 6.0;
  EXPECT_NEAR(sun_position(morning).azimuth / kDegree, 90.0, 0.5);
  EXPECT_NEAR(sun_position(morning).zenith / kDegree, 90.0, 2.5);
  SunTime elsewhere = morning;
  elsewhere.hour = 15.0;
  elsewhere.timezone = 9.0;
  EXPECT_NEAR(sun_position(elsewhere).zenith, sun_position(morning).zenith, 1e-12);
  morning.hour = 5.0;
  morning.minute = 59.0;
  morning.second = 60.0;
  EXPECT_NEAR(sun_position(morning).zenith, sun_position(elsewhere).zenith, 1e-12);
}

}  // namespace
}  // namespace ajar::mitsuba
