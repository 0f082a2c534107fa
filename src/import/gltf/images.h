#pragma once
#include <map>
#include <optional>
#include <string>

#include "import/gltf/buffers.h"

namespace ajar::gltf {

/// The images of a file, as names for textures: paths of files, or names of embedded files, which
/// are added to the scene.
class Images {
 public:
  Images(Context& context, Buffers& buffers) : context_(context), buffers_(buffers) {}

  /// The image of an element of `images`; nothing, after a warning, if it cannot be read.
  std::optional<std::string> name_of(const Element& image);

 private:
  std::optional<std::string> find(const Element& image);
  std::string embed(const Element& image, std::string bytes, const std::string& media_type);

  Context& context_;
  Buffers& buffers_;
  std::map<std::string, std::optional<std::string>> known_;  ///< by JSON pointer
};

}  // namespace ajar::gltf
