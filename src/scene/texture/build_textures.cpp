#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>

#include "scene/texture/texture_builders.h"

namespace ajar {

namespace {

constexpr WarningKind kUnreadable{Effect::Surface, "textures cannot be read, shown as magenta"};

std::vector<std::string> image_paths(const desc::SceneDesc& scene) {
  std::vector<std::string> paths;
  for (const desc::Texture& texture : scene.textures) {
    if (const auto* image = std::get_if<desc::ImageTexture>(&texture.node))
      paths.push_back(image->path);
  }
  return paths;
}

class Builder {
 public:
  Builder(const desc::SceneDesc& scene, Warnings& warnings)
      : scene_(scene), warnings_(warnings), images_(read_images(image_paths(scene))) {}

  TextureList build() {
    textures_.reserve(scene_.textures.size());
    for (const desc::Texture& texture : scene_.textures) {
      where_ = &texture.where;
      textures_.push_back(
          std::visit([this](const auto& node) { return this->make(node); }, texture.node));
      evaluations_.push_back(
          1 +
          std::visit([this](const auto& node) { return this->evaluations(node); }, texture.node));
      check_nesting();
    }
    return std::move(textures_);
  }

 private:
  template <typename Node>
  std::unique_ptr<const Texture> make(const Node& node) {
    return make_texture(node);
  }
  std::unique_ptr<const Texture> make(const desc::ScaleTexture& node) {
    check({node.a, node.b});
    return make_texture(node, textures_);
  }
  std::unique_ptr<const Texture> make(const desc::MixTexture& node) {
    check({node.a, node.b, node.amount});
    return make_texture(node, textures_);
  }
  std::unique_ptr<const Texture> make(const desc::CheckerboardTexture& node) {
    check({node.a, node.b});
    return make_texture(node, textures_);
  }
  std::unique_ptr<const Texture> make(const desc::DotsTexture& node) {
    check({node.inside, node.outside});
    return make_texture(node, textures_);
  }
  std::unique_ptr<const Texture> make(const desc::ImageTexture& node) {
    const CachedImage& cached = images_.at(node.path);
    if (!cached.image) {
      warnings_.add(kUnreadable, *where_,
                    "cannot read image \"" + node.path + "\" (" + cached.error +
                        "); it is replaced by magenta",
                    std::filesystem::path(node.path).filename().string());
    }
    return make_texture(node, cached.image);
  }

  // How many others a texture looks up at most, itself and its constants left out.
  template <typename Node>
  std::uint64_t evaluations(const Node& /*node*/) const {
    return 0;
  }
  std::uint64_t evaluations(desc::TextureId id) const {
    const auto i = static_cast<std::size_t>(id);
    return id < 0 || textures_[i]->constant() != nullptr ? 0 : evaluations_[i];
  }
  std::uint64_t evaluations(const desc::ScaleTexture& node) const {
    return evaluations(node.a) + evaluations(node.b);
  }
  std::uint64_t evaluations(const desc::MixTexture& node) const {
    return evaluations(node.a) + evaluations(node.b) + evaluations(node.amount);
  }
  std::uint64_t evaluations(const desc::CheckerboardTexture& node) const {
    return std::max(evaluations(node.a), evaluations(node.b));
  }
  std::uint64_t evaluations(const desc::DotsTexture& node) const {
    return std::max(evaluations(node.inside), evaluations(node.outside));
  }

  /// Textures of textures can double their work with every level, and each level is a call within
  /// a call.
  void check_nesting() const {
    constexpr std::uint64_t kMost = 4096;
    if (evaluations_.back() <= kMost || textures_.back()->constant() != nullptr) return;
    throw SceneError(
        *where_, "this texture of textures looks up " + std::to_string(evaluations_.back()) +
                     " others at every point; at most " + std::to_string(kMost) + " are possible");
  }

  void check(std::initializer_list<desc::TextureId> ids) const {
    for (const desc::TextureId id : ids) {
      if (id >= static_cast<desc::TextureId>(textures_.size())) {
        throw SceneError(*where_, "a texture refers to one that is not yet defined");
      }
    }
  }

  const desc::SceneDesc& scene_;
  Warnings& warnings_;
  std::map<std::string, CachedImage> images_;
  TextureList textures_;
  std::vector<std::uint64_t> evaluations_;  ///< of textures, themselves included
  const SourceLocation* where_ = nullptr;
};

}  // namespace

TextureList build_textures(const desc::SceneDesc& scene, Warnings& warnings) {
  return Builder(scene, warnings).build();
}

}  // namespace ajar
