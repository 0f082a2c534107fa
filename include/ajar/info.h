#pragma once
#include <string>
#include <vector>

#include "ajar/namespace.h"

namespace ajar::AJAR_INTERFACE {
/// Version of the library, such as "0.2.0".
std::string version();

/// Something to choose from, with one line about it.
struct Choice {
  std::string name;
  std::string summary;
};
/// Names for `Settings::integrator`.
std::vector<Choice> integrators();
/// Names for `Scene::load`, with their "builtin:".
std::vector<Choice> builtin_scenes();
}  // namespace ajar::AJAR_INTERFACE
