#pragma once
#include <string>
#include <string_view>

#include "scene/desc/scene_desc.h"

namespace ajar {

/// `NAME` or `NAME:RADIUS` → a filter of the film, RADIUS in pixels, above 0 and at most 64,
/// without it as pbrt-v3 has it: 0.5 for box, 4 for sinc, 2 for the others. Raises UsageError that
/// names the option and shows how to write it.
desc::Filter parse_filter(const std::string& option, std::string_view text);

}  // namespace ajar
