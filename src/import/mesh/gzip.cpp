#include "import/mesh/gzip.h"

#include "import/mesh/inflate.h"

namespace ajar {

bool is_gzip(std::string_view bytes) {
  return bytes.size() >= 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b';
}

std::optional<std::string> gunzip(std::string_view bytes, std::size_t max_size) {
  return inflate_stream(bytes, StreamKind::Gzip, max_size);
}

}  // namespace ajar
