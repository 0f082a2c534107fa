#include "import/gltf/mesh_placer.h"

#include "scene/desc/models.h"

namespace ajar::gltf {
namespace {

std::optional<Element> mesh_of(const Element& root, const PlacedNode& placed) {
  const std::optional<Element> reference = placed.node.find("mesh");
  return reference ? std::optional(referred(*reference, root, "meshes")) : std::nullopt;
}

std::string key_of(const Element& mesh, const Pose& pose) { return mesh.pointer() + pose.name; }

}  // namespace

void MeshPlacer::place(const std::vector<PlacedNode>& nodes) {
  const Element root = context_.document.root;
  Poses poses(context_, accessors_, nodes);
  struct Use {
    Element mesh;
    Pose pose;
    std::vector<Mat4> places;
    Element node;
  };
  std::vector<Use> all;
  std::map<std::string, std::size_t> uses;
  // A few kilobytes of nodes that share an accessor multiply to any number.
  constexpr std::size_t kMostPlaces = 1'000'000;
  std::size_t total = 0;
  for (const PlacedNode& placed : nodes) {
    const std::optional<Element> mesh = mesh_of(root, placed);
    if (!mesh || !placed.is_visible) continue;
    Use& use = all.emplace_back(
        Use{*mesh, poses.of(placed, *mesh), places_of_mesh(placed, accessors_), placed.node});
    // Joints are in the world.
    if (use.pose.joints != nullptr) use.places.assign(1, Mat4());
    uses[key_of(use.mesh, use.pose)] += use.places.size();
    total += use.places.size();
    if (total > kMostPlaces) {
      placed.node.fail("the meshes of the scene are in more than " + std::to_string(kMostPlaces) +
                       " places");
    }
  }
  for (const Use& use : all) {
    Parts& parts = parts_of(use.mesh, use.pose);
    for (const Mat4& to_world : use.places) {
      add_shapes(parts.shining, to_world, use.node);
      if (uses[key_of(use.mesh, use.pose)] == 1) {
        add_shapes(parts.plain, to_world, use.node);
      } else {
        add_instance(parts, use.mesh, to_world, use.node);
      }
    }
  }
}

MeshPlacer::Parts& MeshPlacer::parts_of(const Element& mesh, const Pose& pose) {
  const auto [place, is_new] = parts_.try_emplace(key_of(mesh, pose));
  Parts& parts = place->second;
  if (!is_new) return parts;
  for (const Element& primitive : mesh.items("primitives")) {
    const VertexColors* colors =
        meshes_.colors_of(primitive, pose, materials_.has_textures(primitive));
    const Surface& surface = materials_.of(primitive, colors);
    desc::MeshPointer triangles = meshes_.read(primitive, pose, surface, colors);
    if (!triangles) continue;
    desc::Shape& shape = (surface.emission ? parts.shining : parts.plain).emplace_back();
    shape.where = primitive.where();
    shape.name = mesh.value_or<std::string>("name", "");
    shape.node = desc::mesh_node(std::move(triangles));
    shape.material = surface.material;
    shape.alpha = surface.alpha;
    shape.emission = surface.emission;
    shape.inside = surface.inside;
    shape.has_medium_interface = surface.inside != desc::kNone;
  }
  return parts;
}

void MeshPlacer::add_shapes(const std::vector<desc::Shape>& shapes, const Mat4& to_world,
                            const Element& node) {
  // A few kilobytes of nodes and primitives multiply to any number of shapes.
  constexpr std::size_t kMostShapes = 1'000'000;
  if (context_.scene.shapes.size() + shapes.size() > kMostShapes) {
    node.fail("the scene has more than " + std::to_string(kMostShapes) + " shapes");
  }
  for (const desc::Shape& shape : shapes) {
    context_.scene.shapes.push_back(shape);
    context_.scene.shapes.back().to_world = to_world;
  }
}

void MeshPlacer::add_instance(Parts& parts, const Element& mesh, const Mat4& to_world,
                              const Element& node) {
  if (parts.plain.empty()) return;
  if (parts.object == desc::kNone) {
    parts.object = static_cast<desc::ObjectId>(context_.scene.objects.size());
    context_.scene.objects.push_back(
        {mesh.value_or<std::string>("name", ""), mesh.where(), parts.plain});
  }
  context_.scene.instances.push_back({parts.object, to_world, node.where()});
}

}  // namespace ajar::gltf
