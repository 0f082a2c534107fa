#include "import/obj/obj_import.h"

#include "import/common/scene_file.h"
#include "import/common/studio.h"
#include "import/mesh/obj.h"
#include "import/mesh/validate_mesh.h"
#include "import/obj/materials.h"
#include "import/obj/words.h"
#include "scene/desc/models.h"

namespace ajar {
namespace {

constexpr WarningKind kUnread{Effect::Geometry, "kinds of lines of OBJ files are not read"};
constexpr WarningKind kColors{Effect::Surface, "OBJ files have colours of vertices: not read"};

void add_shape(ObjPart& part, obj::Materials& materials, desc::SceneDesc& scene,
               Warnings& warnings) {
  std::vector<Warning> remarks;
  validate_mesh(part.mesh, part.where, remarks);
  for (Warning& remark : remarks) warnings.add(std::move(remark));
  if (part.mesh.indices.empty()) return;
  const obj::Surface& surface = materials.of(part.material, part.where);
  desc::Shape& shape = scene.shapes.emplace_back();
  shape.where = part.where;
  shape.name = part.material;
  shape.node = desc::mesh_node(std::make_shared<desc::Mesh>(std::move(part.mesh)));
  shape.material = surface.material;
  shape.alpha = surface.alpha;
  shape.emission = surface.emission;
}

desc::SceneDesc import_file(const SceneFile& file, Warnings& warnings, FileAccess& files) {
  desc::SceneDesc scene;
  scene.source = file.name;
  obj::Library library(files, warnings);
  std::vector<ObjPart> parts =
      read_obj_parts(file.bytes, file.name,
                     {.on_library = [&](const SourceLocation& where,
                                        std::string_view names) { library.load(where, names); },
                      .on_unread =
                          [&](const SourceLocation& where, std::string_view word) {
                            const std::string remark = obj::remark_on_unread(word);
                            if (!remark.empty()) warnings.add(kUnread, where, remark);
                          },
                      .on_colors =
                          [&](const SourceLocation& where, std::string_view) {
                            warnings.add(kColors, where, "colours of vertices are not read");
                          }});
  obj::Materials materials(library, scene, files, warnings);
  for (ObjPart& part : parts) add_shape(part, materials, scene, warnings);
  add_studio(scene, {}, UpAxis::Y);
  return scene;
}

}  // namespace

desc::SceneDesc import_obj(const std::string& path, Warnings& warnings,
                           const FileProvider& provider) {
  return read_scene_file(path, warnings, provider, import_file);
}

desc::SceneDesc import_obj_text(std::string_view text, const std::string& name,
                                const std::string& base_folder, Warnings& warnings,
                                FileProvider provider) {
  return read_scene_bytes(text, name, base_folder, warnings, std::move(provider), import_file);
}

}  // namespace ajar
