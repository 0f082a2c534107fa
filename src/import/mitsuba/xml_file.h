#pragma once
#include <memory>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace ajar::mitsuba {

/// An XML text with places. DOCTYPEs are skipped, so that there are no entities but the five that
/// XML itself has, and nothing else is read.
class XmlFile {
 public:
  /// `name` stands in messages. Raises SceneError, with line and column, if it is not well formed.
  XmlFile(std::string_view text, const std::string& name);

  pugi::xml_node root() const { return document_.document_element(); }
  /// Location of the "<" of an element.
  SourceLocation where(const pugi::xml_node& node) const;
  SourceLocation end() const { return at(size_); }

 private:
  SourceLocation at(std::size_t offset) const;

  std::shared_ptr<const std::string> file_;
  std::size_t size_;
  std::vector<std::size_t> line_starts_;
  pugi::xml_document document_;
};

}  // namespace ajar::mitsuba
