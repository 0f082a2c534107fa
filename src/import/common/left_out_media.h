#pragma once
#include <string>

#include "core/warnings.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Warns at `where` that the `integrator` of that renderer leaves out media, unless nothing of the
/// scene, shape, light or camera, has one beside it.
void warn_of_left_out_media(const desc::SceneDesc& scene, const SourceLocation& where,
                            const std::string& integrator, const std::string& renderer,
                            Warnings& warnings);

}  // namespace ajar
