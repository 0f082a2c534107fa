#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "import/pbrt/context.h"

namespace ajar::pbrt {

/// Collects the mesh files that shapes refer to while the scene is parsed, and reads them all in
/// parallel afterwards, each once.
class MeshLoader {
 public:
  explicit MeshLoader(Context& context) : context_(context) {}

  /// An empty mesh that `load_all` fills. `where` is the place that first names the file.
  std::shared_ptr<const desc::Mesh> request(const SourceLocation& where, const std::string& name);
  /// Raises SceneError for the first file, in order of request, that is missing or damaged.
  void load_all();

 private:
  struct Job {
    SourceLocation where;
    std::string name;  ///< as the scene says it
    std::string path;
    std::shared_ptr<desc::Mesh> mesh;
    std::vector<Warning> remarks;
    std::string error;
  };
  void load(Job& job) const;

  Context& context_;
  std::vector<Job> jobs_;
  std::map<std::string, std::size_t> by_path_;
};

}  // namespace ajar::pbrt
