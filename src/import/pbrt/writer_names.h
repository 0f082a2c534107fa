#pragma once
#include <set>
#include <string>
#include <vector>

#include "scene/desc/scene_desc.h"

namespace ajar::pbrt {

/// Use of textures as numbers and as colours: pbrt declares them apart.
struct TextureUse {
  bool as_float = false;
  bool as_spectrum = false;
};
std::vector<TextureUse> texture_uses(const desc::SceneDesc& scene);

/// Names for things that may have none, or the same as others.
template <typename Thing>
std::vector<std::string> unique_names(const std::vector<Thing>& things, const std::string& kind) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < things.size(); ++i) {
    std::string name = things[i].name.empty() ? kind + std::to_string(i) : things[i].name;
    while (!taken.insert(name).second) name += "_" + std::to_string(i);
    names.push_back(name);
  }
  return names;
}

}  // namespace ajar::pbrt
