#include "scene/shape/inputs.h"

namespace ajar {
namespace {

constexpr std::uint64_t kTreeBytesPerSegment = 300;  // memory of Embree; a bound, not measured

CurveShape::Type type_of(const desc::Node& node) {
  if (node.text("type") == "cylinder") return CurveShape::Type::Cylinder;
  return node.text("type") == "ribbon" ? CurveShape::Type::Ribbon : CurveShape::Type::Flat;
}

BuiltShape make_curves(const ShapeInputs& in) {
  const desc::CurvesPointer curves = in.take_curves("curves");
  if (!curves || curves->control_points.empty()) return {};
  return std::make_unique<const CurveShape>(type_of(in.node()), *curves, in.placement(),
                                            in.reversed(), in.where());
}

}  // namespace

ShapeModel curves_shape() {
  return {{.name = "curves",
           .summary = "hair and wires: cubic Bézier curves with widths; they cannot emit light",
           .source = "",
           .parameters = {choice_parameter("type", {"flat", "cylinder", "ribbon"},
                                           "what a ray meets: a band that faces it, a tube, or a "
                                           "band across given normals"),
                          declare::curves("curves", "control points, widths; ribbons: normals")}},
          make_curves,
          [](const desc::Shape& shape) {
            const desc::CurvesPointer& curves = shape.node.curves("curves");
            return curves ? curves->control_points.size() / 4 * kTreeBytesPerSegment : 0;
          }};
}

}  // namespace ajar
