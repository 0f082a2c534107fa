#pragma once
#include <string>
#include <string_view>

#include "core/warnings.h"
#include "import/common/file_access.h"
#include "scene/desc/scene_desc.h"

/// Common parts of the `read` of formats whose files are read as a whole.
namespace ajar {

struct SceneFile {
  std::string_view bytes;
  const std::string& name;  ///< for messages
  const std::string& path;  ///< from the provider, or absolute
};

/// Makes a scene of the contents of a file; other files come from `files`.
using ReadScene = desc::SceneDesc (*)(const SceneFile& file, Warnings& warnings, FileAccess& files);

/// Runs `read` on a file of the provider or of the disk. The scene's `files` are those that were
/// named, and the file itself. Raises IoError if it cannot be read.
desc::SceneDesc read_scene_file(const std::string& path, Warnings& warnings,
                                const FileProvider& provider, ReadScene read);

/// Reads contents that are called `name`, in `folder`.
desc::SceneDesc read_scene_bytes(std::string_view bytes, const std::string& name,
                                 const std::string& folder, Warnings& warnings,
                                 FileProvider provider, ReadScene read);

}  // namespace ajar
