#pragma once

namespace ajar {

/// Paths of a chain, by their own properties and not by the technique that found them.
enum class PathClass {
  All,
  Connectible,  ///< with an edge that a connection could make: neither end of it is specular
  HitOnly       ///< without: only those find them who hit the light by chance
};

constexpr bool has_paths(PathClass paths, bool hit_only) {
  return paths == PathClass::All || (paths == PathClass::HitOnly) == hit_only;
}

}  // namespace ajar
