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
/// All names of a kind, as `ajar list KIND --json` has them. Raises Error for a kind that is
/// none.
std::string catalog(const std::string& kind);
/// Raises the Error that a node of a scene would be refused with, `{"model": …, "parameters": …}`;
/// `kind` is material, texture, light, emission or shape.
void check_node(const std::string& kind, const std::string& node);
}  // namespace ajar::AJAR_INTERFACE
