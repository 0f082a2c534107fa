#include <algorithm>
#include <cmath>

#include "import/common/clear_sky.h"
#include "import/common/transforms.h"
#include "import/mitsuba/lights.h"
#include "import/mitsuba/sun_position.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kSky{Effect::Light,
                           "skies are those of Preetham et al., not of Hosek and Wilkie"};
constexpr WarningKind kSun{Effect::Slight, "suns are points: shadows are sharp"};
constexpr WarningKind kTurbidity{Effect::Light, "skies have a turbidity that the model has not"};
constexpr WarningKind kStretched{Effect::Light,
                                 "skies go on below the horizon, which is not supported"};
constexpr WarningKind kNight{Effect::Light, "suns are below the horizon: there is no light"};
constexpr WarningKind kNoPlace{Effect::Light, "skies have a transform without inverse: left out"};

SunTime read_time(Arguments& arguments) {
  SunTime time;
  const auto whole = [&](const char* name, int& value) {
    constexpr long long kMost = 100000;
    const std::optional<long long> given = arguments.integer(name);
    if (given) value = static_cast<int>(std::clamp(*given, -kMost, kMost));
  };
  const auto number = [&](const char* name, double& value) {
    const std::optional<double> given = arguments.number(name);
    if (given && std::abs(*given) < 1e6) value = *given;
  };
  whole("year", time.year);
  whole("month", time.month);
  whole("day", time.day);
  number("hour", time.hour);
  number("minute", time.minute);
  number("second", time.second);
  number("latitude", time.latitude);
  number("longitude", time.longitude);
  number("timezone", time.timezone);
  return time;
}

/// In the space of the emitter: east is +x and north −z in Mitsuba 0.x, whose up is y; north is −x
/// and east −y in Mitsuba 3, whose up is z. Source: sunmodel.h of the one, sunsky.h of the other.
Vec3d direction_of(const SunPosition& sun, bool z_is_up) {
  const double north = std::sin(sun.zenith) * std::cos(sun.azimuth);
  const double east = std::sin(sun.zenith) * std::sin(sun.azimuth);
  const double up = std::cos(sun.zenith);
  return z_is_up ? Vec3d(-north, -east, up) : Vec3d(east, up, -north);
}

/// Sky of the world. "sun_direction" is in world space, whatever the transform.
Daylight read_daylight(Arguments& arguments, bool z_is_up, const Mat4& to_world) {
  Daylight daylight;
  daylight.turbidity = arguments.number("turbidity", 3.F);
  to_world.multDirMatrix(z_is_up ? Vec3d(0.0, 0.0, 1.0) : Vec3d(0.0, 1.0, 0.0), daylight.up);
  const SunTime time = read_time(arguments);
  const std::optional<Vec3d> given = arguments.vector("sun_direction");
  if (given && given->length() > 0.0) {
    daylight.to_sun = *given;
  } else {
    to_world.multDirMatrix(direction_of(sun_position(time), z_is_up), daylight.to_sun);
  }
  return daylight;
}

void warn(Context& context, Arguments& arguments, const Daylight& daylight) {
  const std::string& type = arguments.element().type;
  const auto add = [&](const WarningKind& kind, const std::string& message) {
    context.warnings.add(kind, arguments.where(), message, type);
  };
  if (type != "sun") {
    add(kSky,
        "the sky is that of Preetham et al. 1999, without light from the ground: near that of "
        "Hosek and Wilkie");
  }
  if (type != "sky") add(kSun, "the sun is a point: shadows are sharp, and it is not seen");
  if (!(daylight.turbidity >= 2.0 && daylight.turbidity <= 10.0)) {
    add(kTurbidity, "this turbidity is not supported: the nearest from 2 to 10 stands in");
  }
  if (arguments.number("stretch", 1.F) != 1.F || arguments.flag("extend", false)) {
    add(kStretched, "a sky below the horizon is not supported: it is black there");
  }
}

}  // namespace

void add_sun_and_sky(Context& context, Arguments& arguments) {
  const std::string& type = arguments.element().type;
  const Mat4 to_world = arguments.transform("to_world").value_or(Mat4());
  const Daylight daylight = read_daylight(arguments, context.document.major_version >= 3, to_world);
  const double scale = arguments.number("scale", 1.F);
  const double sun_scale = arguments.number("sun_scale", 1.F) * scale;
  const double sky_scale = arguments.number("sky_scale", 1.F) * scale;
  warn(context, arguments, daylight);
  // Options of the sun's disk, of the ground, and of the computation of both.
  arguments.accept({"sun_radius_scale", "sun_aperture", "albedo", "resolution", "sampling_weight",
                    "complex_sun"});
  if (!inverse(to_world) || !(daylight.to_sun.length() > 0.0)) {
    context.warnings.add(kNoPlace, arguments.where(),
                         "the transform of this light cannot be inverted: left out");
    return;
  }
  if (daylight.elevation() < 0.0) {
    context.warnings.add(kNight, arguments.where(), "the sun is below the horizon: left out");
    return;
  }
  const auto add = [&](std::optional<desc::Light> light) {
    if (light) context.scene.lights.push_back(std::move(*light));
  };
  if (type != "sun") add(sky_light(arguments.where(), daylight, sky_scale));
  if (type != "sky") add(sun_light(arguments.where(), daylight, sun_scale));
}

}  // namespace ajar::mitsuba
