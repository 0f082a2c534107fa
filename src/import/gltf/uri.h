#pragma once
#include <optional>
#include <string>

#include "import/gltf/document.h"

namespace ajar::gltf {

/// Data or file of a URI.
struct UriTarget {
  std::optional<std::string> data;  ///< content of a "data:" URI
  std::string media_type;           ///< its media type; may be empty
  std::string file;                 ///< else: a path relative to the file, decoded
};

/// Raises SceneError for damaged data, IoError, with the reason, for other schemes than "data:".
UriTarget target_of(const Element& uri);

/// Decodes base64 (RFC 4648, section 4; padding may lack); nothing if it is damaged.
std::optional<std::string> decode_base64(std::string_view text);

}  // namespace ajar::gltf
