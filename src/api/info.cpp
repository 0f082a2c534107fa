#include "ajar/info.h"

#include <algorithm>
#include <map>

#include "api/contents.h"
#include "import/code/scene_changes.h"
#include "integrator/integrator.h"
#include "session/scenes/catalog.h"
#include "session/version.h"

namespace ajar::v0 {

std::string version() { return ajar::version(); }

std::vector<Choice> integrators() {
  std::vector<Choice> choices;
  for (const IntegratorInfo& info : ajar::integrators()) {
    choices.push_back({info.name, info.summary});
  }
  return choices;
}

std::vector<Choice> builtin_scenes() {
  std::vector<Choice> choices;
  for (const CatalogEntry& scene : scene_catalog()) choices.push_back({scene.name, scene.summary});
  return choices;
}

std::string catalog(const std::string& kind) {
  return with_public_errors([&] {
    const std::vector<std::string>& kinds = catalog_kinds();
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
      throw UsageError(unknown_name_message("kind", kind, kinds));
    }
    return json_text(catalog_json(kind));
  });
}

void check_node(const std::string& kind, const std::string& node) {
  static const std::map<std::string, desc::ModelKind> kKinds = {
      {"material", desc::ModelKind::Material},
      {"texture", desc::ModelKind::Texture},
      {"light", desc::ModelKind::Light},
      {"emission", desc::ModelKind::Emission},
      {"shape", desc::ModelKind::Shape}};
  with_public_errors([&] {
    const auto found = kKinds.find(kind);
    if (found != kKinds.end()) return ajar::check_node(found->second, node);
    std::vector<std::string> names;
    for (const auto& [known, model_kind] : kKinds) names.push_back(known);
    throw UsageError(unknown_name_message("kind", kind, names));
  });
}

}  // namespace ajar::v0
