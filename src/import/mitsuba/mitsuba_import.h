#pragma once
#include <string>
#include <string_view>

#include "core/warnings.h"
#include "import/file_provider.h"
#include "import/scene_definitions.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Reads a scene of Mitsuba 0.5, 0.6, 2 or 3 and the files it refers to, except images. Properties
/// have Mitsuba's defaults and meaning; what we cannot do is a warning with its location. Raises
/// SceneError (with file:line:column) if the scene cannot be used, IoError if `path` itself cannot
/// be read. Files, `path` too, are asked of `provider` first. `definitions` give `$name` a value,
/// before all `<default>`. Sources: Mitsuba 0.6 manual, chapters 6 to 8;
/// https://mitsuba.readthedocs.io
desc::SceneDesc import_mitsuba(const std::string& path, Warnings& warnings,
                               const FileProvider& provider = {},
                               const SceneDefinitions& definitions = {});

/// Reads text in memory. `name` stands in messages; other files are looked up relative to
/// `base_folder`, at `provider` first, then on the disk.
desc::SceneDesc import_mitsuba_text(std::string_view text, const std::string& name,
                                    const std::string& base_folder, Warnings& warnings,
                                    FileProvider provider = {},
                                    const SceneDefinitions& definitions = {});

}  // namespace ajar
