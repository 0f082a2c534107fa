#pragma once
#include "core/warnings.h"
#include "import/common/file_access.h"
#include "import/gltf/document.h"
#include "scene/desc/scene_desc.h"

namespace ajar::gltf {

/// State shared by all parts of the importer.
struct Context {
  desc::SceneDesc& scene;
  Warnings& warnings;
  FileAccess& files;
  const Document& document;
  const std::string& path;  ///< path of the file: embedded images are named after it
};

}  // namespace ajar::gltf
