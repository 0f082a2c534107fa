#pragma once
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/warnings.h"
#include "import/file_provider.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Reads a scene of pbrt-v3 or pbrt-v4 (recognised by `pbrt/dialect.h`) and the files it refers to,
/// except images. Parameters have the defaults and the meaning of that version; unsupported ones
/// are a warning with its location. Raises SceneError (with file:line:column) if the scene cannot
/// be used, IoError if `path` itself cannot be read. Files, `path` too, are asked of `provider`
/// first. Sources: https://www.pbrt.org/fileformat-v3, /fileformat-v4
desc::SceneDesc import_pbrt(const std::string& path, Warnings& warnings,
                            const FileProvider& provider = {});

/// Reads text in memory. `name` stands in messages; other files are looked up relative to
/// `base_folder`, at `provider` first, then on the disk. The provider is asked for
/// "base_folder/file" in normal form (without "." and "..").
desc::SceneDesc import_pbrt_text(std::string_view text, const std::string& name,
                                 const std::string& base_folder, Warnings& warnings,
                                 FileProvider provider = {});

}  // namespace ajar
