#include "scene/shape/inputs.h"

namespace ajar {

ShapeModel paraboloid_shape() {
  return {{.name = "paraboloid",
           .summary = "a bowl around z with its lowest point at the origin",
           .source = source_of_quadrics(),
           .parameters = {radius_input(), declare::number("z_min", "0", "lower end"),
                          declare::number("z_max", "1", "upper end, where it has its radius"),
                          phi_max_input()}},
          [](const ShapeInputs& in) {
            return built(in, Quadric::paraboloid(in.number("radius"), in.number("z_min"),
                                                 in.number("z_max"), in.number("phi_max")));
          }};
}

}  // namespace ajar
