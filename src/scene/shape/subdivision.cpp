#include <algorithm>
#include <string>

#include "os/available_memory.h"
#include "scene/shape/inputs.h"
#include "scene/shape/loop_subdivision.h"

namespace ajar {
namespace {

/// Each level makes four triangles of one; large meshes have half as many vertices. Refining takes
/// less than Embree does afterwards.
std::uint64_t refined_memory(const desc::Mesh& control, int levels) {
  const std::uint64_t triangles = std::uint64_t{control.indices.size()}
                                  << 2U * static_cast<unsigned>(levels);
  return mesh_memory(triangles, triangles / 2);
}

/// Raises SceneError, with the levels that are possible, if there is less.
std::uint64_t checked_memory(const desc::Mesh& control, int wanted, const SourceLocation& where) {
  const int levels = possible_levels(control, wanted);
  const std::uint64_t bytes = refined_memory(control, levels);
  const std::string preparation_cut = memory_shortage(bytes);
  if (preparation_cut.empty()) return bytes;
  int fitting = levels - 1;
  while (fitting > 0 && !memory_shortage(refined_memory(control, fitting)).empty()) --fitting;
  const std::size_t faces = control.indices.size();
  throw SceneError(where, "this subdivision surface, with " + std::to_string(faces) +
                              (faces == 1 ? " face" : " faces") + " and \"levels\" of " +
                              std::to_string(wanted) + ", " + preparation_cut +
                              "; \"levels\" can be at most " +
                              std::to_string(std::max(fitting, 0)));
}

BuiltShape make_subdivision(const ShapeInputs& in) {
  const desc::MeshPointer control = in.take_mesh("control");
  if (!control) return {};
  const int levels = in.node().integer("levels");
  checked_memory(*control, levels, in.where());
  return built(in, subdivide(*control, levels, in.where(), in.warnings()));
}

}  // namespace

ShapeModel subdivision_shape() {
  return {{.name = "subdivision",
           .summary = "a smooth surface that a coarse mesh controls",
           .source = "Loop 1987",
           .parameters = {declare::integer("levels", "3", "how often the mesh is refined", 0, 15),
                          declare::mesh("control", "positions and triangles of the coarse mesh")}},
          make_subdivision,
          [](const desc::Shape& shape) {
            const desc::MeshPointer& control = shape.node.mesh("control");
            const int levels = shape.node.integer("levels");
            return control ? checked_memory(*control, levels, shape.where) : 0;
          }};
}

}  // namespace ajar
