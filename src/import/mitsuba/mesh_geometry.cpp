#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>

#include "core/printable_text.h"
#include "import/mesh/obj.h"
#include "import/mesh/smooth_normals.h"
#include "import/mitsuba/geometry.h"
#include "import/mitsuba/serialized.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kNoMeshFile{Effect::Geometry, "meshes have no \"filename\": left out"};
constexpr WarningKind kMaterials{Effect::Surface,
                                 "materials of OBJ files are not read: grey stands in"};
constexpr WarningKind kMirrored{
    Effect::Slight,
    "meshes are mirrored: their front is that of Mitsuba 3.10, not of those before"};
constexpr WarningKind kSmoothAngle{
    Effect::Slight, "meshes have sharp edges by an angle, which is not supported: smooth"};

void turn_texture_coordinates(desc::Mesh& mesh) {
  for (Vec2& uv : mesh.uvs) uv.y = 1.F - uv.y;
}

bool names_materials(std::string_view obj) {
  constexpr std::string_view kWord = "mtllib ";
  return obj.starts_with(kWord) || obj.find("\n" + std::string(kWord)) != obj.npos;
}

/// Mitsuba 0.x takes the materials that an OBJ file names where the scene gives no bsdf.
bool wants_materials(Arguments& arguments) {
  return arguments.element().type == "obj" && arguments.context().document.major_version == 0 &&
         arguments.flag("load_materials", true) && arguments.children("bsdf").empty();
}

/// Index of the selected mesh of a file; nothing for all of them.
std::optional<long long> index_of(Arguments& arguments) {
  const std::string& type = arguments.element().type;
  if (type == "serialized") return arguments.integer("shape_index").value_or(0);
  if (type != "obj" || arguments.context().document.major_version != 0) return std::nullopt;
  const std::optional<long long> index = arguments.integer("shape_index");
  return !index || *index < 0 || arguments.flag("collapse", false) ? std::nullopt : index;
}

desc::Mesh read_part(std::string_view bytes, const std::string& name,
                     std::optional<long long> index) {
  if (!index) return read_obj(bytes, name);
  constexpr long long kMost = std::numeric_limits<std::uint32_t>::max();
  return read_obj_run(bytes, name, static_cast<std::uint32_t>(std::min(*index, kMost)));
}

std::function<desc::Mesh(std::string_view, const std::string&)> reader_of(
    Arguments& arguments, std::optional<long long> index) {
  const std::string& type = arguments.element().type;
  if (wants_materials(arguments)) {
    return [&warnings = arguments.context().warnings, where = arguments.where(), index](
               std::string_view bytes, const std::string& name) {
      if (names_materials(bytes)) {
        warnings.add(kMaterials, where,
                     "the materials that this file names are not read: grey stands in",
                     printable(name));
      }
      return read_part(bytes, name, index);
    };
  }
  if (type == "ply") return read_ply;
  return [index, is_obj = type == "obj"](std::string_view bytes, const std::string& name) {
    return is_obj ? read_part(bytes, name, index) : read_serialized(bytes, name, *index);
  };
}

}  // namespace

std::optional<Geometry> make_mesh_geometry(Arguments& arguments, MeshLoader& meshes) {
  Context& context = arguments.context();
  const std::string& type = arguments.element().type;
  const std::optional<std::string> name = arguments.text("filename");
  const std::optional<long long> index = index_of(arguments);
  const bool face_normals = arguments.flag("face_normals", false);
  // Mitsuba's v counts from the top row of an image, that of OBJ files from the bottom row.
  const bool turns_v = arguments.flag("flip_tex_coords", type == "obj");
  if (arguments.number("max_smooth_angle")) {
    context.warnings.add(kSmoothAngle, arguments.where(),
                         "\"max_smooth_angle\" is not supported: the mesh is smooth all over");
  }
  arguments.accept({"srgb", "collapse", "load_materials", "vertex_count", "face_count"});
  if (!name || name->empty()) {
    context.warnings.add(kNoMeshFile, arguments.where(), "this mesh has no \"filename\": left out");
    return std::nullopt;
  }

  const bool is_mirrored = swaps_handedness(arguments.transform("to_world").value_or(Mat4()));
  const bool turns_back = is_mirrored && context.document.major_version < 3;
  MeshRecipe recipe;
  recipe.read = reader_of(arguments, index);
  recipe.finish = [=, &warnings = context.warnings, where = arguments.where()](desc::Mesh& mesh) {
    if (turns_v) turn_texture_coordinates(mesh);
    if (face_normals) mesh.normals.clear();
    if (!mesh.normals.empty()) return;
    // Mitsuba before 3.10 makes normals by the winding that vertices have in the world; ours are
    // turned with the transform, which a mirror makes the opposite. Source: PackedMesh of 3.10.
    if (turns_back) {
      for (auto& triangle : mesh.indices) std::swap(triangle.y, triangle.z);
    } else if (is_mirrored) {
      warnings.add(
          kMirrored, where,
          "this mesh is mirrored: its front is where the mirror shows that of the file, as "
          "in Mitsuba 3.10; in versions before, it is the other side");
    }
    if (!face_normals) make_smooth_normals(mesh);
  };
  recipe.variant = type + " " + (index ? std::to_string(*index) : "all") +
                   (face_normals ? " flat" : " smooth") + (turns_v ? " turned" : "") +
                   (is_mirrored ? " mirrored" : "") +
                   (wants_materials(arguments) ? " with materials" : "");
  const desc::MeshPointer mesh =
      meshes.request(arguments.where(), context.files.find(*name), std::move(recipe));
  return Geometry{desc::mesh_node(mesh), Mat4(), false,
                  std::filesystem::path(*name).stem().string()};
}

}  // namespace ajar::mitsuba
