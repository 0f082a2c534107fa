#pragma once
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "import/tungsten/context.h"

namespace ajar::tungsten {

/// Options of a primitive for its mesh.
struct MeshTreatment {
  bool smooth = false;             ///< interpolates normals
  bool recompute_normals = false;  ///< does not take those of the file; only if it is smooth
  auto operator<=>(const MeshTreatment&) const = default;
};

/// The triangles of a mesh file that share a bsdf.
struct MeshPart {
  int bsdf;  ///< as the file says it
  desc::MeshPointer mesh;
};

/// Reads mesh files, each once per treatment.
class MeshFiles {
 public:
  explicit MeshFiles(Context& context) : context_(context) {}

  /// The parts of a file, none of them empty; none, after a warning, if there is no such file or it
  /// is damaged. `count`: of the bsdfs there are, to which larger and negative numbers are clamped.
  const std::vector<MeshPart>& load(const LocatedJson& name, const MeshTreatment& treatment,
                                    int count);

 private:
  using Key = std::tuple<std::string, MeshTreatment, int>;
  std::vector<MeshPart> read(const LocatedJson& name, const std::string& path,
                             const MeshTreatment& treatment, int count) const;

  Context& context_;
  std::map<Key, std::vector<MeshPart>> loaded_;
};

}  // namespace ajar::tungsten
