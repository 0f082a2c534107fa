#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ajar {

/// A file that is part of a built-in scene. The bytes live as long as the program.
struct EmbeddedFile {
  std::string_view scene;  ///< name of the scene, e.g. "cornell"
  std::string_view path;   ///< inside the folder of the scene, e.g. "meshes/floor.ply"
  std::string_view bytes;
};

/// All files embedded in the program (see cmake/embed.cmake), sorted by scene, then path.
std::span<const EmbeddedFile> embedded_files();

/// Names of the built-in scenes, sorted.
std::vector<std::string> builtin_scene_names();

/// The file of a built-in scene, "scene" with the extension of its format; null if there is none.
const EmbeddedFile* builtin_scene(std::string_view scene);

/// First sentence of the comment, in lines with #, at the top of a scene's file, without the
/// scene's name that it may begin with: one line for lists.
std::string builtin_scene_summary(std::string_view scene);

/// A file of a built-in scene; empty if there is none. `path` may begin with "./" or with the
/// scene's base folder
/// ("builtin:NAME/").
std::optional<std::string_view> builtin_file(std::string_view scene, std::string_view path);

}  // namespace ajar
