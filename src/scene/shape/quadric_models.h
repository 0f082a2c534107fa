#pragma once
#include <optional>
#include <vector>

#include "scene/desc/node.h"
#include "scene/shape/quadric.h"

namespace ajar {

/// A model of quadrics: what can be said of it and how it is made, as `Quadric::make` makes it.
struct QuadricModel {
  desc::Model model;
  std::optional<Quadric> (*make)(const desc::Node& node);
};

/// Every model there is. `desc::models` makes their descriptions known to those who do not render.
const std::vector<QuadricModel>& quadric_models();

}  // namespace ajar
