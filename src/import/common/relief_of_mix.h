#pragma once
#include "core/warnings.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Warns at `where` if the parts of a mix differ in bump or normal map: for a format in which each
/// part has its own. Our mixes have that of the first.
void check_relief_of_mix(const desc::SceneDesc& scene, desc::MaterialId first,
                         desc::MaterialId second, const SourceLocation& where, Warnings& warnings);

}  // namespace ajar
