#include "scene/shape/inputs.h"

namespace ajar {
namespace {

std::optional<Quadric> make_cone(const ShapeInputs& in) {
  const float radius = in.number("radius");
  if (!(radius > 0.F)) return {};
  return Quadric::ruled({radius, 0.F, 0.F}, {0.F, 0.F, in.number("height")}, in.number("phi_max"));
}

}  // namespace

ShapeModel cone_shape() {
  return {{.name = "cone",
           .summary = "a cone from the plane z = 0 to its tip",
           .source = source_of_quadrics(),
           .parameters = {radius_input(), declare::number("height", "1", "z of the tip"),
                          phi_max_input()}},
          [](const ShapeInputs& in) { return built(in, make_cone(in)); }};
}

}  // namespace ajar
