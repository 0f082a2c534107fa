#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "import/mitsuba/document.h"

namespace ajar::mitsuba {

/// The types of plugins that are read, by the tag of their element; empty for other tags. Others
/// are unknown to their reader, too.
const std::vector<std::string>& plugin_types(std::string_view tag);

bool is_known(const Element& element);

/// "unknown bsdf "difuse"; did you mean "diffuse"? Valid: …".
std::string unknown_type_message(const Element& element);

}  // namespace ajar::mitsuba
