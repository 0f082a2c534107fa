#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "scene/desc/shape_data.h"

namespace ajar::mitsuba {

/// Points of curves, in the order of a file.
struct CurvePoint {
  Vec3 place;
  float radius = 0.F;  ///< 0 where the file has none
};
using CurveFile = std::vector<std::vector<CurvePoint>>;

/// Reads a file of curves: a line for each point, `x y z` with the radius behind if `has_radii`,
/// and empty lines between curves; or, without radii, the binary one that begins with BINARY_HAIR.
/// Raises SceneError, with `name` as its file, line and column, for numbers that are not finite,
/// and for files that end early. Sources: the documentation of "hair" of Mitsuba 0.6 and of
/// "bsplinecurve" of Mitsuba 3.
CurveFile read_curve_file(std::string_view bytes, const std::string& name, bool has_radii);

/// Meaning of the points of a curve.
enum class CurveKind { Corners, CubicSpline };
/// Curves of fewer than two corners, or four points of a spline, have no part that can be seen.
desc::Curves curves_of(const CurveFile& file, CurveKind kind);

}  // namespace ajar::mitsuba
