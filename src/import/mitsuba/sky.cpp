#include <algorithm>
#include <cmath>

#include "import/common/transforms.h"
#include "import/mitsuba/lights.h"
#include "import/mitsuba/node_maker.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kSky{
    Effect::Light,
    "skies are not supported: a sky of one brightness and a sun of about the right "
    "strength stand in"};

/// Mitsuba's radiance is per nanometre: that of an even spectrum of so many candela per square
/// metre is 1 / (683 lm/W · ∫ ȳ dλ).
constexpr double kPerCandela = 1.0 / (683.0 * 106.857);
/// Where the sun is, unless the scene says so.
constexpr double kElevation = 45.0;  // degrees

/// Unit vector to the sun, in the space of the emitter.
Vec3d direction_to_sun(Arguments& arguments, bool z_is_up) {
  const std::optional<Vec3d> given = arguments.vector("sun_direction");
  if (given && given->length() > 0.0) return given->normalized();
  const double height = std::sin(kElevation * M_PI / 180.0);
  const double away = std::cos(kElevation * M_PI / 180.0);
  return z_is_up ? Vec3d(0.0, -away, height) : Vec3d(0.0, height, -away);
}

/// Luminance of a clear sky at the zenith, cd/m². Source: Preetham et al. 1999, A practical
/// analytic model for daylight, appendix A.2.
double zenith_luminance(double turbidity, double zenith_angle) {
  const double chi = (4.0 / 9.0 - turbidity / 120.0) * (M_PI - 2.0 * zenith_angle);
  const double kilo = (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192;
  return std::max(kilo, 0.1) * 1000.0;
}

/// Illuminance of the sun on a surface that faces it, lx. Source: IESNA Lighting Handbook, 9th
/// edition, chapter 8: clear sky.
double sun_illuminance(double cosine) {
  constexpr double kExtinction = 0.21;
  return 127500.0 * std::exp(-kExtinction / std::max(cosine, 0.05));
}

}  // namespace

void add_sun_and_sky(Context& context, Arguments& arguments) {
  const std::string& type = arguments.element().type;
  const Mat4 to_world = arguments.transform("to_world").value_or(Mat4());
  const bool z_is_up = context.document.major_version >= 3;
  const Vec3d sun = direction_to_sun(arguments, z_is_up);
  const double cosine = std::clamp(z_is_up ? sun.z : sun.y, 0.0, 1.0);
  const double turbidity = arguments.number("turbidity", 3.F);
  const double scale = arguments.number("scale", 1.F);
  const double sun_scale = arguments.number("sun_scale", 1.F) * scale;
  const double sky_scale = arguments.number("sky_scale", 1.F) * scale;
  arguments.accept_all();
  context.warnings.add(kSky, arguments.where(),
                       "emitter \"" + type +
                           "\" is not supported: a sky of one brightness, a sun of about the right "
                           "strength, or both stand in",
                       type);
  const auto add = [&](std::string_view model, const char* parameter, const Vec3& value,
                       const Mat4& place) {
    context.scene.lights.push_back({arguments.where(), place,
                                    make_node(context, arguments.where(), desc::ModelKind::Light,
                                              model, {{parameter, value}})});
  };
  if (type != "sun") {
    const double luminance = zenith_luminance(turbidity, std::acos(cosine)) * sky_scale;
    const Vec3 blue(0.7F, 0.97F, 1.6F);  // of luminance 1, about the colour of a clear sky
    add("environment", "radiance", blue * static_cast<float>(luminance * kPerCandela), Mat4());
  }
  if (type != "sky" && cosine > 0.0) {
    Vec3d toward(0.0);
    to_world.multDirMatrix(sun, toward);
    const Vec3 yellow(1.1F, 0.99F, 0.8F);  // the same for the sun
    const std::optional<Mat4> place = z_to(toward);
    if (!place) return;
    add("distant", "irradiance",
        yellow * static_cast<float>(sun_illuminance(cosine) * kPerCandela * sun_scale), *place);
  }
}

}  // namespace ajar::mitsuba
