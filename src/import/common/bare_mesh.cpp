#include "import/common/bare_mesh.h"

#include "import/mesh/validate_mesh.h"
#include "scene/desc/models.h"

namespace ajar {

desc::SceneDesc scene_of_mesh(desc::Mesh mesh, const SceneFile& file, Warnings& warnings,
                              UpAxis up) {
  const SourceLocation where{std::make_shared<const std::string>(file.name), 0, 0};
  std::vector<Warning> remarks;
  validate_mesh(mesh, where, remarks);
  for (Warning& remark : remarks) warnings.add(std::move(remark));
  desc::SceneDesc scene;
  scene.source = file.name;
  if (!mesh.indices.empty()) {
    desc::Shape& shape = scene.shapes.emplace_back();
    shape.where = where;
    shape.node = desc::mesh_node(std::make_shared<desc::Mesh>(std::move(mesh)));
    shape.material = add_neutral_material(scene);
  }
  add_studio(scene, {}, up);
  return scene;
}

}  // namespace ajar
