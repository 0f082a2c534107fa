#pragma once
#include <memory>
#include <vector>

#include "scene/desc/declare.h"
#include "scene/desc/node.h"
#include "scene/light/light.h"

namespace ajar {

class EmissionInputs;

/// A model of emission from surfaces: its description and how it is made.
struct EmissionModel {
  desc::Model model;
  std::unique_ptr<Light> (*make)(const EmissionInputs& inputs);
};

/// All models. `desc::models` gives their descriptions to code that does not render.
const std::vector<EmissionModel>& emission_models();

}  // namespace ajar
