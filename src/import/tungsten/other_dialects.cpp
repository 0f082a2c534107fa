#include "import/tungsten/other_dialects.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "import/tungsten/context.h"
#include "import/tungsten/primitives.h"

namespace ajar::tungsten {
namespace {

using Kind = LocatedJson::Kind;

/// A program whose scenes have these members: "a.b" is b of the object a.
struct Dialect {
  std::string_view program;
  std::vector<std::string_view> members;
};

/// The surest signs first. Sources: the programs' documentation and example scenes.
const std::vector<Dialect>& dialects() {
  static const std::vector<Dialect> kAll = {
      {"glTF, which is told by the name of its file", {"asset.version", "accessors"}},
      {"glTF, which is told by the name of its file", {"asset.version", "nodes"}},
      {"Yocto/GL", {"asset", "instances"}},
      {"Yocto/GL", {"asset", "environments"}},
      {"Yocto/GL", {"asset", "cameras"}},
      {"Yocto/GL", {"cameras", "environments"}},
      {"Yocto/GL", {"cameras", "subdivs"}},
      {"three.js", {"metadata", "geometries"}},
      {"three.js", {"metadata", "object"}},
      {"three.js", {"metadata", "scene"}},
      {"three.js", {"project", "scene"}},
      {"three.js", {"camera.metadata"}},
      {"Babylon.js", {"activeCameraID"}},
      {"Babylon.js", {"autoClear", "meshes"}},
      {"Babylon.js", {"producer", "meshes"}},
      {"Falcor", {"active_camera"}},
      {"Falcor", {"camera_speed"}},
      {"Falcor", {"models", "lights"}},
      {"Falcor", {"models", "cameras"}},
      {"SeeSharp", {"transforms", "objects"}},
      {"Lightmetrica", {"lightmetrica"}},
      {"Lightmetrica", {"assets", "renderer"}},
      {"Lightmetrica", {"assets", "scene"}},
      {"Lightmetrica", {"assets", "nodes"}},
      {"OSPRay Studio", {"materialRegistry"}},
      {"OSPRay Studio", {"lightsManager"}},
      {"LuisaRender", {"render.cameras"}},
      {"Vision", {"camera.param"}},
      {"Cycles", {"cycles"}},
      {"Cycles", {"shaders", "background"}},
      {"Cycles", {"camera", "shaders"}},
      {"Mitsuba, which is read from files named .xml", {"sensor"}},
      {"Darts or DIRT", {"surfaces", "camera"}},
      {"Nori", {"camera", "meshes"}},
      {"Nori", {"camera", "mesh"}},
      {"Assimp", {"rootnode"}}};
  return kAll;
}

std::optional<LocatedJson> find_path(const LocatedJson& root, std::string_view path) {
  if (!root.is(Kind::Object)) return std::nullopt;
  const std::size_t dot = path.find('.');
  auto found = root.find(path.substr(0, dot));
  if (!found || dot == std::string_view::npos) return found;
  return find_path(*found, path.substr(dot + 1));
}

std::optional<std::string_view> program_of(const LocatedJson& root) {
  for (const Dialect& dialect : dialects()) {
    const bool fits = std::all_of(dialect.members.begin(), dialect.members.end(),
                                  [&](auto path) { return find_path(root, path).has_value(); });
    if (fits) return dialect.program;
  }
  return std::nullopt;
}

/// The maker that a file names.
std::optional<LocatedJson> maker_in(const LocatedJson& root) {
  for (const char* path : {"generator", "asset.generator", "metadata.generator", "exporter",
                           "metadata.exporter", "producer.name", "software", "tool"}) {
    auto maker = find_path(root, path);
    if (maker && maker->is(Kind::Text)) return maker;
  }
  return std::nullopt;
}

template <typename Names>
bool has_any(const LocatedJson& object, const Names& names) {
  return object.is(Kind::Object) && std::any_of(std::begin(names), std::end(names),
                                                [&](const auto& name) { return object.has(name); });
}

constexpr std::array<std::string_view, 6> kMembers = {"primitives", "bsdfs",      "camera",
                                                      "media",      "integrator", "renderer"};

/// Members that hold something, and that Tungsten does not have.
std::string foreign_members(const LocatedJson& root) {
  std::string names;
  for (const LocatedJson::Member& member : root.members()) {
    const bool holds = member.value.is(Kind::Object) || member.value.is(Kind::Array);
    if (!holds || std::find(kMembers.begin(), kMembers.end(), member.name) != kMembers.end()) {
      continue;
    }
    names += (names.empty() ? "\"" : ", \"") + printable(member.name) + "\"";
  }
  return names;
}

/// True for a primitive of Tungsten: of one of its types, with at least one member of a known name.
bool is_primitive(const LocatedJson& json) {
  constexpr std::array<std::string_view, 15> kWords = {
      "transform", "bsdf",       "emission",   "power",       "file",
      "masters",   "int_medium", "ext_medium", "temperature", "cone_angle",
      "turbidity", "cap_angle",  "curve_type", "bump",        "smooth"};
  const std::string type = type_of(json);
  if (type.empty()) return false;
  const bool is_known = is_primitive_type(type);
  const std::size_t plain = json.has("name") ? 2 : 1;
  return has_any(json, kWords) || (is_known && json.members().size() == plain);
}

/// The reason why it is no scene of Tungsten; empty if it is one.
std::string complaint(const LocatedJson& root) {
  constexpr std::array<std::string_view, 3> kParts = {"primitives", "bsdfs", "camera"};
  constexpr std::array<std::string_view, 5> kOfCameras = {"type", "transform", "resolution", "fov",
                                                          "medium"};
  if (!has_any(root, kParts)) {
    return "it has none of \"primitives\", \"bsdfs\" and \"camera\"";
  }
  if (root.has("bsdfs")) return {};
  if (const std::string names = foreign_members(root); !names.empty()) {
    return "it has no \"bsdfs\", but " + names;
  }
  const auto primitives = root.find("primitives");
  const auto camera = root.find("camera");
  const bool has_list = primitives && primitives->is(Kind::Array);
  const auto list = has_list ? primitives->items() : std::vector<LocatedJson>();
  if (!list.empty() && std::none_of(list.begin(), list.end(), is_primitive)) {
    return "none of its \"primitives\" has what those of Tungsten have, as \"bsdf\" and "
           "\"transform\"";
  }
  if (!primitives && camera && camera->is(Kind::Object) && !camera->members().empty() &&
      !has_any(*camera, kOfCameras)) {
    return "its \"camera\" has nothing that Tungsten's has, as \"transform\" and \"fov\"";
  }
  return {};
}

}  // namespace

void require_scene(const LocatedJson& root) {
  const std::string reason = complaint(root);
  if (reason.empty()) return;
  std::string message = "this is no scene of Tungsten: " + reason;
  if (const auto program = program_of(root)) {
    message += "; it looks like one of " + std::string(*program);
  }
  if (const auto maker = maker_in(root)) {
    message += "; it says that it was made by \"" + printable(maker->text()) + "\"";
  }
  throw SceneError(root.where(), message);
}

}  // namespace ajar::tungsten
