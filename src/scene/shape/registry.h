#pragma once
#include <cstdint>
#include <vector>

#include "scene/desc/declare.h"
#include "scene/desc/node.h"
#include "scene/shape/build_shape.h"

namespace ajar {

class ShapeInputs;

/// A model of shapes: its description and how it is made.
struct ShapeModel {
  desc::Model model;
  BuiltShape (*make)(const ShapeInputs& inputs);
  /// Memory like `shape_memory`; null if it is next to nothing.
  std::uint64_t (*memory)(const desc::Shape& shape) = nullptr;
};

/// All models. `desc::models` gives their descriptions to code that does not render.
const std::vector<ShapeModel>& shape_models();

}  // namespace ajar
