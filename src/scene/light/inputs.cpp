#include "scene/light/inputs.h"

namespace ajar {
namespace {

constexpr WarningKind kNotTurned{Effect::Light,
                                 "lights have transforms that cannot be inverted in single "
                                 "precision: their rotation is ignored"};

}  // namespace

LightInputs::LightInputs(const desc::Light& description, const BoundingSphere& bounds,
                         Warnings& warnings)
    : description_(description),
      bounds_(bounds),
      warnings_(warnings),
      at_{transform_point(description.to_world, Vec3(0.F)), DirectionMap()} {
  if (DirectionMap::invertible(description.to_world)) {
    at_.directions = DirectionMap(description.to_world);
  } else {
    warnings.add(kNotTurned, description.where,
                 "the transform of the light cannot be inverted in single precision; its rotation "
                 "is ignored");
  }
}

std::optional<Map> LightInputs::map(std::string_view name, MapEdge edge) const {
  const std::string& path = node().text(name);
  if (path.empty()) return std::nullopt;
  return load_map(path, edge, description_.where, warnings_);
}

}  // namespace ajar
