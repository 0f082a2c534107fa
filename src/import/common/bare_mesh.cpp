#include "import/common/bare_mesh.h"

#include "import/common/painted_mesh.h"
#include "import/mesh/validate_mesh.h"
#include "scene/desc/models.h"

namespace ajar {

desc::SceneDesc scene_of_mesh(desc::Mesh mesh, const Paint& paint, const SceneFile& file,
                              Warnings& warnings, UpAxis up) {
  const SourceLocation where{std::make_shared<const std::string>(file.name), 0, 0};
  std::vector<Warning> remarks;
  validate_mesh(mesh, where, remarks);
  for (Warning& remark : remarks) warnings.add(std::move(remark));
  desc::SceneDesc scene;
  scene.source = file.name;
  if (!mesh.indices.empty()) {
    desc::Shape& shape = scene.shapes.emplace_back();
    shape.where = where;
    if (paint.colors.empty() || !paint.image.empty()) {
      shape.material = add_neutral_material(scene);
      if (!paint.image.empty()) {
        scene.textures.push_back({"", where, desc::texture_node("image", {{"file", paint.image}})});
        scene.materials.back().node.set("base_color", desc::TextureRef{0});
      }
      shape.node = desc::mesh_node(std::make_shared<desc::Mesh>(std::move(mesh)));
    } else {
      paint_shape(shape, mesh, paint.colors, scene.source, scene);
    }
  }
  add_studio(scene, {}, up);
  return scene;
}

}  // namespace ajar
