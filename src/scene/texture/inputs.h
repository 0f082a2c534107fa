#pragma once
#include <memory>
#include <string>
#include <vector>

#include "scene/texture/image_cache.h"
#include "scene/texture/registry.h"

namespace ajar {

/// The images that a texture is made of: its files, each with the parameter `channel` if it has
/// one.
std::vector<ImageRequest> image_requests(const desc::Node& node);

/// The description of one texture, with its references.
class TextureInputs {
 public:
  /// `made` are the textures before this one, `images` the files of all.
  TextureInputs(const desc::Texture& description, const TextureList& made, const ImageMap& images,
                Warnings& warnings)
      : description_(description), made_(made), images_(images), warnings_(warnings) {}

  const desc::Node& node() const { return description_.node; }
  Spectrum color(std::string_view name) const { return rgb_spectrum(node().color(name)); }
  /// The parameter of this name, a float or a colour. Raises SceneError for a texture that does not
  /// come before this one.
  TextureSlot slot(std::string_view name) const;
  /// The image of a file; null, after a warning, if it cannot be read.
  std::shared_ptr<const TexelImage> image(std::string_view name) const;

 private:
  const desc::Texture& description_;
  const TextureList& made_;
  const ImageMap& images_;
  Warnings& warnings_;
};

}  // namespace ajar
