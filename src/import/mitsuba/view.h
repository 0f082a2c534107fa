#pragma once
#include <string>

#include "import/mitsuba/arguments.h"

namespace ajar::mitsuba {

/// The angle that a sensor or a projector sees.
struct GivenView {
  double fov;        ///< degrees
  std::string axis;  ///< its axis: "x", "y", "diagonal", "shorter" or "longer"
};

/// From "fov" and "fov_axis", or from "focal_length". Raises SceneError for invalid angles.
GivenView read_view(Arguments& arguments);

}  // namespace ajar::mitsuba
