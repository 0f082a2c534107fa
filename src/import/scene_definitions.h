#pragma once
#include <map>
#include <string>

namespace ajar {

/// Values, by name, of parameters that a scene leaves to the user, such as `$name` in files of
/// Mitsuba.
using SceneDefinitions = std::map<std::string, std::string>;

}  // namespace ajar
