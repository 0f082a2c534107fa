#include "import/mitsuba/xml_file.h"

#include <algorithm>

namespace ajar::mitsuba {

XmlFile::XmlFile(std::string_view text, const std::string& name)
    : file_(std::make_shared<const std::string>(name)), size_(text.size()), line_starts_{0} {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') line_starts_.push_back(i + 1);
  }
  const pugi::xml_parse_result result = document_.load_buffer(text.data(), text.size());
  if (!result) {
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
    throw SceneError(at(offset),
                     std::string("this is not well-formed XML: ") + result.description());
  }
  if (!root()) throw SceneError(end(), "there is no XML element in this file");
}

SourceLocation XmlFile::where(const pugi::xml_node& node) const {
  // pugixml gives the place of the name, behind the "<".
  return at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug() - 1, 0)));
}

SourceLocation XmlFile::at(std::size_t offset) const {
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  const auto line = static_cast<std::size_t>(after - line_starts_.begin());
  const std::size_t column = offset - line_starts_[line - 1] + 1;
  return {file_, static_cast<int>(line), static_cast<int>(column)};
}

}  // namespace ajar::mitsuba
