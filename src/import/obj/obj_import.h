#pragma once
#include <string>
#include <string_view>

#include "core/warnings.h"
#include "import/file_provider.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Reads a Wavefront file and its materials, in a studio (`import/common/studio.h`). Raises
/// SceneError, with file and line, if it cannot be used, IoError if it cannot be read.
desc::SceneDesc import_obj(const std::string& path, Warnings& warnings,
                           const FileProvider& provider);

/// Reads text. `name` is used in messages, other files are looked for in `base_folder`.
desc::SceneDesc import_obj_text(std::string_view text, const std::string& name,
                                const std::string& base_folder, Warnings& warnings,
                                FileProvider provider);

}  // namespace ajar
