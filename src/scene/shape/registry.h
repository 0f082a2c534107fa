#pragma once
#include <cstdint>
#include <vector>

#include "scene/desc/declare.h"
#include "scene/desc/node.h"
#include "scene/shape/build_shape.h"

namespace ajar {

class ShapeInputs;

/// A model of shapes: what can be said of it and how it is made.
struct ShapeModel {
  desc::Model model;
  BuiltShape (*make)(const ShapeInputs& inputs);
  /// As `shape_memory`; null if it is next to nothing.
  std::uint64_t (*memory)(const desc::Shape& shape) = nullptr;
};

/// Every model there is. `desc::models` makes their descriptions known to those who do not render.
const std::vector<ShapeModel>& shape_models();

}  // namespace ajar
