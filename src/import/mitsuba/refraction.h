#pragma once
#include <string_view>

#include "import/mitsuba/arguments.h"

namespace ajar::mitsuba {

/// An index of refraction: a number, or the name of a material. Without the parameter, that of the
/// material `fallback`. Raises SceneError if it is not positive.
float index_of_refraction(Arguments& arguments, std::string_view parameter,
                          std::string_view fallback);
/// Index of refraction of the inside of a surface relative to the outside, from "int_ior" and
/// "ext_ior". `interior` is the default of the first; that of the second is air.
float relative_index(Arguments& arguments, std::string_view interior);

}  // namespace ajar::mitsuba
