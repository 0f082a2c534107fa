#pragma once
#include <string>
#include <vector>

#include "core/warnings.h"
#include "import/file_provider.h"
#include "import/scene_definitions.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// A format of scene files. Each has a folder here; its `format.cpp` defines `Format format()` in
/// the namespace `ajar::FOLDER`. The build lists those that it finds (cmake/list_formats.cmake), so
/// that nothing outside of the folder names the format.
struct Format {
  std::string name;
  std::string summary;                  ///< one line
  std::vector<std::string> extensions;  ///< as ".xyz", in small letters; the usual one first
  /// Reads a scene and the files it refers to, except images. Files are asked of `provider`, `path`
  /// itself, too, before they are looked for on the disk. Raises SceneError, with file:line:column,
  /// if the scene cannot be used, IoError if `path` cannot be read.
  desc::SceneDesc (*read)(const std::string& path, Warnings& warnings,
                          const FileProvider& provider);
  /// Reads with values for parameters that scenes of the format leave open. Raises SceneError, too,
  /// for names that this scene does not have. Null: the format has no such thing.
  desc::SceneDesc (*read_defined)(const std::string& path, Warnings& warnings,
                                  const FileProvider& provider,
                                  const SceneDefinitions& definitions) = nullptr;
  /// Writes a scene such that reading it gives a description of equal `desc::hash` (embedded files
  /// become files, and have another name then). Each file is written as a whole or not at all,
  /// `path` last. Returns a message on parts unknown to other programs that read the format; empty
  /// if there are none. Raises IoError. Null: the format is only read.
  std::string (*write)(const desc::SceneDesc& scene, const std::string& path) = nullptr;
};

/// Every format there is, sorted by folder.
const std::vector<Format>& formats();

/// The format of a file, by its extension. Raises SceneError, which lists the extensions, if there
/// is none.
const Format& format_of(const std::string& path);
/// Format of a file to be written. Raises UsageError.
const Format& format_to_write(const std::string& path);

/// "one (.one), other (.abc, .xyz)": those that can be written, for help.
std::string writable_formats();

}  // namespace ajar
