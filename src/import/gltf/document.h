#pragma once
#include <string>
#include <string_view>

#include "core/located_json.h"

namespace ajar::gltf {

/// A value of a file. Places in a .glb count from its JSON.
using Element = LocatedJson;

/// A parsed file.
struct Document {
  Element root;
  std::string_view binary;  ///< the chunk of a .glb that buffers refer to without a URI
};

/// The member `name` of the member `extensions`.
std::optional<Element> extension_of(const Element& element, std::string_view name);
/// The element of the array `name` of `root` that `number` is the number of.
Element referred(const Element& number, const Element& root, std::string_view name);

/// Parses JSON text, or a .glb container, recognised by its first bytes. Views of `bytes` are kept.
/// Raises SceneError, with line and column, if it is neither, or not of glTF 2.
Document parse_document(std::string_view bytes, const std::string& name);

}  // namespace ajar::gltf
