#pragma once
#include <memory>
#include <vector>

#include "scene/desc/declare.h"
#include "scene/desc/node.h"
#include "scene/light/light.h"

namespace ajar {

class LightInputs;

/// A model of lights that are not on surfaces: what can be said of it and how it is made.
struct LightModel {
  desc::Model model;
  std::unique_ptr<Light> (*make)(const LightInputs& inputs);
};

/// Every model there is. `desc::models` makes their descriptions known to those who do not render.
const std::vector<LightModel>& light_models();

}  // namespace ajar
