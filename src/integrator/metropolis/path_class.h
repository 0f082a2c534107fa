#pragma once

namespace ajar {

/// Paths of a chain, by their own properties and not by the technique that found them.
enum class PathClass {
  All,
  Connectible,        ///< with an edge that a connection could make: neither end of it is specular
  UnidirectionalOnly  ///< without: only those find them who hit the light by chance
};

constexpr bool has_paths(PathClass paths, bool unidirectional_only) {
  return paths == PathClass::All || (paths == PathClass::UnidirectionalOnly) == unidirectional_only;
}

}  // namespace ajar
