#include "scene/shape/inputs.h"

namespace ajar {
namespace {

std::optional<Quadric> make_hyperboloid(const ShapeInputs& in) {
  const Vec3& p1 = in.node().vector("p1");
  const Vec3& p2 = in.node().vector("p2");
  // Our source swaps the ends in this case, which turns the normal around.
  if (p2.z == 0.F) return Quadric::ruled(p2, p1, in.number("phi_max"));
  return Quadric::ruled(p1, p2, in.number("phi_max"));
}

}  // namespace

ShapeModel hyperboloid_shape() {
  return {{.name = "hyperboloid",
           .summary = "what a line makes that turns around z",
           .source = source_of_quadrics(),
           .parameters = {declare::point("p1", "0 0 0", "one end of the line"),
                          declare::point("p2", "1 1 1", "the other end"), phi_max_input()}},
          [](const ShapeInputs& in) { return built(in, make_hyperboloid(in)); }};
}

}  // namespace ajar
