#pragma once
#include <memory>
#include <vector>

#include "scene/desc/declare.h"
#include "scene/desc/node.h"
#include "scene/light/light.h"

namespace ajar {

class LightInputs;

/// A model of lights that are not on surfaces: its description and how it is made.
struct LightModel {
  desc::Model model;
  std::unique_ptr<Light> (*make)(const LightInputs& inputs);
};

/// All models. `desc::models` gives their descriptions to code that does not render.
const std::vector<LightModel>& light_models();

}  // namespace ajar
