#include <cstddef>
#include <string>
#include <variant>

#include "scene/material/disney.h"
#include "scene/material/glass.h"
#include "scene/material/interface.h"
#include "scene/material/material.h"
#include "scene/material/matte.h"
#include "scene/material/metal.h"
#include "scene/material/mirror.h"
#include "scene/material/mix.h"
#include "scene/material/plastic.h"
#include "scene/material/substrate.h"
#include "scene/material/translucent.h"
#include "scene/material/uber.h"

namespace ajar {
namespace {

constexpr WarningKind kSmoothThinGlass{
    Effect::Surface,
    "materials are thin glass, which is always smooth: their roughness is ignored"};
constexpr WarningKind kTooManyLobes{
    Effect::Surface, "mixes have too many lobes: only their first materials are used"};
constexpr WarningKind kForwardMix{
    Effect::Surface, "mixes refer to materials that do not come before them: grey is used"};

/// Makes one material from its description; mixes look up those made before.
class Builder {
 public:
  Builder(const Slots& slots, const MaterialList& made, Warnings& warnings)
      : slots_(slots), made_(made), warnings_(warnings) {}

  using Result = std::unique_ptr<Material>;

  Result build(const desc::Material& description) {
    where_ = &description.where;
    Result material = std::visit([this](const auto& node) { return make(node); }, description.node);
    material->name = description.name;
    if (description.bump != desc::kNone) {
      material->bump = slots_(description.bump, 0.F);
      material->has_bump = !material->bump.is_constant();
    }
    return material;
  }

 private:
  Result make(const desc::MatteMaterial& d) { return std::make_unique<Matte>(d, slots_); }
  Result make(const desc::MirrorMaterial& d) { return std::make_unique<MirrorSurface>(d, slots_); }
  Result make(const desc::GlassMaterial& d) {
    auto glass = std::make_unique<Glass>(d, slots_);
    if (glass->ignores_roughness()) {
      warnings_.add(kSmoothThinGlass, *where_,
                    "thin glass is always smooth: its roughness is ignored");
    }
    return glass;
  }
  Result make(const desc::MetalMaterial& d) { return std::make_unique<Metal>(d, slots_); }
  Result make(const desc::PlasticMaterial& d) { return std::make_unique<Plastic>(d, slots_); }
  Result make(const desc::SubstrateMaterial& d) { return std::make_unique<Substrate>(d, slots_); }
  Result make(const desc::UberMaterial& d) { return std::make_unique<Uber>(d, slots_); }
  Result make(const desc::TranslucentMaterial& d) {
    return std::make_unique<Translucent>(d, slots_);
  }
  Result make(const desc::DisneyMaterial& d) { return std::make_unique<Disney>(d, slots_); }
  Result make(const desc::InterfaceMaterial&) { return std::make_unique<Interface>(); }
  Result make(const desc::MixMaterial& d) {
    const Material& a = find(d.a);
    const Material& b = find(d.b);
    auto mix = std::make_unique<Mix>(slots_(d.amount, 0.5F), a, b);
    if (mix->max_lobes() <= Bsdf::kMaxLobes) return mix;
    warnings_.add(kTooManyLobes, *where_,
                  "mix of too many lobes (" + std::to_string(mix->max_lobes()) + ", at most " +
                      std::to_string(Bsdf::kMaxLobes) +
                      " are possible): only its first material is used");
    const auto* nested = dynamic_cast<const FirstOfMix*>(&a);
    return std::make_unique<FirstOfMix>(nested != nullptr ? nested->first() : a);
  }

  const Material& find(desc::MaterialId id) {
    if (id >= 0 && static_cast<std::size_t>(id) < made_.size()) return *made_[id];
    static const Matte fallback{desc::MatteMaterial{}, Slots{TextureList{}}};
    warnings_.add(kForwardMix, *where_,
                  "mix refers to a material that does not come before it: grey is used");
    return fallback;
  }

  const Slots& slots_;
  const MaterialList& made_;
  Warnings& warnings_;
  const SourceLocation* where_ = nullptr;
};
}  // namespace

MaterialList build_materials(const desc::SceneDesc& scene, const TextureList& textures,
                             Warnings& warnings) {
  const Slots slots(textures);
  MaterialList materials;
  materials.reserve(scene.materials.size());
  Builder builder(slots, materials, warnings);
  for (const desc::Material& description : scene.materials) {
    materials.push_back(builder.build(description));
  }
  return materials;
}

}  // namespace ajar
