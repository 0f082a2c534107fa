#include "import/mitsuba/attributes.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "core/error.h"
#include "import/common/printable.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kUnknownAttribute{Effect::Slight, "attributes are unknown and ignored"};

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
      {"spectrum", {"type", "id", "name", "value", "filename", "intent"}},
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

void check(const XmlFile& file, const pugi::xml_node& node, Warnings& warnings) {
  const auto known = attributes().find(node.name());
  if (known == attributes().end()) return;
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    const std::string name = attribute.name();
    if (std::find(known->second.begin(), known->second.end(), name) != known->second.end()) {
      continue;
    }
    const std::string nearest = nearest_name(name, known->second);
    warnings.add(kUnknownAttribute, file.where(node),
                 "<" + std::string(known->first) + "> has no attribute \"" + printable(name) +
                     "\"" + (nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?") +
                     ": ignored",
                 printable(name));
  }
}

}  // namespace

void check_attributes(const XmlFile& file, Warnings& warnings) {
  // Without calls within calls: nesting has no limit yet.
  const pugi::xml_node root = file.root();
  for (pugi::xml_node node = root; node;) {
    check(file, node, warnings);
    if (node.first_child()) {
      node = node.first_child();
      continue;
    }
    while (node != root && !node.next_sibling()) node = node.parent();
    if (node == root) return;
    node = node.next_sibling();
  }
}

}  // namespace ajar::mitsuba
