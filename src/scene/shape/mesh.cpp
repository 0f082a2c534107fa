#include "scene/shape/inputs.h"

namespace ajar {

ShapeModel mesh_shape() {
  return {{.name = "mesh",
           .summary = "triangles",
           .source = "",
           .parameters = {declare::mesh("mesh",
                                        "positions, triangles; normals, tangents and "
                                        "texture coordinates if it has them")}},
          [](const ShapeInputs& in) {
            desc::MeshPointer mesh = in.take_mesh("mesh");
            return mesh ? built(in, std::move(mesh)) : BuiltShape();
          },
          [](const desc::Shape& shape) {
            const desc::MeshPointer& mesh = shape.node.mesh("mesh");
            return mesh ? mesh_memory(mesh->indices.size(), mesh->positions.size()) : 0;
          }};
}

}  // namespace ajar
