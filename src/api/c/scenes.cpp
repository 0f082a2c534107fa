#include <fmt/format.h>

#include <map>

#include "api/c/handles.h"
#include "api/c/json_text.h"

using ajar::c::give_text;
using ajar::c::given;
using ajar::c::guarded;

namespace {

/// `number`: which of the caller's, for messages.
ajar::v0::Array array_of(const ajar_array& from, size_t number) {
  using Type = ajar::v0::Array::Type;
  static const std::map<int, Type> kTypes = {
      {AJAR_FLOAT32, Type::Float32}, {AJAR_UINT32, Type::UInt32}, {AJAR_UINT8, Type::UInt8}};
  const auto type = kTypes.find(from.type);
  if (type == kTypes.end()) {
    throw ajar::UsageError(fmt::format("arrays[{}] has none of the types of ajar/c.h", number));
  }
  ajar::v0::Array array{from.data, type->second, {}};
  // Others are refused for it.
  if (from.dimensions >= 1 && from.dimensions <= 3) {
    array.shape.assign(from.shape, from.shape + from.dimensions);
  }
  return array;
}

}  // namespace

int ajar_c_version(void) { return AJAR_C_VERSION; }

const char* ajar_version(void) {
  static const std::string kVersion = ajar::v0::version();
  return kVersion.c_str();
}

int ajar_catalog(const char* kind, char** json) {
  return guarded([&] { give_text(ajar::v0::catalog(&given(kind, "kind")), json); });
}

int ajar_node_check(const char* kind, const char* node) {
  return guarded([&] { ajar::v0::check_node(&given(kind, "kind"), &given(node, "node")); });
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
    std::vector<ajar::v0::Array> numbers;
    if (count > 0) given(arrays, "arrays");
    for (size_t i = 0; i < count; ++i) numbers.push_back(array_of(arrays[i], i));
    const char* const text = &given(changes, "changes");
    *scene = new ajar_scene{base == nullptr ? ajar::v0::Scene::describe(text, numbers)
                                            : base->scene.changed(text, numbers)};
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
  return guarded([&] { give_text(given(scene, "scene").scene.parts(), json); });
}

void ajar_scene_free(ajar_scene* scene) { delete scene; }
