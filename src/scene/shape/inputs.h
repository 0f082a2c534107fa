#pragma once
#include <optional>
#include <string>

#include "scene/shape/registry.h"

namespace ajar {

/// The description of one shape, with its place in the world.
class ShapeInputs {
 public:
  ShapeInputs(desc::Shape& description, const Placement& placement, Warnings& warnings)
      : description_(description), placement_(placement), warnings_(warnings) {}

  const desc::Node& node() const { return description_.node; }
  float number(std::string_view name) const { return node().number(name); }
  /// Nothing if the parameter was left out.
  std::optional<float> number_if_given(std::string_view name) const;
  /// Takes the value of the parameter out of the description; null if there is none.
  desc::MeshPointer take_mesh(std::string_view name) const;
  desc::CurvesPointer take_curves(std::string_view name) const;

  const Placement& placement() const { return placement_; }
  bool reversed() const { return description_.reverse_orientation; }
  const SourceLocation& where() const { return description_.where; }
  Warnings& warnings() const { return warnings_; }

 private:
  desc::Shape& description_;
  const Placement& placement_;
  Warnings& warnings_;
};

// Parameters that several models share.

/// "radius", from the axis.
ParameterSpec radius_input();
/// "phi_max", of surfaces that turn around z.
ParameterSpec phi_max_input();
/// The usual `Model::source` of quadrics.
std::string source_of_quadrics();
/// A quadric; nothing, after a warning, if it has no area.
BuiltShape built(const ShapeInputs& inputs, const std::optional<Quadric>& quadric);
/// A mesh; nothing if all its triangles were dropped, which is a warning then.
BuiltShape built(const ShapeInputs& inputs, desc::MeshPointer mesh);
/// Memory of a mesh, bytes: vertices in their place, Embree's tree while it grows.
std::uint64_t mesh_memory(std::uint64_t triangles, std::uint64_t vertices);

}  // namespace ajar
