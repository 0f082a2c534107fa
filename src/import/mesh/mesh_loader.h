#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/warnings.h"
#include "import/common/file_access.h"
#include "import/mesh/ply.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Conversion of a file's bytes to a mesh.
struct MeshRecipe {
  /// Raises SceneError. `name` is the scene's name of the file.
  std::function<desc::Mesh(std::string_view bytes, const std::string& name)> read = read_ply;
  /// Done to the mesh once it is known to be valid; may be empty.
  std::function<void(desc::Mesh&)> finish = {};
  /// Key of recipes that make different meshes of one file.
  std::string variant = {};
};

/// Collects the mesh files that shapes refer to while the scene is parsed, and reads them all in
/// parallel afterwards, each once.
class MeshLoader {
 public:
  MeshLoader(FileAccess& files, Warnings& warnings) : files_(files), warnings_(warnings) {}

  /// An empty mesh that `load_all` fills. `where` is the place that first names the file.
  std::shared_ptr<const desc::Mesh> request(const SourceLocation& where, const std::string& name,
                                            MeshRecipe recipe = {});
  /// Leaves the meshes of files that are missing or damaged empty, each with a warning.
  void load_all();

 private:
  struct Job {
    SourceLocation where;
    std::string name;  ///< as the scene says it
    std::string path;
    MeshRecipe recipe;
    std::shared_ptr<desc::Mesh> mesh;
    std::vector<Warning> remarks;
    std::string error;
  };
  void load(Job& job) const;

  FileAccess& files_;
  Warnings& warnings_;
  std::vector<Job> jobs_;
  std::map<std::pair<std::string, std::string>, std::size_t> known_;  ///< by path and variant
};

/// True for a mesh without triangles, as of files that could not be read.
bool is_empty_mesh(const desc::Shape& shape);
/// Leaves out such shapes.
void remove_empty_meshes(desc::SceneDesc& scene);

}  // namespace ajar
