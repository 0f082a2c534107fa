#include "scene/shape/inputs.h"

namespace ajar {
namespace {

DiskCoordinates coordinates_of(const desc::Node& node) {
  const std::string& name = node.text("coordinates");
  if (name == "radius_then_angle") return DiskCoordinates::RadiusThenAngle;
  return name == "angle_then_radius" ? DiskCoordinates::AngleThenRadius
                                     : DiskCoordinates::AngleThenRadiusInward;
}

}  // namespace

ShapeModel disk_shape() {
  return {
      {.name = "disk",
       .summary = "a disk across z, with or without a hole",
       .source = source_of_quadrics(),
       .parameters = {declare::number("height", "0", "its z"), radius_input(),
                      declare::number("inner_radius", "0", "radius of the hole"), phi_max_input(),
                      choice_parameter(
                          "coordinates",
                          {"angle_then_radius_inward", "radius_then_angle", "angle_then_radius"},
                          "what u and v of textures are: shares of phi_max and of the way from the "
                          "hole to the rim, or back")}},
      [](const ShapeInputs& in) {
        return built(
            in, Quadric::disk(in.number("height"), in.number("radius"), in.number("inner_radius"),
                              in.number("phi_max"), coordinates_of(in.node())));
      }};
}

}  // namespace ajar
