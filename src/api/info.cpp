#include "ajar/info.h"

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

}  // namespace ajar::v0
