#include "scene/shape/build_shape.h"

#include <algorithm>

#include "scene/shape/inputs.h"

namespace ajar {
namespace {

const ShapeModel& model_of(const desc::Shape& shape) {
  const std::vector<ShapeModel>& models = shape_models();
  const auto model = std::find_if(models.begin(), models.end(), [&](const ShapeModel& registered) {
    return shape.node.is(registered.model.name);
  });
  if (model == models.end()) throw SceneError(shape.where, "this shape has no model");
  return *model;
}

}  // namespace

BuiltShape build_shape(desc::Shape& shape, const Placement& placement, Warnings& warnings) {
  return model_of(shape).make(ShapeInputs(shape, placement, warnings));
}

std::uint64_t shape_memory(const desc::Shape& shape) {
  const ShapeModel& model = model_of(shape);
  return model.memory == nullptr ? 0 : model.memory(shape);
}

}  // namespace ajar
