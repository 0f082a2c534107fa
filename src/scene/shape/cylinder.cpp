#include <algorithm>

#include "scene/shape/inputs.h"

namespace ajar {
namespace {

std::optional<Quadric> make_cylinder(const ShapeInputs& in) {
  const float radius = in.number("radius");
  const float low = std::min(in.number("z_min"), in.number("z_max"));
  const float high = std::max(in.number("z_min"), in.number("z_max"));
  if (!(radius > 0.F)) return {};
  return Quadric::ruled({radius, 0.F, low}, {radius, 0.F, high}, in.number("phi_max"));
}

}  // namespace

ShapeModel cylinder_shape() {
  return {{.name = "cylinder",
           .summary = "a cylinder around z, without lids",
           .source = source_of_quadrics(),
           .parameters = {radius_input(), declare::number("z_min", "-1", "lower end"),
                          declare::number("z_max", "1", "upper end"), phi_max_input()}},
          [](const ShapeInputs& in) { return built(in, make_cylinder(in)); }};
}

}  // namespace ajar
