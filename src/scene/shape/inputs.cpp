#include "scene/shape/inputs.h"

#include <utility>

namespace ajar {
namespace {

constexpr WarningKind kNoArea{Effect::Geometry, "shapes have no area and are left out"};

// Measured: Embree 3.13 keeps 67 bytes per triangle in meshes of 25 000 to 130 000. While it builds
// there are as many again.
constexpr std::uint64_t kTreeBytesPerTriangle = 135;
constexpr std::uint64_t kBytesPerVertex = 64;    // size in a TriangleMesh with all attributes
constexpr std::uint64_t kBytesPerTriangle = 12;  // its indices

}  // namespace

std::optional<float> ShapeInputs::number_if_given(std::string_view name) const {
  const float* given = std::get_if<float>(&node().get(name));
  return given == nullptr ? std::nullopt : std::optional(*given);
}

desc::MeshPointer ShapeInputs::take_mesh(std::string_view name) const {
  desc::MeshPointer mesh = node().mesh(name);
  description_.node.set(name, desc::MeshPointer());
  return mesh;
}

desc::CurvesPointer ShapeInputs::take_curves(std::string_view name) const {
  desc::CurvesPointer curves = node().curves(name);
  description_.node.set(name, desc::CurvesPointer());
  return curves;
}

ParameterSpec radius_input() { return declare::number("radius", "1", "distance from z, at most"); }

ParameterSpec phi_max_input() {
  return declare::number("phi_max", "360", "angle around z; less leaves a part out", "degrees");
}

std::string source_of_quadrics() { return "Pharr et al. 2016, chapter 3"; }

BuiltShape built(const ShapeInputs& inputs, const std::optional<Quadric>& quadric) {
  if (!quadric) {
    inputs.warnings().add(kNoArea, inputs.where(), "the shape has no area; it is left out");
    return {};
  }
  return *quadric;
}

BuiltShape built(const ShapeInputs& inputs, desc::MeshPointer mesh) {
  auto placed = std::make_unique<const TriangleMesh>(
      std::move(mesh), inputs.placement(), inputs.reversed(), inputs.where(), inputs.warnings());
  if (placed->triangle_count() == 0) return {};
  return placed;
}

std::uint64_t mesh_memory(std::uint64_t triangles, std::uint64_t vertices) {
  return triangles * (kTreeBytesPerTriangle + kBytesPerTriangle) + vertices * kBytesPerVertex;
}

}  // namespace ajar
