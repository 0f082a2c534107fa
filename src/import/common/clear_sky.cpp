#include "import/common/clear_sky.h"

#include <algorithm>
#include <cmath>

#include "color/color.h"
#include "color/daylight.h"
#include "import/common/degree.h"
#include "import/common/transforms.h"
#include "scene/desc/models.h"

namespace ajar {
namespace {

/// Units of the light `sky`.
constexpr double kLeastTurbidity = 2.0;
constexpr double kMostTurbidity = 10.0;

double turbidity_of(const Daylight& daylight) {
  return std::clamp(daylight.turbidity, kLeastTurbidity, kMostTurbidity);
}

float finite(double value) { return static_cast<float>(std::clamp(value, 0.0, 1e30)); }

/// z is up, and the sun over x.
Mat4 place_of(const Daylight& daylight) {
  const Vec3d z = daylight.up.normalized();
  Vec3d x = daylight.to_sun - z * z.dot(daylight.to_sun);
  if (x.length() < 1e-9 * daylight.to_sun.length()) {
    x = std::abs(z.x) < 0.9 ? Vec3d(1.0, 0.0, 0.0) : Vec3d(0.0, 1.0, 0.0);
    x -= z * z.dot(x);
  }
  x.normalize();
  const Vec3d y = z.cross(x);
  return {x.x, x.y, x.z, 0.0, y.x, y.y, y.z, 0.0, z.x, z.y, z.z, 0.0, 0.0, 0.0, 0.0, 1.0};
}

}  // namespace

const double kRadiancePerKilocandela = 1e3 / kLumensPerEvenWatt;

double Daylight::elevation() const {
  return std::asin(std::clamp(up.normalized().dot(to_sun.normalized()), -1.0, 1.0)) / kDegree;
}

std::optional<desc::Light> sky_light(const SourceLocation& where, const Daylight& daylight,
                                     double scale) {
  const double elevation = daylight.elevation();
  if (elevation < 0.0) return std::nullopt;
  return desc::Light{
      .where = where,
      .to_world = place_of(daylight),
      .node = desc::light_node("sky", {{"turbidity", static_cast<float>(turbidity_of(daylight))},
                                       {"elevation", static_cast<float>(elevation)},
                                       {"scale", finite(kRadiancePerKilocandela * scale)}})};
}

std::optional<desc::Light> sun_light(const SourceLocation& where, const Daylight& daylight,
                                     double scale) {
  const double elevation = daylight.elevation();
  const std::optional<Mat4> place = z_to(daylight.to_sun);
  if (elevation < 0.0 || !place) return std::nullopt;
  const Vec3d rgb =
      xyz_to_rgb(sun_illuminance(turbidity_of(daylight), (90.0 - elevation) * kDegree)) *
      (kRadiancePerKilocandela * scale);
  return desc::Light{
      .where = where,
      .to_world = *place,
      .node = desc::light_node(
          "distant", {{"irradiance", Vec3(finite(rgb.x), finite(rgb.y), finite(rgb.z))}})};
}

}  // namespace ajar
