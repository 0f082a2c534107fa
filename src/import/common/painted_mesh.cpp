#include "import/common/painted_mesh.h"

#include <memory>
#include <utility>

#include "import/common/studio.h"
#include "import/common/vertex_colors.h"
#include "scene/desc/models.h"

namespace ajar {

void paint_shape(desc::Shape& shape, const desc::Mesh& mesh, std::span<const Vec3> colors,
                 const std::string& name, desc::SceneDesc& scene) {
  PaintedMesh result = painted(mesh, colors);
  const std::string file = name + ".colors.exr";
  scene.embedded_files[file] = std::make_shared<const std::string>(std::move(result.image));
  scene.textures.push_back(
      {"", {}, desc::texture_node("image", {{"file", file}, {"wrap", std::string("clamp")}})});
  shape.material = add_neutral_material(scene);
  scene.materials.back().node.set(
      "base_color", desc::TextureRef{static_cast<desc::TextureId>(scene.textures.size()) - 1});
  shape.node = desc::mesh_node(std::make_shared<desc::Mesh>(std::move(result.mesh)));
}

}  // namespace ajar
