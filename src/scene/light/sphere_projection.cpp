#include "scene/light/sphere_projection.h"

namespace ajar {
namespace {

constexpr const char* kEqualArea = "equal_area";

float lat_long_solid_angle(const Vec2& uv) { return 2.F * kPi * kPi * std::sin(kPi * uv.y); }
float equal_area_solid_angle(const Vec2& /*uv*/) { return 4.F * kPi; }

}  // namespace

const SphereProjection& sphere_projection(std::string_view name) {
  static constexpr SphereProjection kLatLong = {lat_long::to_uv, lat_long::to_direction,
                                                lat_long_solid_angle, MapEdge::Repeat,
                                                MapFilter::Bilinear};
  // Texels without interpolation, which would need the neighbours beyond the folds.
  static constexpr SphereProjection kSquare = {equal_area::to_uv, equal_area::to_direction,
                                               equal_area_solid_angle, MapEdge::Clamp,
                                               MapFilter::Nearest};
  return name == kEqualArea ? kSquare : kLatLong;
}

ParameterSpec sphere_projection_input() {
  return choice_parameter("projection", {"longitude_latitude", kEqualArea},
                          "of the image: rows of one latitude, or a square with the pole in the "
                          "middle");
}

}  // namespace ajar
