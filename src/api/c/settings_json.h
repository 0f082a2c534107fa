#pragma once
#include <string_view>

#include "ajar/render.h"

namespace ajar::c {

/// Settings of a JSON object whose members are called as those of `Settings`; the depths, the
/// window and the resolution are arrays. Raises UsageError for other members, with the nearest
/// name, and for values of other types.
v0::Settings settings_from_json(std::string_view json);

}  // namespace ajar::c
