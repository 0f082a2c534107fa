#pragma once
#include <string>

#include "core/error.h"
#include "core/warnings.h"
#include "import/scene_definitions.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Reads a scene: a file in any format that can be imported, or `builtin:NAME`, which asks for no
/// integrator. `definitions` as in `import_scene`. Raises UsageError for an unknown built-in scene,
/// and for definitions where there is nothing to define, IoError if the file cannot be read,
/// SceneError if it cannot be used.
desc::SceneDesc load_scene(const std::string& scene, Warnings& warnings,
                           const SceneDefinitions& definitions = {});

/// Hash of a scene, in 16 hexadecimal digits, as checkpoints and studies name it. Raises as
/// `load_scene` does; warnings are left to the render.
std::string hash_of_scene(const std::string& scene);

/// The scene's name, valid from any folder.
std::string absolute_scene(const std::string& scene);

/// Name for pictures of a scene, without folder and extension: `room` for `/scenes/room.EXTENSION`,
/// `cornell` for `builtin:cornell`; the folder's name if the file is just called `scene`.
std::string scene_stem(const std::string& scene);

}  // namespace ajar
