#pragma once
#include <map>
#include <string>

namespace ajar {

/// Values, by name, for what a scene leaves open to whoever renders it, such as `$name` in files of
/// Mitsuba.
using SceneDefinitions = std::map<std::string, std::string>;

}  // namespace ajar
