#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>

#include "api/c/handles.h"
#include "api/c/json_text.h"
#include "api/contents.h"
#include "import/code/scene_changes.h"
#include "session/scenes/catalog.h"
#include "session/version.h"

using ajar::c::give_text;
using ajar::c::given;
using ajar::c::guarded;
using ajar::c::Json;

namespace {

/// `number`: which of the caller's, for messages.
ajar::NumberArray array_of(const ajar_array& from, size_t number) {
  const auto fail = [&](const char* message) {
    throw ajar::UsageError(fmt::format("arrays[{}] {}", number, message));
  };
  using Type = ajar::NumberArray::Type;
  static const std::map<int, Type> kTypes = {
      {AJAR_FLOAT32, Type::Float32}, {AJAR_UINT32, Type::UInt32}, {AJAR_UINT8, Type::UInt8}};
  const auto type = kTypes.find(from.type);
  if (type == kTypes.end()) fail("has none of the types of ajar/c.h");
  if (from.dimensions < 1 || from.dimensions > 3) fail("has not 1 to 3 dimensions");
  ajar::NumberArray array;
  array.type = type->second;
  array.shape.assign(from.shape, from.shape + from.dimensions);
  array.data = from.data;
  // More than there are addresses for.
  size_t left = std::numeric_limits<std::ptrdiff_t>::max() / sizeof(float);
  for (const size_t length : array.shape) {
    if (length > 0) left /= length;
  }
  if (left == 0) fail("has a shape of more numbers than there can be");
  if (from.data == nullptr && array.size() > 0) fail("has no numbers");
  return array;
}

ajar::desc::ModelKind kind_named(const std::string& name) {
  using ajar::desc::ModelKind;
  static const std::map<std::string, ModelKind> kKinds = {{"material", ModelKind::Material},
                                                          {"texture", ModelKind::Texture},
                                                          {"light", ModelKind::Light},
                                                          {"emission", ModelKind::Emission},
                                                          {"shape", ModelKind::Shape}};
  const auto found = kKinds.find(name);
  if (found != kKinds.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, kind] : kKinds) names.push_back(known);
  throw ajar::UsageError(ajar::unknown_name_message("kind", name, names));
}

}  // namespace

int ajar_c_version(void) { return AJAR_C_VERSION; }

const char* ajar_version(void) {
  static const std::string kVersion = ajar::version();
  return kVersion.c_str();
}

int ajar_catalog(const char* kind, char** json) {
  return guarded([&] {
    const std::string name = &given(kind, "kind");
    const std::vector<std::string>& kinds = ajar::catalog_kinds();
    if (std::find(kinds.begin(), kinds.end(), name) == kinds.end()) {
      throw ajar::UsageError(ajar::unknown_name_message("kind", name, kinds));
    }
    give_text(ajar::c::json_text(ajar::catalog_json(name)), json);
  });
}

int ajar_node_check(const char* kind, const char* node) {
  return guarded([&] { ajar::check_node(kind_named(&given(kind, "kind")), &given(node, "node")); });
}

int ajar_scene_load(const char* name, ajar_scene** scene) {
  return guarded([&] {
    given(scene, "scene") = nullptr;
    *scene = new ajar_scene{ajar::v0::Scene::load(&given(name, "name"))};
  });
}

int ajar_scene_change(const ajar_scene* base, const char* changes, const ajar_array* arrays,
                      size_t count, ajar_scene** scene) {
  return guarded([&] {
    given(scene, "scene") = nullptr;
    std::vector<ajar::NumberArray> numbers;
    if (count > 0) given(arrays, "arrays");
    for (size_t i = 0; i < count; ++i) numbers.push_back(array_of(arrays[i], i));
    const auto content = std::make_shared<ajar::v0::Scene::Content>();
    ajar::desc::SceneDesc description;
    if (base != nullptr) {
      const ajar::v0::Scene::Content& from = base->scene.content();
      description = from.loaded->description();
      content->name = from.name;
      content->warnings.add_all(from.warnings);
    }
    description = ajar::changed_scene(std::move(description), &given(changes, "changes"), numbers,
                                      content->warnings);
    if (base == nullptr) content->name = description.source.empty() ? "scene" : description.source;
    content->loaded = std::make_shared<ajar::LoadedScene>(std::move(description));
    *scene = new ajar_scene{ajar::v0::Scene(content)};
  });
}

int ajar_scene_information(const ajar_scene* scene, char** json) {
  return guarded([&] {
    const ajar::v0::Scene& of = given(scene, "scene").scene;
    give_text(ajar::c::json_text({{"name", of.name()},
                                  {"width", of.width()},
                                  {"height", of.height()},
                                  {"warnings", of.warnings()}}),
              json);
  });
}

int ajar_scene_parts(const ajar_scene* scene, char** json) {
  return guarded([&] {
    const ajar::v0::Scene& of = given(scene, "scene").scene;
    give_text(ajar::editable_parts(of.content().loaded->description()), json);
  });
}

void ajar_scene_free(ajar_scene* scene) { delete scene; }
