#include "scene/shape/inputs.h"

namespace ajar {

ShapeModel disk_shape() {
  return {
      {.name = "disk",
       .summary = "a disk across z, with or without a hole",
       .source = source_of_quadrics(),
       .parameters = {declare::number("height", "0", "its z"), radius_input(),
                      declare::number("inner_radius", "0", "radius of the hole"), phi_max_input()}},
      [](const ShapeInputs& in) {
        return built(in, Quadric::disk(in.number("height"), in.number("radius"),
                                       in.number("inner_radius"), in.number("phi_max")));
      }};
}

}  // namespace ajar
