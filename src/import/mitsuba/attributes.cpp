#include "import/mitsuba/attributes.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/printable_text.h"
#include "import/mitsuba/property_reader.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kUnknownAttribute{Effect::Slight, "attributes are unknown and ignored"};
constexpr WarningKind kTwoValues{Effect::Surface,
                                 "values are given in two ways: one of them is ignored"};
constexpr WarningKind kMisplaced{Effect::Slight,
                                 "elements are in others that have none in them: ignored"};

using Names = std::vector<std::string>;

const std::map<std::string_view, Names>& attributes() {
  static const Names kPlugin = {"type", "id", "name"};
  static const Names kValue = {"name", "value"};
  static const Names kColor = {"name", "value", "intent"};
  static const Names kTriple = {"name", "value", "x", "y", "z"};
  static const std::map<std::string_view, Names> kAttributes = {
      {"scene", {"version", "type", "id", "name"}},
      {"bsdf", kPlugin},
      {"emitter", kPlugin},
      {"luminaire", kPlugin},
      {"film", kPlugin},
      {"integrator", kPlugin},
      {"medium", kPlugin},
      {"phase", kPlugin},
      {"rfilter", kPlugin},
      {"sampler", kPlugin},
      {"sensor", kPlugin},
      {"camera", kPlugin},
      {"shape", kPlugin},
      {"subsurface", kPlugin},
      {"texture", kPlugin},
      {"volume", kPlugin},
      {"spectrum", {"name", "value", "filename", "intent"}},
      {"boolean", kValue},
      {"integer", kValue},
      {"float", kValue},
      {"string", kValue},
      {"color", kColor},
      {"rgb", kColor},
      {"srgb", kColor},
      {"xyz", kColor},
      {"blackbody", {"name", "temperature", "scale"}},
      {"vector", kTriple},
      {"point", kTriple},
      {"transform", {"name", "id", "time"}},
      {"animation", {"name", "id"}},
      {"translate", {"value", "x", "y", "z"}},
      {"scale", {"value", "x", "y", "z"}},
      {"rotate", {"value", "x", "y", "z", "angle"}},
      {"matrix", {"value"}},
      {"lookat", {"origin", "target", "up"}},
      {"lookAt", {"origin", "target", "up"}},
      {"look_at", {"origin", "target", "up"}},
      {"ref", {"id", "name"}},
      {"default", kValue},
      {"include", {"filename"}},
      {"alias", {"id", "as"}},
      {"path", {"value"}}};
  return kAttributes;
}

bool has(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void check_names(const XmlFile& file, const pugi::xml_node& node, const Names& names,
                 Warnings& warnings) {
  const bool is_typed = is_value_tag(node.name());
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    const std::string name = attribute.name();
    if (has(names, name) || (is_typed && (name == "type" || name == "id"))) continue;
    const std::string nearest = nearest_name(name, names);
    warnings.add(kUnknownAttribute, file.where(node),
                 "<" + std::string(node.name()) + "> has no attribute \"" + printable(name) + "\"" +
                     (nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?") + ": ignored",
                 printable(name));
  }
}

/// Warns of attributes that duplicate another one, which counts.
void check_rivals(const XmlFile& file, const pugi::xml_node& node, const Names& names,
                  Warnings& warnings) {
  const auto check = [&](const char* counts, std::initializer_list<const char*> others) {
    if (!node.attribute(counts)) return false;
    for (const char* other : others) {
      if (!node.attribute(other)) continue;
      warnings.add(kTwoValues, file.where(node),
                   "<" + std::string(node.name()) + "> has \"" + counts + "\" and \"" + other +
                       "\": the latter is ignored",
                   other);
    }
    return true;
  };
  if (has(names, "x")) check("value", {"x", "y", "z"});
  if (is_value_tag(node.name()) && check("type", {"filename", "value"})) return;
  if (has(names, "filename")) check("filename", {"value"});
}

/// True if an element has a meaning in its parent.
bool is_in_place(const pugi::xml_node& node) {
  static const std::set<std::string_view> kWithoutElements = {
      "boolean", "integer", "float",    "string", "vector",  "point",     "rgb",     "srgb",
      "xyz",     "color",   "spectrum", "ref",    "default", "alias",     "path",    "include",
      "matrix",  "lookat",  "lookAt",   "scale",  "rotate",  "translate", "look_at", "blackbody"};
  const pugi::xml_node parent = node.parent();
  const std::string_view name = parent.name();
  if (name == "animation") return node.name() == std::string_view("transform");
  if (is_value_tag(name) && parent.attribute("type")) return true;
  return kWithoutElements.count(name) == 0;
}

/// True if the content of the element is to be checked, too.
bool check(const XmlFile& file, const pugi::xml_node& node, Warnings& warnings) {
  if (node.type() != pugi::node_element) return false;
  if (!is_in_place(node)) {
    warnings.add(kMisplaced, file.where(node),
                 "<" + printable(node.parent().name()) + "> has no <" + printable(node.name()) +
                     "> in it: ignored",
                 printable(node.name()));
    return false;
  }
  const auto known = attributes().find(node.name());
  if (known == attributes().end()) return true;
  check_names(file, node, known->second, warnings);
  check_rivals(file, node, known->second, warnings);
  return true;
}

}  // namespace

void check_attributes(const XmlFile& file, Warnings& warnings) {
  // Without calls within calls: nesting has no limit yet.
  const pugi::xml_node root = file.root();
  for (pugi::xml_node node = root; node;) {
    if (check(file, node, warnings) && node.first_child()) {
      node = node.first_child();
      continue;
    }
    while (node != root && !node.next_sibling()) node = node.parent();
    if (node == root) return;
    node = node.next_sibling();
  }
}

}  // namespace ajar::mitsuba
