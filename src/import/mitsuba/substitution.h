#pragma once
#include <map>
#include <string>
#include <string_view>

#include "core/error.h"

namespace ajar::mitsuba {

/// What `$name` stands for: from outside, or from `<default>` in the scene.
using Definitions = std::map<std::string, std::string>;

/// `text` with all `$name` replaced, of several fitting names by the longest; `\$` is a dollar
/// sign. Raises SceneError at `where` for names without a definition, and if the result is beyond
/// all measure.
std::string substitute(std::string_view text, const Definitions& definitions,
                       const SourceLocation& where);

}  // namespace ajar::mitsuba
