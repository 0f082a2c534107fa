#include "import/pbrt/materials.h"

#include <algorithm>

#include "import/pbrt/metals.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kStandIn{Effect::Surface, "materials are not supported: matte ones stand in"};
constexpr WarningKind kNoSubsurface{
    Effect::Surface, "disney materials have subsurface scattering, which is not supported"};

using Parameters = TextureParameters;

const std::vector<std::string> kTypes = {
    "matte",  "mirror", "glass", "metal",   "plastic", "substrate",  "uber",        "translucent",
    "disney", "mix",    "none",  "fourier", "hair",    "subsurface", "kdsubsurface"};

// Defaults of all parameters: pbrt-v3, src/materials/*.cpp.

desc::MatteMaterial matte(const Parameters& p) {
  return {p.spectrum("Kd", 0.5F), p.number("sigma", 0.F)};
}

desc::GlassMaterial glass(const Parameters& p) {
  desc::GlassMaterial m;
  m.kr = p.spectrum("Kr", 1.F);
  m.kt = p.spectrum("Kt", 1.F);
  const std::optional<desc::TextureId> eta = p.find_number("eta");
  m.eta = eta ? *eta : p.number("index", 1.5F);
  m.u_roughness = p.number("uroughness", 0.F);
  m.v_roughness = p.number("vroughness", 0.F);
  m.remap_roughness = p.flag("remaproughness", true);
  m.thin = p.flag("thin", false);
  return m;
}

desc::MetalMaterial metal(const SourceLocation& where, const Parameters& p) {
  static const desc::Rgb kCopperEta(*metal_rgb("Cu", MetalQuantity::Eta));
  static const desc::Rgb kCopperK(*metal_rgb("Cu", MetalQuantity::K));
  desc::MetalMaterial m;
  m.eta = p.spectrum("eta", kCopperEta);
  m.k = p.spectrum("k", kCopperK);
  const desc::TextureId roughness = p.number("roughness", 0.01F);
  m.u_roughness = p.find_number("uroughness").value_or(roughness);
  m.v_roughness = p.find_number("vroughness").value_or(roughness);
  m.remap_roughness = p.flag("remaproughness", true);
  const std::string model = p.text("distribution").value_or("ggx");
  if (model == "beckmann") {
    m.model = desc::MicrofacetModel::Beckmann;
  } else if (model != "ggx") {
    fail_unknown(where, "microfacet distribution", model, {"ggx", "beckmann"});
  }
  return m;
}

desc::PlasticMaterial plastic(const Parameters& p) {
  return {p.spectrum("Kd", 0.25F), p.spectrum("Ks", 0.25F), p.number("roughness", 0.1F),
          p.flag("remaproughness", true)};
}

desc::SubstrateMaterial substrate(const Parameters& p) {
  return {p.spectrum("Kd", 0.5F), p.spectrum("Ks", 0.5F), p.number("uroughness", 0.1F),
          p.number("vroughness", 0.1F), p.flag("remaproughness", true)};
}

desc::UberMaterial uber(const Parameters& p) {
  desc::UberMaterial m;
  m.kd = p.spectrum("Kd", 0.25F);
  m.ks = p.spectrum("Ks", 0.25F);
  m.kr = p.spectrum("Kr", 0.F);
  m.kt = p.spectrum("Kt", 0.F);
  const desc::TextureId roughness = p.number("roughness", 0.1F);
  m.u_roughness = p.find_number("uroughness").value_or(roughness);
  m.v_roughness = p.find_number("vroughness").value_or(roughness);
  const std::optional<desc::TextureId> eta = p.find_number("eta");
  m.eta = eta ? *eta : p.number("index", 1.5F);
  m.opacity = p.spectrum("opacity", 1.F);
  m.remap_roughness = p.flag("remaproughness", true);
  return m;
}

desc::TranslucentMaterial translucent(const Parameters& p) {
  return {p.spectrum("Kd", 0.25F),      p.spectrum("Ks", 0.25F),
          p.number("roughness", 0.1F),  p.spectrum("reflect", 0.5F),
          p.spectrum("transmit", 0.5F), p.flag("remaproughness", true)};
}

desc::DisneyMaterial disney(const SourceLocation& where, const Parameters& p) {
  desc::DisneyMaterial m;
  m.color = p.spectrum("color", 0.5F);
  m.metallic = p.number("metallic", 0.F);
  m.eta = p.number("eta", 1.5F);
  m.roughness = p.number("roughness", 0.5F);
  m.specular_tint = p.number("speculartint", 0.F);
  m.anisotropic = p.number("anisotropic", 0.F);
  m.sheen = p.number("sheen", 0.F);
  m.sheen_tint = p.number("sheentint", 0.5F);
  m.clearcoat = p.number("clearcoat", 0.F);
  m.clearcoat_gloss = p.number("clearcoatgloss", 1.F);
  m.spec_trans = p.number("spectrans", 0.F);
  m.flatness = p.number("flatness", 0.F);
  m.diff_trans = p.number("difftrans", 1.F);
  m.thin = p.flag("thin", false);
  if (const std::optional<desc::TextureId> distance = p.find_spectrum("scatterdistance")) {
    const auto* constant = std::get_if<desc::ConstantTexture>(
        &p.context().scene.textures[static_cast<std::size_t>(*distance)].node);
    if (constant == nullptr || constant->value != desc::Rgb(0.F)) {
      p.context().warnings.add(
          kNoSubsurface, where,
          "disney: \"scatterdistance\" (subsurface scattering) is not supported: taken as 0");
    }
  }
  return m;
}

