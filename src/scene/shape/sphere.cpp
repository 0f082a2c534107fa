#include "scene/shape/inputs.h"

namespace ajar {

ShapeModel sphere_shape() {
  return {{.name = "sphere",
           .summary = "a sphere around the origin",
           .source = source_of_quadrics(),
           .parameters = {radius_input(),
                          declare::number("z_min", "", "lower end; without it, the sphere's"),
                          declare::number("z_max", "", "upper end; without it, the sphere's"),
                          phi_max_input()}},
          [](const ShapeInputs& in) {
            const float radius = in.number("radius");
            return built(in, Quadric::sphere(radius, in.number_if_given("z_min").value_or(-radius),
                                             in.number_if_given("z_max").value_or(radius),
                                             in.number("phi_max")));
          }};
}

}  // namespace ajar
