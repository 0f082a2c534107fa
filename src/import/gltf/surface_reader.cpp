#include "import/gltf/surface_reader.h"

#include <algorithm>
#include <cmath>

#include "core/printable_text.h"
#include "import/common/opacity.h"
#include "scene/desc/models.h"

namespace ajar::gltf {
namespace {

constexpr WarningKind kFactorRange{Effect::Surface,
                                   "factors of materials are out of range: clamped"};
constexpr WarningKind kCoatNormals{Effect::Slight, "clear coats have normal maps: ignored"};
constexpr WarningKind kNoLayer{Effect::Surface,
                               "extensions of glass and of old or unlit materials: left out"};
constexpr WarningKind kNoAbsorption{
    Effect::Surface, "volumes are only supported behind transmission: no absorption"};
constexpr WarningKind kClosedVolume{Effect::None, "volumes are of opaque materials: not seen"};
constexpr WarningKind kUnlit{Effect::Light,
                             "materials are unlit: they shine, also onto their surroundings"};
constexpr WarningKind kSpecular{Effect::Surface, "materials have a hue of their gloss: ignored"};
constexpr WarningKind kWeakGlass{Effect::Slight,
                                 "glass has a factor of its gloss: what is not reflected is lost"};
constexpr WarningKind kSheen{Effect::Slight, "materials have a sheen: another one stands in"};
constexpr WarningKind kDiffuseTransmission{
    Effect::Surface, "materials let light shine through diffusely: in their base colour"};
constexpr WarningKind kNoFactor{Effect::Surface,
                                "textures have no factor, which then is 0: they are not seen"};
constexpr WarningKind kInfiniteIndex{Effect::Slight, "materials have an index of refraction of 0"};

/// Layer that an extension adds to a material, unless the member is 0, and the warning where it
/// cannot.
struct Layer {
  std::string_view extension;
  std::string_view member;
  std::string_view message;
};
constexpr Layer kCoatLayer{"KHR_materials_clearcoat", "clearcoatFactor",
                           "a clear coat is only supported on metals and opaque dielectrics: left "
                           "out elsewhere"};
constexpr Layer kSheenLayer{"KHR_materials_sheen", "sheenColorFactor",
                            "a sheen is only supported on metals and opaque dielectrics: left out "
                            "elsewhere"};
constexpr Layer kTransmissionLayer{
    "KHR_materials_transmission", "transmissionFactor",
    "transmission is only supported in metallic-roughness materials: left out"};
constexpr Layer kDiffuseTransmissionLayer{
    "KHR_materials_diffuse_transmission", "diffuseTransmissionFactor",
    "diffuse transmission is only supported in metallic-roughness materials: left out"};

/// True if a member, a number or a colour, is there and not 0.
bool is_some(const Element& holder, std::string_view name) {
  const std::optional<Element> member = holder.find(name);
  if (!member) return false;
  if (!member->is(Element::Kind::Array)) return member->number() != 0.0;
  return holder.value_or(name, Vec3(0.F)) != Vec3(0.F);
}

void warn_of_layer(const Element& material, const Layer& layer, Warnings& warnings) {
  const auto extension = extension_of(material, layer.extension);
  if (!extension || !is_some(*extension, layer.member)) return;
  warnings.add(kNoLayer, extension->where(), std::string(layer.message));
}

/// A share in place of a lane of a colour: `principled` has no coloured gloss of a dielectric.
float brightness(const Vec3& color) {
  return 0.2126F * color.x + 0.7152F * color.y + 0.0722F * color.z;
}

}  // namespace

Surface SurfaceReader::read() {
  const std::size_t first_made = context_.scene.materials.size();
  const desc::MaterialId base = read_base();
  read_emission();
  surface_.material = with_opacity(base);
  read_normals(first_made);
  surface_.uv_set = textures_.uv_set();
  return surface_;
}

desc::MaterialId SurfaceReader::read_base() {
  const Element pbr = material_.find("pbrMetallicRoughness").value_or(material_.without_members());
  if (extension_of(material_, "KHR_materials_unlit")) {
    warn_of_layers();
    return unlit(pbr);
  }
  if (const auto glossiness = extension_of(material_, "KHR_materials_pbrSpecularGlossiness")) {
    warn_of_layers();
    return specular_glossiness(*glossiness);
  }
  const desc::MaterialId opaque = metallic_roughness(pbr);
  const auto transmission = extension_of(material_, "KHR_materials_transmission");
  if (transmission) return with_transmission(opaque, *transmission, pbr);
  warn_of_volume();
  return opaque;
}

desc::MaterialId SurfaceReader::metallic_roughness(const Element& pbr) {
  const desc::Value base_color = read_color(pbr, "baseColorFactor", "baseColorTexture");
  desc::Node node =
      make(pbr, "principled", {{"base_color", base_color}, {"blend", std::string("layered")}});
  node.set("metallic",
           textures_.number(pbr, "metallicRoughnessTexture",
                            clamped_number(pbr, "metallicFactor", 1.0F), Channel::Blue));
  node.set("roughness",
           textures_.number(pbr, "metallicRoughnessTexture",
                            clamped_number(pbr, "roughnessFactor", 1.0F), Channel::Green));
  material_.located([&] { node.set("eta", index_for_specular()); });
  node.set("specular_strength", specular_strength());
  set_clearcoat(node);
  set_sheen(node);
  set_diffuse_transmission(node);
  return add(std::move(node));
}

desc::MaterialId SurfaceReader::specular_glossiness(const Element& pbr) {
  const desc::Value diffuse_color = read_color(pbr, "diffuseFactor", "diffuseTexture");
  const desc::Value rough = textures_.complement(
      textures_.number(pbr, "specularGlossinessTexture",
                       clamped_number(pbr, "glossinessFactor", 1.0F), Channel::Alpha));
  const desc::Value specular = textures_.color(
      pbr, "specularGlossinessTexture",
      clamped_color(pbr, "specularFactor", pbr.value_or("specularFactor", Vec3(1.F))));
  if (specular == desc::Value(Vec3(0.F))) {
    return add(make(pbr, "diffuse", {{"reflectance", diffuse_color}}));
  }
  return add(make(pbr, "coated_diffuse",
                  {{"diffuse_reflectance", diffuse_color},
                   {"glossy_reflectance", specular},
                   {"roughness", textures_.product(rough, rough)}}));
}

desc::MaterialId SurfaceReader::unlit(const Element& pbr) {
  const desc::Value color = read_color(pbr, "baseColorFactor", "baseColorTexture");
  surface_.emission = desc::Emission{
      material_.where(), desc::emission_node("area", {{"radiance", color}, {"two_sided", true}})};
  context_.warnings.add(kUnlit, material_.where(),
                        "this material is unlit: it shines, also onto its surroundings");
  return add(make(material_, "diffuse", {{"reflectance", Vec3(0.F)}}));
}

desc::MaterialId SurfaceReader::with_transmission(desc::MaterialId opaque,
                                                  const Element& transmission, const Element& pbr) {
  warn_of_unseen(transmission, "transmissionFactor", "transmissionTexture");
  const desc::Value share =
      textures_.number(transmission, "transmissionTexture",
                       clamped_number(transmission, "transmissionFactor", 0.0F), Channel::Red);
  const desc::Node& base = context_.scene.materials[static_cast<std::size_t>(opaque)].node;
  const desc::Value metallic = base.get("metallic");
  const desc::Value color = base.get("base_color");
  const desc::Value roughness = base.get("roughness");
  const desc::Value amount = textures_.product(share, textures_.complement(metallic));
  if (amount == desc::Value(0.F)) {
    warn_of_volume();
    return opaque;
  }
  for (const Layer& layer : {kCoatLayer, kSheenLayer}) {
    warn_of_layer(material_, layer, context_.warnings);
  }
  const auto volume = extension_of(material_, "KHR_materials_volume");
  const bool is_thin = !volume || !(volume->value_or("thicknessFactor", 0.0F) > 0.F);
  if (!is_thin) surface_.inside = read_medium(*volume);
  desc::Node glass = make(pbr, "dielectric", {{"transmittance", color}, {"thin", is_thin}});
  material_.located([&] { glass.set("eta", index_of_refraction()); });
  glass.set("roughness", textures_.product(roughness, roughness));
  if (const desc::Value strength = specular_strength(); strength != desc::Value(1.F)) {
    context_.warnings.add(
        kWeakGlass, material_.where(),
        "the factor of its gloss weakens what glass reflects, and does not add to "
        "what it transmits");
    glass.set("reflectance", mix_amount(strength));
  }
  const desc::MaterialId transparent = add(std::move(glass));
  if (amount == desc::Value(1.F)) return transparent;
  return add(make(transmission, "mix",
                  {{"amount", mix_amount(amount)},
                   {"first", desc::MaterialRef{transparent}},
                   {"second", desc::MaterialRef{opaque}}}));
}

desc::MaterialId SurfaceReader::with_opacity(desc::MaterialId visible) {
  static const std::vector<std::string> kModes = {"OPAQUE", "MASK", "BLEND"};
  const std::string mode = material_.value_or<std::string>("alphaMode", "OPAQUE");
  if (mode == "OPAQUE" || alpha_ == desc::Value(1.F)) return visible;
  if (mode == "MASK") {
    surface_.alpha =
        textures_.threshold(material_, alpha_, material_.value_or("alphaCutoff", 0.5F));
    return visible;
  }
  if (mode != "BLEND") {
    material_.at("alphaMode").fail(unknown_name_message("alphaMode", printable_line(mode), kModes));
  }
  const PartlyClear partly = ajar::with_opacity(
      context_.scene,
      {.name = material_.value_or("name", std::string()), .where = material_.where()}, visible,
      alpha_);
  surface_.alpha = partly.alpha;
  // A blend includes the emission.
  if (surface_.emission) {
    desc::Node& emission = surface_.emission->node;
    const auto* share = std::get_if<float>(&alpha_);
    if (share != nullptr) {
      emission.set("scale", emission.color("scale") * *share);
    } else {
      emission.set("radiance", textures_.product(emission.get("radiance"), alpha_));
    }
  }
  return partly.material;
}

void SurfaceReader::warn_of_layers() {
  for (const Layer& layer :
       {kCoatLayer, kSheenLayer, kTransmissionLayer, kDiffuseTransmissionLayer}) {
    warn_of_layer(material_, layer, context_.warnings);
  }
}

void SurfaceReader::warn_of_volume() {
  const auto volume = extension_of(material_, "KHR_materials_volume");
  if (!volume || !is_some(*volume, "thicknessFactor") || !volume->has("attenuationDistance")) {
    return;
  }
  const auto diffuse = extension_of(material_, kDiffuseTransmissionLayer.extension);
  if (diffuse && is_some(*diffuse, kDiffuseTransmissionLayer.member)) {
    context_.warnings.add(kNoAbsorption, volume->where(),
                          "a volume is only supported behind KHR_materials_transmission: nothing "
                          "is absorbed here");
  } else {
    context_.warnings.add(kClosedVolume, volume->where(),
                          "a volume of what lets no light in is not seen: ignored");
  }
}

void SurfaceReader::set_clearcoat(desc::Node& node) {
  const auto coat = extension_of(material_, "KHR_materials_clearcoat");
  if (!coat) return;
  warn_of_unseen(*coat, "clearcoatFactor", "clearcoatTexture");
  const float strength = clamped_number(*coat, "clearcoatFactor", 0.0F);
  if (strength == 0.F) return;
  node.set("coat", textures_.number(*coat, "clearcoatTexture", strength, Channel::Red));
  node.set(
      "coat_roughness",
      textures_.number(*coat, "clearcoatRoughnessTexture",
                       clamped_number(*coat, "clearcoatRoughnessFactor", 0.0F), Channel::Green));
}

void SurfaceReader::set_sheen(desc::Node& node) {
  const auto sheen = extension_of(material_, "KHR_materials_sheen");
  if (!sheen) return;
  warn_of_unseen(*sheen, "sheenColorFactor", "sheenColorTexture");
  const Vec3 color =
      clamped_color(*sheen, "sheenColorFactor", sheen->value_or("sheenColorFactor", Vec3(0.F)));
  const float strength = std::max({color.x, color.y, color.z});
  if (strength == 0.F) return;
  context_.warnings.add(kSheen, sheen->where(),
                        "a sheen stands in that has the hue of the base colour and no roughness");
  node.set("sheen", strength);
  node.set("sheen_tint", color == Vec3(strength) ? 0.F : 1.F);
}

void SurfaceReader::set_diffuse_transmission(desc::Node& node) {
  const auto transmission = extension_of(material_, "KHR_materials_diffuse_transmission");
  if (!transmission) return;
  warn_of_unseen(*transmission, "diffuseTransmissionFactor", "diffuseTransmissionTexture");
  const float share = clamped_number(*transmission, "diffuseTransmissionFactor", 0.0F);
  if (share == 0.F) return;
  context_.warnings.add(kDiffuseTransmission, transmission->where(),
                        "what shines through has the base colour, and no texture of its own");
  // Twice the share: as much on either side at 1.
  node.set("thin", true);
  node.set("diffuse_transmission", 2.F * share);
}

float SurfaceReader::index_of_refraction() const {
  constexpr float kUsual = 1.5F;
  const auto extension = extension_of(material_, "KHR_materials_ior");
  const float index = extension ? extension->value_or<float>("ior", kUsual) : kUsual;
  if (index >= 1.F) return index;
  if (index != 0.F) extension->at("ior").fail("an index of refraction is 1 or more");
  context_.warnings.add(kInfiniteIndex, extension->where(),
                        "an index of refraction of 0, for infinite, is taken as 1.5");
  return kUsual;
}

float SurfaceReader::index_for_specular() {
  const float index = index_of_refraction();
  const auto specular = extension_of(material_, "KHR_materials_specular");
  if (!specular) return index;
  const Vec3 color = specular->value_or("specularColorFactor", Vec3(1.F));
  if (specular->has("specularColorTexture") || color.x != color.y || color.y != color.z) {
    context_.warnings.add(kSpecular, specular->where(),
                          "the hue of the gloss is ignored, on glass its brightness, too");
  }
  const float r0 = std::pow((index - 1.F) / (index + 1.F), 2.F);
  const float wanted = std::clamp(r0 * brightness(color), 0.F, 0.8F);
  const float root = std::sqrt(wanted);
  return (1.F + root) / (1.F - root);
}

desc::Value SurfaceReader::specular_strength() {
  const auto specular = extension_of(material_, "KHR_materials_specular");
  if (!specular) return 1.F;
  return textures_.number(*specular, "specularTexture",
                          clamped_number(*specular, "specularFactor", 1.0F), Channel::Alpha);
}

desc::MediumId SurfaceReader::read_medium(const Element& volume) {
  const std::optional<double> distance = volume.find<double>("attenuationDistance");
  const Vec3 color =
      clamped_color(volume, "attenuationColor", volume.value_or("attenuationColor", Vec3(1.F)));
  if (!distance || color == Vec3(1.F)) return desc::kNone;
  if (!(*distance > 0.0)) volume.at("attenuationDistance").fail("this distance must be above 0");
  constexpr float kDarkest = 1e-6F;
  desc::Medium& medium = context_.scene.media.emplace_back();
  medium.where = volume.where();
  for (int lane = 0; lane < 3; ++lane) {
    medium.sigma_a[lane] =
        static_cast<float>(-std::log(double{std::max(color[lane], kDarkest)}) / *distance);
  }
  return static_cast<desc::MediumId>(context_.scene.media.size()) - 1;
}

void SurfaceReader::warn_of_unseen(const Element& holder, const char* factor, const char* texture) {
  if (!holder.has(texture) || holder.has(factor)) return;
  context_.warnings.add(kNoFactor, holder.at(texture).where(),
                        "\"" + std::string(texture) + "\" is multiplied by \"" + factor +
                            "\", which is 0 where it is not given: not seen");
}

void SurfaceReader::read_emission() {
  warn_of_unseen(material_, "emissiveFactor", "emissiveTexture");
  const auto extension = extension_of(material_, "KHR_materials_emissive_strength");
  const float strength = extension ? extension->value_or("emissiveStrength", 1.0F) : 1.F;
  const Vec3 scale = material_.value_or("emissiveFactor", Vec3(0.F)) * strength;
  if (scale == Vec3(0.F) || surface_.emission) return;
  surface_.emission = desc::Emission{
      material_.where(), material_.located([&] {
        return desc::emission_node(
            "area", {{"radiance", textures_.color(material_, "emissiveTexture", Vec3(1.F))},
                     {"scale", scale},
                     {"two_sided", material_.value_or("doubleSided", false)}});
      })};
}

void SurfaceReader::read_normals(std::size_t first_made) {
  const auto coat = extension_of(material_, "KHR_materials_clearcoat");
  if (coat && coat->has("clearcoatNormalTexture")) {
    context_.warnings.add(kCoatNormals, coat->where(),
                          "the coat has the normals of what it is on: its own are ignored");
  }
  const std::optional<desc::TextureId> texture = textures_.vectors(material_, "normalTexture");
  if (!texture) return;
  surface_.has_normal_map = true;
  const desc::NormalMap normals{.texture = *texture,
                                .strength = material_.at("normalTexture").value_or("scale", 1.0F)};
  for (std::size_t i = first_made; i < context_.scene.materials.size(); ++i) {
    desc::Material& made = context_.scene.materials[i];
    // A mix has those of its parts.
    if (!made.node.is("mix")) made.normal_map = normals;
  }
}

desc::Value SurfaceReader::read_color(const Element& holder, const char* factor,
                                      const char* texture) {
  const auto base = holder.value_or(factor, std::array<float, 4>{1.F, 1.F, 1.F, 1.F});
  const desc::Rgb color = clamped_color(holder, factor, Vec3(base[0], base[1], base[2]));
  const desc::Value result = textures_.color(holder, texture, color);
  alpha_ = textures_.number(holder, texture, base[3], Channel::Alpha);
  return colors_ == nullptr ? result : textures_.product(result, colors_->value);
}

float SurfaceReader::clamped_number(const Element& holder, std::string_view name, float fallback) {
  return clamped_color(holder, name, Vec3(holder.value_or<float>(name, fallback))).x;
}

desc::Rgb SurfaceReader::clamped_color(const Element& holder, std::string_view name,
                                       const desc::Rgb& value) {
  constexpr float kRounding = 1e-4F;
  desc::Rgb clamped = value;
  float excess = 0.F;
  for (int lane = 0; lane < 3; ++lane) {
    clamped[lane] = std::clamp(value[lane], 0.F, 1.F);
    excess = std::max(excess, std::abs(value[lane] - clamped[lane]));
  }
  if (excess > kRounding) {
    context_.warnings.add(kFactorRange, holder.at(name).where(),
                          "this must be from 0 to 1; what is beyond is clamped");
  }
  return clamped;
}

desc::Value SurfaceReader::mix_amount(const desc::Value& number) const {
  const auto* constant = std::get_if<float>(&number);
  return constant == nullptr ? number : desc::Value(Vec3(std::clamp(*constant, 0.F, 1.F)));
}

desc::MaterialId SurfaceReader::add(desc::Node node) {
  desc::Material& added = context_.scene.materials.emplace_back();
  added.name = material_.value_or("name", std::string());
  added.where = material_.where();
  added.node = std::move(node);
  return static_cast<desc::MaterialId>(context_.scene.materials.size()) - 1;
}

desc::Node SurfaceReader::make(const Element& user, std::string_view model,
                               desc::Node::Given given) const {
  return user.located([&] { return desc::material_node(model, given); });
}

}  // namespace ajar::gltf
