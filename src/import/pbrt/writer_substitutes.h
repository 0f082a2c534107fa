#pragma once
#include <functional>
#include <map>
#include <string_view>

#include "scene/desc/node.h"

namespace ajar::pbrt {

/// Values for pbrt-v3 in place of a node's own, by the names of our parameters; nothing, if the
/// others say it.
using Substitutes = std::map<std::string_view, desc::Value, std::less<>>;

/// Nearest equivalents of a material that pbrt-v3 has no words for: the gloss of a coat by its
/// reflectance along the normal, the index of a metal that is given by its reflectance, α of a
/// roughness that is its square.
Substitutes substitutes_of_material(const desc::Node& material);

}  // namespace ajar::pbrt
