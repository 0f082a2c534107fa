#pragma once
#include <map>
#include <vector>

#include "import/gltf/materials.h"
#include "import/gltf/meshes.h"
#include "import/gltf/nodes.h"

namespace ajar::gltf {

/// Adds the meshes of nodes to the scene: those that several nodes have as objects and instances.
class MeshPlacer {
 public:
  explicit MeshPlacer(Context& context)
      : context_(context),
        buffers_(context),
        accessors_(context, buffers_),
        meshes_(context, accessors_),
        materials_(context, buffers_) {}

  void place(const std::vector<PlacedNode>& nodes);

 private:
  /// Shapes of a mesh in a pose, in its own space.
  struct Parts {
    std::vector<desc::Shape> plain;
    std::vector<desc::Shape> shining;  ///< emissive shapes, which instances cannot have
    desc::ObjectId object = desc::kNone;
  };

  Parts& parts_of(const Element& mesh, const Pose& pose);
  void add_shapes(const std::vector<desc::Shape>& shapes, const Mat4& to_world,
                  const Element& node);
  void add_instance(Parts& parts, const Element& mesh, const Mat4& to_world, const Element& node);

  Context& context_;
  Buffers buffers_;
  Accessors accessors_;
  Meshes meshes_;
  Materials materials_;
  std::map<std::string, Parts> parts_;  ///< by JSON pointer of the mesh, and its pose
};

}  // namespace ajar::gltf
