#include "imageio/image_complaint.h"

#include <algorithm>

namespace ajar {

std::string image_complaint(std::string_view text) {
  std::string line;
  std::string_view before;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view part = text.substr(0, end);
    if (!part.empty() && part != before) line.append(line.empty() ? "" : "; ").append(part);
    before = part;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return line.empty() ? "the image cannot be read" : line;
}

}  // namespace ajar
