#include "import/obj/obj_import.h"

#include <algorithm>

#include "core/printable_text.h"
#include "import/common/painted_mesh.h"
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
constexpr WarningKind kNumbers{Effect::Slight,
                               "vertices of OBJ files have numbers that are not read"};
constexpr WarningKind kNoUvs{Effect::Surface,
                             "faces have images, but no texture coordinates for them"};
constexpr WarningKind kColors{Effect::Surface,
                              "shapes have colours of vertices beside a material: not shown"};

bool is_white(const std::vector<Vec3>& colors) {
  return std::all_of(colors.begin(), colors.end(),
                     [](const Vec3& color) { return color == Vec3(1.F); });
}

void add_shape(ObjPart& part, obj::Materials& materials, desc::SceneDesc& scene,
               Warnings& warnings) {
  std::vector<Warning> remarks;
  validate_mesh(part.mesh, part.where, remarks);
  for (Warning& remark : remarks) warnings.add(std::move(remark));
  if (part.mesh.indices.empty()) return;
  desc::Shape& shape = scene.shapes.emplace_back();
  shape.where = part.where;
  shape.name = part.material;
  const bool has_material = materials.knows(part.material);
  if (!part.colors.empty() && !has_material) {
    if (!part.material.empty()) materials.of(part.material, part.where);
    return paint_shape(shape, part.mesh, part.colors,
                       scene.source + "." + std::to_string(scene.shapes.size()), scene);
  }
  if (!is_white(part.colors)) {
    warnings.add(kColors, part.where,
                 "the material \"" + printable_line(part.material) +
                     "\" counts: the colours of the vertices are not shown",
                 printable_line(part.material));
  }
  const obj::Surface& surface = materials.of(part.material, part.where);
  if (surface.has_images && part.mesh.uvs.empty()) {
    warnings.add(kNoUvs, part.where,
                 "faces from here on have no texture coordinates, which the images of \"" +
                     printable_line(part.material) + "\" use: each triangle shows half of an image",
                 printable_line(part.material));
  }
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
                      .on_numbers =
                          [&](const SourceLocation& where, std::string_view numbers) {
                            warnings.add(kNumbers, where,
                                         "a vertex has a weight, a colour or both behind its "
                                         "position: \"" +
                                             printable_line(numbers) + "\" is not read");
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