/// Stands in for materials that need what we do not have: diffuse with the nearest thing to a
/// colour.
desc::MatteMaterial stand_in(const SourceLocation& where, const std::string& type,
                             const Parameters& p) {
  p.context().warnings.add(
      kStandIn, where, "material \"" + type + "\" is not supported: a matte one stands in", type);
  desc::MatteMaterial m;
  m.sigma = p.table().constant(0.F);
  const std::optional<desc::TextureId> colour = type == "hair"           ? p.find_spectrum("color")
                                                : type == "kdsubsurface" ? p.find_spectrum("Kd")
                                                                         : std::nullopt;
  m.kd = colour ? *colour : p.table().constant(type == "hair" ? 0.2F : 0.5F);
  p.accept({"bsdffile", "sigma_a", "sigma_s", "eumelanin", "pheomelanin", "eta", "beta_m", "beta_n",
            "alpha", "name", "scale", "Kr", "Kt", "g", "mfp", "uroughness", "vroughness",
            "remaproughness"});
  return m;
}

}  // namespace

decltype(desc::Material::node) MaterialTable::make_node(const SourceLocation& where,
                                                        const std::string& type,
                                                        const TextureParameters& p) {
  if (type.empty() || type == "none") return desc::InterfaceMaterial{};
  if (type == "matte") return matte(p);
  if (type == "mirror") return desc::MirrorMaterial{p.spectrum("Kr", 0.9F)};
  if (type == "glass") return glass(p);
  if (type == "metal") return metal(where, p);
  if (type == "plastic") return plastic(p);
  if (type == "substrate") return substrate(p);
  if (type == "uber") return uber(p);
  if (type == "translucent") return translucent(p);
  if (type == "disney") return disney(where, p);
  if (type == "mix") return make_mix(where, p);
  if (type == "fourier" || type == "hair" || type == "subsurface" || type == "kdsubsurface") {
    return stand_in(where, type, p);
  }
  fail_unknown(where, "material", type, kTypes);
}

desc::MixMaterial MaterialTable::make_mix(const SourceLocation& where,
                                          const TextureParameters& p) const {
  const auto part = [&](std::string_view parameter) {
    const std::optional<std::string> name = p.text(parameter);
    if (!name)
      throw SceneError(where, "a mix material needs \"string " + std::string(parameter) + "\"");
    return named(where, *name)->id;
  };
  return {p.spectrum("amount", 0.5F), part("namedmaterial1"), part("namedmaterial2")};
}

desc::MaterialId MaterialTable::build(const SourceLocation& where, const std::string& type,
                                      const std::string& name,
                                      const TextureParameters& parameters) {
  desc::Material material;
  material.name = name;
  material.where = where;
  material.node = make_node(where, type, parameters);
  if (!std::holds_alternative<desc::InterfaceMaterial>(material.node) &&
      !std::holds_alternative<desc::MixMaterial>(material.node)) {
    material.bump = parameters.find_number("bumpmap").value_or(desc::kNone);
  }
  context_.scene.materials.push_back(std::move(material));
  return static_cast<desc::MaterialId>(context_.scene.materials.size()) - 1;
}

MaterialPointer MaterialTable::make(const SourceLocation& where, const std::string& type,
                                    std::shared_ptr<const ParameterList> parameters,
                                    const std::string& name) {
  const desc::MaterialId id =
      build(where, type, name, TextureParameters(context_, textures_, *parameters));
  parameters->report_unused(context_.warnings);
  return std::make_shared<const MaterialChoice>(
      MaterialChoice{id, type, name, std::move(parameters)});
}

void MaterialTable::make_named(const SourceLocation& where, const std::string& name,
                               std::shared_ptr<const ParameterList> parameters) {
  const std::optional<std::string> type = parameters->get_string("type");
  if (!type) throw SceneError(where, "MakeNamedMaterial needs \"string type\"");
  names_.set(name, make(where, *type, std::move(parameters), name));
}

MaterialPointer MaterialTable::named(const SourceLocation& where, const std::string& name) const {
  if (const MaterialPointer* found = names_.find(name)) return *found;
  throw SceneError(where, unknown_name_message("named material", name, names_.names()));
}

desc::MaterialId MaterialTable::for_shape(const SourceLocation& where, MaterialPointer current,
                                          const ParameterList& shape) {
  if (!current) {
    if (!default_) default_ = make(where, "matte", std::make_shared<const ParameterList>());
    current = default_;
  }
  if (shape.all_used()) return current->id;
  const std::size_t used = shape.used_count();
  const std::size_t textures = context_.scene.textures.size();
  const desc::MaterialId variant =
      build(where, current->type, current->name,
            TextureParameters(context_, textures_, shape, current->parameters.get()));
  if (shape.used_count() > used || context_.scene.textures.size() > textures) return variant;
  context_.scene.materials.pop_back();  // the shape's parameters were not about the material
  return current->id;
}

}  // namespace ajar::pbrt
