#include "import/common/relief_of_mix.h"

#include <utility>

namespace ajar {
namespace {

constexpr WarningKind kTwoReliefs{
    Effect::Surface,
    "mixes have parts with different bump or normal maps: those of one part count for both"};

/// The textures of its bump and its normals.
std::pair<desc::TextureId, desc::TextureId> relief_of(const desc::SceneDesc& scene,
                                                      desc::MaterialId id) {
  const desc::Material* material = &scene.materials[static_cast<std::size_t>(id)];
  while (material->node.is("mix") && !material->has_relief()) {
    material = &scene.materials[static_cast<std::size_t>(material->node.material("first"))];
  }
  return {material->bump, material->normal_map.texture};
}

}  // namespace

void check_relief_of_mix(const desc::SceneDesc& scene, desc::MaterialId first,
                         desc::MaterialId second, const SourceLocation& where, Warnings& warnings) {
  if (relief_of(scene, first) == relief_of(scene, second)) return;
  const std::string& name = scene.materials[static_cast<std::size_t>(first)].name;
  warnings.add(kTwoReliefs, where,
               "the parts of this mix differ in their bump or normal map: that of " +
                   (name.empty() ? std::string("one of them") : "\"" + name + "\"") +
                   " counts for both");
}

}  // namespace ajar
