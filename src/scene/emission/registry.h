#pragma once
#include <memory>
#include <vector>

#include "scene/desc/declare.h"
#include "scene/desc/node.h"
#include "scene/light/light.h"

namespace ajar {

class EmissionInputs;

/// A model of light that leaves surfaces: what can be said of it and how it is made.
struct EmissionModel {
  desc::Model model;
  std::unique_ptr<Light> (*make)(const EmissionInputs& inputs);
};

/// Every model there is. `desc::models` makes their descriptions known to those who do not render.
const std::vector<EmissionModel>& emission_models();

}  // namespace ajar
