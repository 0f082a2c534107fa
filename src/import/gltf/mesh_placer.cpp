#include "import/gltf/mesh_placer.h"

#include "scene/desc/models.h"

namespace ajar::gltf {
namespace {

constexpr WarningKind kSkinned{Effect::Geometry,
                               "meshes have skeletons, and are shown as they were bound to them"};

std::optional<Element> mesh_of(const Element& root, const PlacedNode& placed) {
  const std::optional<Element> reference = placed.node.find("mesh");
  return reference ? std::optional(reference->referred(root, "meshes")) : std::nullopt;
}

}  // namespace

void MeshPlacer::place(const std::vector<PlacedNode>& nodes) {
  const Element root = context_.document.root();
  std::map<std::string, std::size_t> uses;
  for (const PlacedNode& placed : nodes) {
    if (const auto mesh = mesh_of(root, placed)) ++uses[mesh->pointer()];
  }
  for (const PlacedNode& placed : nodes) {
    const std::optional<Element> mesh = mesh_of(root, placed);
    if (!mesh) continue;
    if (placed.node.has("skin")) {
      context_.warnings.add(kSkinned, placed.node.where(),
                            "this mesh is shown as it was bound to its skeleton");
    }
    Parts& parts = parts_of(*mesh);
    add_shapes(parts.shining, placed);
    if (uses[mesh->pointer()] == 1) {
      add_shapes(parts.plain, placed);
    } else {
      add_instance(parts, *mesh, placed);
    }
  }
}

MeshPlacer::Parts& MeshPlacer::parts_of(const Element& mesh) {
  const auto [place, is_new] = parts_.try_emplace(mesh.pointer());
  Parts& parts = place->second;
  if (!is_new) return parts;
  for (const Element& primitive : mesh.elements("primitives")) {
    const VertexColors* colors = meshes_.colors_of(primitive, materials_.has_textures(primitive));
    const Surface& surface = materials_.of(primitive, colors);
    desc::MeshPointer triangles = meshes_.read(primitive, surface, colors);
    if (!triangles) continue;
    desc::Shape& shape = (surface.emission ? parts.shining : parts.plain).emplace_back();
    shape.where = primitive.where();
    shape.name = mesh.text_or("name", "");
    shape.node = desc::mesh_node(std::move(triangles));
    shape.material = surface.material;
    shape.alpha = surface.alpha;
    shape.emission = surface.emission;
    shape.inside = surface.inside;
    shape.has_medium_interface = surface.inside != desc::kNone;
  }
  return parts;
}

void MeshPlacer::add_shapes(const std::vector<desc::Shape>& shapes, const PlacedNode& placed) {
  // A few kilobytes of nodes and primitives multiply to any number of shapes.
  constexpr std::size_t kMostShapes = 1'000'000;
  if (context_.scene.shapes.size() + shapes.size() > kMostShapes) {
    placed.node.fail("the scene has more than " + std::to_string(kMostShapes) + " shapes");
  }
  for (const desc::Shape& shape : shapes) {
    context_.scene.shapes.push_back(shape);
    context_.scene.shapes.back().to_world = placed.to_world;
  }
}

void MeshPlacer::add_instance(Parts& parts, const Element& mesh, const PlacedNode& placed) {
  if (parts.plain.empty()) return;
  if (parts.object == desc::kNone) {
    parts.object = static_cast<desc::ObjectId>(context_.scene.objects.size());
    context_.scene.objects.push_back({mesh.text_or("name", ""), mesh.where(), parts.plain});
  }
  context_.scene.instances.push_back({parts.object, placed.to_world, placed.node.where()});
}

}  // namespace ajar::gltf
