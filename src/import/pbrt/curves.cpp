#include <cmath>

#include "import/common/spline_segments.h"
#include "import/pbrt/shapes.h"
#include "scene/desc/models.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kCurvesLeftOut{Effect::Geometry, "curves are left out"};
constexpr WarningKind kNormals{
    Effect::Slight,
    "curves have normals \"N\", which are ignored: only those of \"ribbon\" have any"};

using Segment = CubicSegment<Vec3>;

/// Direction between two normals, at constant angular speed.
Vec3 between(float t, const Vec3& from, const Vec3& to) {
  const Vec3 a = normalize(from);
  const Vec3 b = normalize(to);
  const float angle = std::acos(std::clamp(dot(a, b), -1.F, 1.F));
  const float sine = std::sin(angle);
  if (!(sine > 1e-6F)) return a;
  return a * (std::sin((1.F - t) * angle) / sine) + b * (std::sin(t * angle) / sine);
}

}  // namespace

std::optional<desc::Node> make_curve(Context& context, const SourceLocation& where,
                                     const ParameterList& p) {
  const auto skip = [&](const std::string& reason) -> std::optional<desc::Node> {
    context.warnings.add(kCurvesLeftOut, where, reason + ": shape left out", reason);
    return std::nullopt;
  };
  desc::Curves curves;
  const float width = p.get_float("width", 1.F);
  const float width0 = p.get_float("width0", width);
  const float width1 = p.get_float("width1", width);
  const int degree = p.get_int("degree", 3);
  const std::string basis = p.get_string("basis", "bezier");
  const std::string type = p.get_string("type", "flat");
  const std::vector<Vec3> points = p.get_points("P");
  std::vector<Vec3> normals = p.get_normals("N");
  p.accept({"splitdepth"});

  if (degree != 2 && degree != 3)
    return skip("curves have degree 2 or 3, not " + std::to_string(degree));
  if (basis != "bezier" && basis != "bspline")
    fail_unknown(where, "curve basis", basis, {"bezier", "bspline"});
  if (type != "flat" && type != "cylinder" && type != "ribbon") {
    fail_unknown(where, "curve type", type, {"flat", "cylinder", "ribbon"});
  }
  const auto d = static_cast<std::size_t>(degree);
  const bool is_bezier = basis == "bezier";
  if (points.size() < d + 1 || (is_bezier && (points.size() - 1) % d != 0)) {
    return skip("a " + basis + " curve of degree " + std::to_string(degree) + " cannot have " +
                std::to_string(points.size()) + " control points");
  }
  const std::size_t segments = is_bezier ? (points.size() - 1) / d : points.size() - d;

  if (type == "ribbon") {
    if (normals.size() != segments + 1) {
      return skip("a ribbon of " + std::to_string(segments) + " segments needs " +
                  std::to_string(segments + 1) + " normals \"N\", not " +
                  std::to_string(normals.size()));
    }
    for (const Vec3& n : normals) {
      if (!(length_squared(n) > 0.F) || !std::isfinite(length_squared(n)))
        return skip("a normal has no direction");
    }
  } else if (!normals.empty()) {
    context.warnings.add(kNormals, where,
                         "only curves of type \"ribbon\" have normals: \"N\" ignored");
    normals.clear();
  }

  for (std::size_t s = 0; s < segments; ++s) {
    const Vec3* first = &points[is_bezier ? s * d : s];
    Segment segment;
    if (is_bezier) {
      segment = degree == 3 ? Segment{first[0], first[1], first[2], first[3]}
                            : elevated(first[0], first[1], first[2]);
    } else {
      segment = degree == 3 ? cubic_spline_segment(first) : quadratic_spline_segment(first);
    }
    const auto count = static_cast<float>(segments);
    const float start = lerp(static_cast<float>(s) / count, width0, width1);
    const float end = lerp(static_cast<float>(s + 1) / count, width0, width1);
    for (std::size_t i = 0; i < 4; ++i) {
      const float t = static_cast<float>(i) / 3.F;
      curves.control_points.push_back(segment[i]);
      curves.widths.push_back(lerp(t, start, end));
      if (normals.empty()) continue;
      curves.normals.push_back(i == 0   ? normals[s]
                               : i == 3 ? normals[s + 1]
                                        : between(t, normals[s], normals[s + 1]));
    }
  }
  return desc::shape_node(
      "curves",
      {{"type", type}, {"curves", std::make_shared<const desc::Curves>(std::move(curves))}});
}

}  // namespace ajar::pbrt
