#include "import/mitsuba/view.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/printable_text.h"
#include "import/common/degree.h"
#include "import/mitsuba/numbers.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kTwoAngles{
    Effect::None, "sensors have a field of view and a focal length: the former counts"};
constexpr WarningKind kAxis{Effect::Light, "fov axes are unknown: that of x stands in"};

/// Diagonal of a film of 36 mm × 24 mm.
double angle_of_lens(Arguments& arguments) {
  std::string text = arguments.text("focal_length", "50mm");
  if (text.ends_with("mm")) text.resize(text.size() - 2);
  const std::optional<double> focal_length = parse_number(text);
  if (!focal_length || !(*focal_length > 0.0)) {
    throw SceneError(arguments.where(), "\"focal_length\" must be a length as in \"50mm\"");
  }
  return 2.0 * std::atan(0.5 * std::hypot(36.0, 24.0) / *focal_length) / kDegree;
}

std::string read_axis(Arguments& arguments) {
  static const std::vector<std::string> kAxes = {"x", "y", "diagonal", "smaller", "larger"};
  const std::string axis = arguments.word("fov_axis", "x");
  if (axis == "smaller") return "shorter";
  if (axis == "larger") return "longer";
  if (std::find(kAxes.begin(), kAxes.end(), axis) != kAxes.end()) return axis;
  arguments.context().warnings.add(
      kAxis, arguments.where(),
      unknown_name_message("fov axis", printable(axis), kAxes) + ". x stands in");
  return "x";
}

}  // namespace

GivenView read_view(Arguments& arguments) {
  const std::string axis = read_axis(arguments);
  const std::optional<double> fov = arguments.number("fov");
  if (!fov) return {angle_of_lens(arguments), "diagonal"};
  if (arguments.has("focal_length")) {
    arguments.accept({"focal_length"});
    arguments.context().warnings.add(
        kTwoAngles, arguments.where(),
        "this has a field of view and a focal length: the former counts");
  }
  if (!(*fov > 0.0 && *fov < 180.0)) {
    throw SceneError(arguments.where(), "\"fov\" must be between 0 and 180 degrees");
  }
  return {*fov, axis};
}

}  // namespace ajar::mitsuba
