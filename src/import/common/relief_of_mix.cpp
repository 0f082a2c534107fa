#include "import/common/relief_of_mix.h"

namespace ajar {
namespace {

constexpr WarningKind kTwoReliefs{
    Effect::Surface,
    "mixes have parts with different bump or normal maps: those of one part count for both"};

/// Mixes this deep have more lobes than surfaces can have, of which scenes warn.
constexpr int kDeepestMix = 100;

/// Material with the relief that a mix shows where this is its first part.
const desc::Material& relief_of(const desc::SceneDesc& scene, desc::MaterialId id) {
  const desc::Material* material = &scene.materials[static_cast<std::size_t>(id)];
  for (int depth = 0; depth < kDeepestMix; ++depth) {
    if (!material->node.is("mix") || material->has_relief()) break;
    material = &scene.materials[static_cast<std::size_t>(material->node.material("first"))];
  }
  return *material;
}

bool is_same(const desc::SceneDesc& scene, desc::TextureId a, desc::TextureId b) {
  if (a == b || a == desc::kNone || b == desc::kNone) return a == b;
  const auto node = [&](desc::TextureId id) -> const desc::Node& {
    return scene.textures[static_cast<std::size_t>(id)].node;
  };
  return node(a) == node(b);
}

}  // namespace

void check_relief_of_mix(const desc::SceneDesc& scene, desc::MaterialId first,
                         desc::MaterialId second, const SourceLocation& where, Warnings& warnings) {
  const desc::Material& a = relief_of(scene, first);
  const desc::Material& b = relief_of(scene, second);
  if (a.node.is("interface") || b.node.is("interface")) return;  // interfaces have no relief
  if (is_same(scene, a.bump, b.bump) &&
      is_same(scene, a.normal_map.texture, b.normal_map.texture) &&
      a.normal_map.strength == b.normal_map.strength) {
    return;
  }
  const std::string& name = scene.materials[static_cast<std::size_t>(first)].name;
  warnings.add(kTwoReliefs, where,
               "the parts of this mix differ in their bump or normal map: that of " +
                   (name.empty() ? std::string("one of them") : "\"" + name + "\"") +
                   " counts for both");
}

}  // namespace ajar
