#pragma once
#include "transport/path_vertex.h"

namespace ajar {

/// Clear glass or a mirror: nothing can be connected to it. Lamps that scatter nothing are seen
/// well.
inline bool is_clear(const PathVertex& vertex) {
  return !vertex.in_medium && !vertex.bsdf.connectible() && !vertex.bsdf.empty();
}

}  // namespace ajar
