#pragma once
#include <memory>
#include <vector>

#include "scene/desc/declare.h"
#include "scene/desc/node.h"
#include "scene/texture/texture.h"

namespace ajar {

class TextureInputs;

/// A model of textures: its description and how it is made.
struct TextureModel {
  desc::Model model;
  std::unique_ptr<const Texture> (*make)(const TextureInputs& inputs);
  /// True if it evaluates just one of the textures it refers to, at any point.
  bool chooses = false;
};

/// All models. `desc::models` gives their descriptions to code that does not render.
const std::vector<TextureModel>& texture_models();

/// The usual `TextureModel::make`.
template <typename Made>
std::unique_ptr<const Texture> make_texture(const TextureInputs& inputs) {
  return std::make_unique<Made>(inputs);
}

}  // namespace ajar
