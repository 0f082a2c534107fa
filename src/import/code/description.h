#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/located_json.h"

namespace ajar::code {

/// JSON of a program. Places of values are those in the program, if an object around says "where",
/// with the name of their part: `room.py:12: shape "lamp": radius`. `name`: of the whole. Raises
/// SceneError, also for deeper nesting than any valid input has: readers may be recursive.
LocatedJson parse_description(std::string_view text, const std::string& name);

/// Raises SceneError if a part has another member than `known` (and "where").
void check_members(const LocatedJson& part, std::vector<std::string> known);

}  // namespace ajar::code
