#include <algorithm>
#include <cstdint>
#include <string>

#include "scene/texture/inputs.h"

namespace ajar {

namespace {

ImageMap images_of(const desc::SceneDesc& scene) {
  std::vector<ImageRequest> requests;
  for (const desc::Texture& texture : scene.textures) {
    for (ImageRequest& request : image_requests(texture.node)) {
      requests.push_back(std::move(request));
    }
  }
  return read_images(requests, scene.embedded_files);
}

const TextureModel& model_of(const desc::Texture& texture) {
  const std::vector<TextureModel>& models = texture_models();
  const auto found = std::find_if(models.begin(), models.end(), [&](const TextureModel& model) {
    return texture.node.is(model.model.name);
  });
  if (found == models.end()) throw SceneError(texture.where, "this texture has no model");
  return *found;
}

class Builder {
 public:
  Builder(const desc::SceneDesc& scene, Warnings& warnings)
      : scene_(scene), warnings_(warnings), images_(images_of(scene)) {}

  TextureList build() {
    textures_.reserve(scene_.textures.size());
    for (const desc::Texture& texture : scene_.textures) {
      const TextureModel& model = model_of(texture);
      textures_.push_back(model.make(TextureInputs(texture, textures_, images_, warnings_)));
      evaluations_.push_back(1 + evaluations(texture.node, model.chooses));
      check_nesting(texture.where);
    }
    return std::move(textures_);
  }

 private:
  /// Largest number of other textures that a texture looks up, itself and its constants left out.
  std::uint64_t evaluations(const desc::Node& node, bool chooses) const {
    std::uint64_t all = 0;
    std::uint64_t most = 0;
    for (const desc::Value& value : node.values()) {
      const auto* texture = std::get_if<desc::TextureRef>(&value);
      if (texture == nullptr) continue;
      const auto i = static_cast<std::size_t>(texture->id);
      if (textures_[i]->constant() != nullptr) continue;
      all += evaluations_[i];
      most = std::max(most, evaluations_[i]);
    }
    return chooses ? most : all;
  }

  /// Textures of textures can double their work with every level, and each level is a call within
  /// a call.
  void check_nesting(const SourceLocation& where) const {
    constexpr std::uint64_t kMost = 4096;
    if (evaluations_.back() <= kMost || textures_.back()->constant() != nullptr) return;
    throw SceneError(
        where, "this texture of textures looks up " + std::to_string(evaluations_.back()) +
                   " others at every point; at most " + std::to_string(kMost) + " are possible");
  }

  const desc::SceneDesc& scene_;
  Warnings& warnings_;
  ImageMap images_;
  TextureList textures_;
  std::vector<std::uint64_t> evaluations_;  ///< evaluations of textures, themselves included
};

}  // namespace

TextureList build_textures(const desc::SceneDesc& scene, Warnings& warnings) {
  return Builder(scene, warnings).build();
}

}  // namespace ajar
