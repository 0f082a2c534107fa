#pragma once
#include <string>

#include "core/error.h"
#include "core/warnings.h"
#include "import/file_provider.h"
#include "import/scene_definitions.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Reads a scene file of any known format (`format.h`), by its extension. Raises SceneError if the
/// extension is unknown or the scene cannot be used, IoError if the file cannot be read.
/// `definitions` give values to parameters of the scene; a UsageError if its format has no such
/// thing.
desc::SceneDesc import_scene(const std::string& path, Warnings& warnings,
                             const FileProvider& provider = {},
                             const SceneDefinitions& definitions = {});

}  // namespace ajar
