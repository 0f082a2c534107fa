#pragma once
#include <string>

#include "core/error.h"
#include "core/warnings.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Reads a scene file of any format we know, told by its extension (.pbrt). Raises SceneError if
/// the extension is none of ours or the scene cannot be used, IoError if the file cannot be read.
desc::SceneDesc import_scene(const std::string& path, Warnings& warnings);

}  // namespace ajar
