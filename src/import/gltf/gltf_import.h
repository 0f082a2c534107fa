#pragma once
#include <string>
#include <string_view>

#include "core/warnings.h"
#include "import/file_provider.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Reads a file of glTF 2.0. Raises SceneError, with the place, if it cannot be used, IoError if it
/// cannot be read. Missing cameras and lights are added (`import/common/studio.h`).
desc::SceneDesc import_gltf(const std::string& path, Warnings& warnings,
                            const FileProvider& provider);

/// Reads the contents of a file: JSON text or a .glb. `name` is used in messages, other files are
/// looked for in `base_folder`.
desc::SceneDesc import_gltf_bytes(std::string_view bytes, const std::string& name,
                                  const std::string& base_folder, Warnings& warnings,
                                  FileProvider provider);

}  // namespace ajar
