#pragma once
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/warnings.h"
#include "import/file_provider.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Reads a scene of Tungsten and the meshes it refers to. Members have Tungsten's defaults and
/// meaning; what we cannot do is a warning with its location. Raises SceneError (with
/// file:line:column) if the scene cannot be used, IoError if `path` itself cannot be read. Files,
/// `path` too, are asked of `provider` first. Source: Tungsten,
/// https://github.com/tunabrain/tungsten
desc::SceneDesc import_tungsten(const std::string& path, Warnings& warnings,
                                const FileProvider& provider = {});

/// Reads text in memory. `name` stands in messages; other files are looked up relative to
/// `base_folder`, at `provider` first, then on the disk.
desc::SceneDesc import_tungsten_text(std::string_view text, const std::string& name,
                                     const std::string& base_folder, Warnings& warnings,
                                     FileProvider provider = {});

}  // namespace ajar
