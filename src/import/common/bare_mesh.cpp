#include "import/common/bare_mesh.h"

#include "import/common/vertex_colors.h"
#include "import/mesh/validate_mesh.h"
#include "scene/desc/models.h"

namespace ajar {

namespace {

/// Colours the last material with an image, to which the mesh leads.
desc::Mesh paint(desc::Mesh mesh, std::span<const Vec3> colors, desc::SceneDesc& scene) {
  PaintedMesh result = painted(mesh, colors);
  const std::string name = scene.source + ".colors.exr";
  scene.embedded_files[name] = std::make_shared<const std::string>(std::move(result.image));
  scene.textures.push_back(
      {"", {}, desc::texture_node("image", {{"file", name}, {"wrap", std::string("clamp")}})});
  scene.materials.back().node.set(
      "base_color", desc::TextureRef{static_cast<desc::TextureId>(scene.textures.size()) - 1});
  return std::move(result.mesh);
}

}  // namespace

desc::SceneDesc scene_of_mesh(desc::Mesh mesh, std::span<const Vec3> colors, const SceneFile& file,
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
    shape.material = add_neutral_material(scene);
    if (!colors.empty()) mesh = paint(std::move(mesh), colors, scene);
    shape.node = desc::mesh_node(std::make_shared<desc::Mesh>(std::move(mesh)));
  }
  add_studio(scene, {}, up);
  return scene;
}

}  // namespace ajar
