#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/warnings.h"
#include "import/mitsuba/definitions.h"
#include "import/mitsuba/document.h"
#include "import/mitsuba/search_path.h"
#include "import/mitsuba/xml_file.h"

namespace ajar::mitsuba {

/// Makes a document of the XML of a scene and of the files it includes: puts the values of
/// parameters in place, reads properties, and collects ids. Knows no plugin.
class Parser {
 public:
  /// `given` takes precedence over `<default>` in files.
  Parser(SearchPath& files, Warnings& warnings, SceneDefinitions given)
      : files_(files), warnings_(warnings), definitions_(std::move(given)) {}

  /// `name` is used in messages, `path` identifies the file. Raises SceneError.
  Document parse(std::string_view text, const std::string& name, const std::string& path);

 private:
  struct Source {
    const XmlFile& file;
    pugi::xml_node node;
  };

  /// Another name for an element that has an id.
  struct Alias {
    std::string name;
    std::string id;
    SourceLocation where;
  };

  void read_version(const XmlFile& file);
  /// Reads the content of an element.
  void read_content(const Source& source, Element& parent, int depth);
  void read_one(const Source& source, Element& parent, int depth);
  ElementPointer read_element(const Source& source, int depth);
  void include(const Source& source, Element& parent, int depth);
  void define(const Source& source);
  void add_alias(const Source& source);
  void add_path(const Source& source);
  void add_id(const std::string& id, ElementPointer element);

  /// Empty if there is no such attribute.
  std::string attribute(const Source& source, const char* name);
  /// Raises SceneError if there is no such attribute.
  std::string required(const Source& source, const char* name);

  SearchPath& files_;
  Warnings& warnings_;
  Definitions definitions_;
  Document document_;
  std::vector<Alias> aliases_;
  std::vector<std::string> open_files_;
  int files_read_ = 0;
};

}  // namespace ajar::mitsuba
