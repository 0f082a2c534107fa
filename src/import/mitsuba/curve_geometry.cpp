#include <cmath>
#include <filesystem>

#include "core/printable_text.h"
#include "import/mitsuba/curve_file.h"
#include "import/mitsuba/geometry.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kNoCurves{Effect::Geometry, "curves cannot be read and are left out"};
constexpr WarningKind kReduction{Effect::Slight,
                                 "a share of hairs is to be left out: all of them are there"};

}  // namespace

std::optional<Geometry> make_curve_geometry(Arguments& arguments) {
  Context& context = arguments.context();
  const std::string& type = arguments.element().type;
  const bool is_hair = type == "hair";
  const std::string name = arguments.text("filename", "");
  const float hair_radius = is_hair ? arguments.number("radius", 0.025F) : 0.F;
  if (is_hair && arguments.number("reduction", 0.F) > 0.F) {
    context.warnings.add(kReduction, arguments.where(),
                         "\"reduction\" is not supported: all hairs are there");
  }
  arguments.accept({"angle_threshold"});
  const auto leave_out = [&](const std::string& reason) -> std::optional<Geometry> {
    context.warnings.add(kNoCurves, arguments.where(), "cannot use these curves: " + reason,
                         printable(name));
    return std::nullopt;
  };
  if (name.empty()) return leave_out("they have no \"filename\"");
  // Points move with the shape. Radii are in the world; that of hair grows as z does.
  const Mat4 to_world = arguments.transform("to_world").value_or(Mat4());
  Vec3d z;
  to_world.multDirMatrix(Vec3d(0.0, 0.0, 1.0), z);
  const auto hair_scale = static_cast<float>(z.length());
  const auto scale = static_cast<float>(std::cbrt(std::abs(to_world.determinant())));
  if (!(scale > 0.F) || !std::isfinite(1.F / scale)) {
    return leave_out("their transform cannot be inverted");
  }
  desc::Curves curves;
  try {
    FileAccess& files = context.files.files();
    const std::string path = files.resolve(context.files.find(name), arguments.where());
    CurveFile file = read_curve_file(files.load_text(path).view(), name, !is_hair);
    for (std::vector<CurvePoint>& curve : file) {
      for (CurvePoint& point : curve) {
        point.radius = (is_hair ? hair_radius * hair_scale : std::abs(point.radius)) / scale;
      }
    }
    curves = curves_of(file, type == "bsplinecurve" ? CurveKind::CubicSpline : CurveKind::Corners);
  } catch (const Error& error) {
    return leave_out(error.what());
  }
  if (curves.control_points.empty()) return leave_out("none of them has enough points");
  return Geometry{
      desc::shape_node("curves",
                       {{"type", std::string("cylinder")},
                        {"curves", std::make_shared<const desc::Curves>(std::move(curves))}}),
      Mat4(), true, std::filesystem::path(name).stem().string()};
}

}  // namespace ajar::mitsuba
