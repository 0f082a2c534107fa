#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/warnings.h"
#include "import/mitsuba/definitions.h"
#include "import/mitsuba/document.h"
#include "import/mitsuba/search_path.h"
#include "import/mitsuba/spectra.h"
#include "import/mitsuba/xml_file.h"

namespace ajar::mitsuba {

/// True if elements of this tag are properties, such as "float" and "transform".
bool is_property_tag(std::string_view tag);
/// True if they are numbers or colours, which a plugin can be instead.
bool is_value_tag(std::string_view tag);

/// Reads the value of properties: numbers, colours in all their spellings, transforms.
class PropertyReader {
 public:
  PropertyReader(const XmlFile& file, Definitions& definitions, const SearchPath& files,
                 Warnings& warnings, Seen seen)
      : file_(file), definitions_(definitions), files_(files), warnings_(warnings), seen_(seen) {}

  /// Raises SceneError for values that are invalid for the tag. Nothing, after a warning, if the
  /// value is in a file that cannot be used.
  std::optional<PropertyValue> read(const pugi::xml_node& node) const;

 private:
  std::optional<desc::Rgb> read_color(const pugi::xml_node& node) const;
  std::optional<desc::Rgb> read_spectrum(const pugi::xml_node& node) const;
  std::optional<desc::Rgb> read_spectrum_file(const pugi::xml_node& node) const;
  Mat4 read_transform(const pugi::xml_node& node) const;
  Mat4 read_step(const pugi::xml_node& node) const;
  Mat4 read_matrix(const pugi::xml_node& node) const;
  Mat4 read_look_at(const pugi::xml_node& node) const;

  std::string text(const pugi::xml_node& node, const char* attribute) const;
  double number(const pugi::xml_node& node, const char* attribute, double fallback) const;
  /// From the attributes x, y and z, or from `value`.
  Vec3d triple(const pugi::xml_node& node, double fallback) const;
  /// From one attribute.
  std::optional<Vec3d> triple_in(const pugi::xml_node& node, const char* attribute) const;
  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& message) const;
  /// The message for a value that is not "a number", or of another expected kind.
  [[noreturn]] void fail_value(const pugi::xml_node& node, const char* attribute,
                               const std::string& expected) const;

  const XmlFile& file_;
  Definitions& definitions_;
  const SearchPath& files_;
  Warnings& warnings_;
  Seen seen_;  ///< conversion of its spectra
};

}  // namespace ajar::mitsuba
