#pragma once
#include <cstdint>

#include "scene/desc/scene_desc.h"

namespace ajar {

/// Memory that building a scene takes beside its description, bytes. Estimates, for deciding before
/// the start whether a machine is large enough.
struct SceneMemory {
  /// Vertices in their final place, and Embree's tree of them with its memory while it grows.
  std::uint64_t geometry = 0;
  std::uint64_t images = 0;  ///< texels as their files store them; those of lights with densities
  std::uint64_t media = 0;   ///< beside grids of density, which are shared
};

/// Looks at the sizes of image files, not into them; those that cannot be read count nothing.
/// Raises SceneError as `shape_memory` does.
SceneMemory estimate_memory(const desc::SceneDesc& scene);

}  // namespace ajar
