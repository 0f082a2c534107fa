#pragma once
#include <string>
#include <string_view>

#include "import/gltf/element.h"

namespace ajar::gltf {

/// A parsed file.
struct Document {
  std::shared_ptr<const Origin> origin;
  Json json;
  std::string_view binary;  ///< the chunk of a .glb that buffers refer to without a URI
  Element root() const { return {json, origin, ""}; }
};

/// Parses JSON text, or a .glb container, recognised by its first bytes. Views of `bytes` are kept.
/// Raises SceneError, with line and column, if it is neither, or not of glTF 2.
Document parse_document(std::string_view bytes, const std::string& name);

}  // namespace ajar::gltf
