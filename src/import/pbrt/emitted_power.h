#pragma once
#include <cstddef>

#include "core/warnings.h"
#include "scene/desc/scene_desc.h"

namespace ajar::pbrt {

/// Scales the emission of `shape` such that each of its primitives emits light of luminance
/// `power`: pbrt-v4 makes a light of every triangle. `triangles_per_primitive` is more than 1 for
/// patches, which are triangles here. Where primitives differ in size, the shape as a whole emits
/// their sum, after a warning.
void scale_to_power(desc::Shape& shape, float power, std::size_t triangles_per_primitive,
                    Warnings& warnings);

}  // namespace ajar::pbrt
