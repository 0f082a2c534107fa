#pragma once
#include <map>
#include <optional>
#include <string>

#include "import/obj/library.h"
#include "scene/desc/scene_desc.h"

namespace ajar::obj {

/// All that a material says of the shapes that have it.
struct Surface {
  desc::MaterialId material = desc::kNone;
  desc::TextureId alpha = desc::kNone;
  std::optional<desc::Emission> emission;
  bool has_images = false;
};

/// The materials of a scene, each made when it is first asked for.
class Materials {
 public:
  Materials(const Library& library, desc::SceneDesc& scene, FileAccess& files, Warnings& warnings)
      : library_(library), scene_(scene), files_(files), warnings_(warnings) {}

  /// The surface of a material; a neutral one for the name "", and, with a warning, for names that
  /// no file has. `where` is the first face that has it.
  const Surface& of(const std::string& material, const SourceLocation& where);
  /// True if a file has such a material.
  bool knows(const std::string& material) const { return library_.find(material) != nullptr; }

 private:
  const Library& library_;
  desc::SceneDesc& scene_;
  FileAccess& files_;
  Warnings& warnings_;
  std::map<std::string, Surface> made_;
};

}  // namespace ajar::obj
