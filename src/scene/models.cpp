#include "scene/desc/models.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "scene/emission/registry.h"
#include "scene/light/registry.h"
#include "scene/material/registry.h"
#include "scene/shape/registry.h"
#include "scene/texture/registry.h"

namespace ajar::desc {
namespace {

template <typename Registered>
std::vector<const Model*> sorted(const std::vector<Registered>& registry) {
  std::vector<const Model*> models;
  for (const Registered& registered : registry) models.push_back(&registered.model);
  std::sort(models.begin(), models.end(),
            [](const Model* a, const Model* b) { return a->name < b->name; });
  return models;
}

}  // namespace

const std::vector<const Model*>& models(ModelKind kind) {
  static const std::vector<const Model*> kMaterials = sorted(material_models());
  static const std::vector<const Model*> kTextures = sorted(texture_models());
  static const std::vector<const Model*> kLights = sorted(light_models());
  static const std::vector<const Model*> kEmissions = sorted(emission_models());
  static const std::vector<const Model*> kShapes = sorted(shape_models());
  switch (kind) {
    case ModelKind::Material:
      return kMaterials;
    case ModelKind::Texture:
      return kTextures;
    case ModelKind::Light:
      return kLights;
    case ModelKind::Emission:
      return kEmissions;
    case ModelKind::Shape:
      return kShapes;
  }
  throw std::logic_error("there is no such kind of models");
}

const Model* find_model(ModelKind kind, std::string_view name) {
  const std::vector<const Model*>& all = models(kind);
  const auto found = std::lower_bound(
      all.begin(), all.end(), name,
      [](const Model* model, std::string_view wanted) { return model->name < wanted; });
  return found != all.end() && (*found)->name == name ? *found : nullptr;
}

Node make_node(ModelKind kind, std::string_view name, Node::Given given) {
  if (const Model* model = find_model(kind, name)) return Node(*model, given);
  throw std::logic_error("there is no model \"" + std::string(name) + "\"");
}

}  // namespace ajar::desc
