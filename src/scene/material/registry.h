#pragma once
#include <memory>
#include <vector>

#include "scene/desc/declare.h"
#include "scene/desc/node.h"
#include "scene/material/material.h"

namespace ajar {

class MaterialInputs;

/// A model of materials: its description and how it is made.
struct MaterialModel {
  desc::Model model;
  std::unique_ptr<Material> (*make)(const MaterialInputs& inputs);
};

/// All models. `desc::models` gives their descriptions to code that does not render.
const std::vector<MaterialModel>& material_models();

/// The usual `MaterialModel::make`.
template <typename Made>
std::unique_ptr<Material> make(const MaterialInputs& inputs) {
  return std::make_unique<Made>(inputs);
}

}  // namespace ajar
