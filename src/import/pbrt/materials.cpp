#include "import/pbrt/materials.h"

#include <algorithm>
#include <cmath>

#include "import/common/opacity.h"
#include "import/common/relief_of_mix.h"
#include "import/pbrt/material_names.h"
#include "import/pbrt/named_spectra.h"
#include "import/pbrt/node_reader.h"
#include "import/pbrt/own_words.h"
#include "import/pbrt/stand_ins.h"
#include "scene/desc/models.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kUnknownMaterial{Effect::Surface,
                                       "materials are unknown: matte ones stand in"};
constexpr WarningKind kMaterialNotMade{
    Effect::Surface, "materials are named that were not made: matte ones stand in"};
constexpr WarningKind kNoMediumInCoat{
    Effect::Surface, "coated materials have an \"albedo\" in their coat, which is not supported"};
constexpr WarningKind kTwoMetals{
    Effect::Surface, "metals have both an index and a reflectance, which pbrt-v4 refuses"};
constexpr WarningKind kNoDisneySubsurface{
    Effect::Surface, "disney materials have subsurface scattering, which is not supported"};

/// Warns of unsupported parameters of pbrt's disney material.
void check_subsurface(const SourceLocation& where, const TextureParameters& p) {
  const std::optional<desc::Value> distance = p.find_spectrum("scatterdistance");
  if (!distance || *distance == desc::Value(Vec3(0.F))) return;
  p.context().warnings.add(
      kNoDisneySubsurface, where,
      "disney: \"scatterdistance\" (subsurface scattering) is not supported: taken as 0");
}

/// α of a constant roughness; nothing for textures.
std::optional<float> constant_alpha(const desc::Node& node, const char* name) {
  const float* roughness = std::get_if<float>(&node.get(name));
  if (roughness == nullptr) return std::nullopt;
  const bool is_square = node.text("roughness_scale") == "square";
  return is_square ? std::sqrt(std::max(*roughness, 0.F)) : *roughness;
}

/// pbrt-v4 takes facets with both α below 0.001 for a smooth surface (Pharr et al. 2023, section
/// 9.6.2). Coated materials do so themselves.
void smooth_if_nearly_so(desc::Node& node) {
  if (!node.is("conductor") && !node.is("dielectric")) return;
  constexpr float kEffectivelySmooth = 1e-3F;
  const std::optional<float> u = constant_alpha(node, "roughness");
  const std::optional<float> v = constant_alpha(node, "roughness_v");
  if (!u || (v && *v >= kEffectivelySmooth) || *u >= kEffectivelySmooth) return;
  node.set("roughness", 0.F);
  node.set("roughness_v", 0.F);
  if (node.is("conductor")) node.set("distribution", std::string("smooth"));
}

/// Metals are copper unless they say otherwise, and copper has the colours of this dialect's
/// spectra.
void finish_metal(const SourceLocation& where, const TextureParameters& p, desc::Node& node,
                  const std::string& prefix) {
  bool has_index = false;
  for (const char* index : {"eta", "k"}) {
    if (p.find_spectrum(prefix + index)) {
      has_index = true;
    } else {
      node.set(index, Vec3(*named_metal(std::string("metal-Cu-") + index)));
    }
  }
  if (!has_index || std::holds_alternative<std::monostate>(node.get("reflectance"))) return;
  p.context().warnings.add(kTwoMetals, where,
                           "pbrt-v4 refuses \"eta\" and \"k\" beside \"reflectance\": here the "
                           "reflectance counts");
}

/// Indices are no reflectances: an image of them may be above 1.
void unclamp(const SourceLocation& where, TextureTable& textures, Context& context,
             const char* parameter, desc::Node& node) {
  const auto* texture = std::get_if<desc::TextureRef>(&node.get(parameter));
  if (texture == nullptr) return;
  desc::Node image = context.scene.textures[static_cast<std::size_t>(texture->id)].node;
  if (!image.is("image") || !image.flag("clamp")) return;
  image.set("clamp", false);
  node.set(parameter, desc::TextureRef{textures.add(where, std::move(image))});
}

/// Adds pbrt-v4's options beside the parameters that the models have.
void finish_v4(const SourceLocation& where, const std::string& type, const TextureParameters& p,
               TextureTable& textures, desc::Node& node) {
  smooth_if_nearly_so(node);
  if (type == "conductor") finish_metal(where, p, node, "");
  if (type == "coatedconductor") finish_metal(where, p, node, "conductor.");
  if (node.is("conductor") || node.is("coated_conductor")) {
    for (const char* index : {"eta", "k"}) unclamp(where, textures, p.context(), index, node);
  }
  if (type == "diffusetransmission") {
    const float scale = p.number("scale").value_or(1.F);
    node.set("diffuse", Vec3(std::clamp(scale, 0.F, 1.F)));
  }
  if (type == "coateddiffuse" || type == "coatedconductor") {
    const std::optional<desc::Value> albedo = p.find_spectrum("albedo");
    if (albedo && *albedo != desc::Value(Vec3(0.F))) {
      p.context().warnings.add(
          kNoMediumInCoat, where,
          type + ": \"albedo\" of the coat is not supported: taken as 0, a clear coat");
    }
    // Even a clear coat weakens light there, by exp(−thickness / cos θ) on each way through it; and
    // a walk ends after that many ways, of which every second meets the base.
    desc::Value depth = p.find_number("thickness").value_or(0.01F);
    const float* number = std::get_if<float>(&depth);
    if (number != nullptr) depth = Vec3(*number);
    node.set("coat_depth", depth);
    node.set("bounces", std::clamp(p.integer("maxdepth").value_or(10) / 2, 1, 1000));
    p.accept({"g", "nsamples", "twosided"});
  }
}

/// A file of normals in pbrt-v4; a texture in pbrt-v3, which has no word for them: ours.
desc::NormalMap read_normal_map(const SourceLocation& where, const TextureParameters& p,
                                TextureTable& textures) {
  if (p.context().is_v4()) {
    const std::optional<std::string> file = p.text("normalmap");
    if (!file || file->empty()) return {};
    const desc::Node image =
        desc::texture_node("image", {{"file", resolve_file(p.context(), where, *file)},
                                     {"decode_srgb", !obeys_encoding(*file)}});
    return {.texture = textures.add(where, image), .right_handed = true};
  }
  const std::optional<desc::Value> normals = p.find_spectrum("normal_map");
  const auto* texture = normals ? std::get_if<desc::TextureRef>(&*normals) : nullptr;
  if (texture == nullptr) return {};
  return {.texture = texture->id,
          .strength = p.number("normal_strength").value_or(1.F),
          .right_handed = p.flag("normal_right_handed").value_or(false)};
}

/// True if pbrt tilts the normals of this material.
bool can_have_relief(const desc::Node& node) { return !node.is("interface") && !node.is("mix"); }

}  // namespace

desc::MaterialId MaterialTable::part(const SourceLocation& where, const std::string& type,
                                     std::string_view parameter,
                                     const TextureParameters& parameters) {
  const std::optional<std::string> name = parameters.text(parameter);
  if (!name) {
    throw SceneError(where,
                     "a " + type + " material needs \"string " + std::string(parameter) + "\"");
  }
  return named(where, *name)->id;
}

desc::Node MaterialTable::make_mix(const SourceLocation& where,
                                   const TextureParameters& parameters) {
  const std::vector<std::string> names = parameters.texts("materials");
  if (names.size() != 2) {
    throw SceneError(where, "a mix material needs \"string materials\" with two names");
  }
  // pbrt-v4's "amount" is the share of the second, ours that of the first.
  const desc::MaterialId first = named(where, names[1])->id;
  const desc::MaterialId second = named(where, names[0])->id;
  check_relief_of_mix(context_.scene, first, second, where, context_.warnings);
  const desc::Model& mix = *desc::find_model(desc::ModelKind::Material, "mix");
  return NodeReader(where, parameters)
      .with_numbers_for_colors(true)
      .with_materials([&](std::string_view parameter) {
        // One of them is chosen at each hit: none is no intersection.
        return part_of_mix(context_.scene, parameter == "first" ? first : second,
                           Passing::Uncounted);
      })
      .read(mix, find_theirs(material_names(Dialect::V4), "mix"));
}

desc::Node MaterialTable::make_node(const SourceLocation& where, const std::string& type,
                                    const TextureParameters& parameters) {
  const Dialect dialect = context_.choice.dialect;
  const std::vector<ModelName>& table = material_names(dialect);
  if (std::optional<desc::Node> stand_in = make_stand_in(where, type, parameters)) return *stand_in;
  if (const desc::Model* own =
          own_model(context_, where, desc::ModelKind::Material, parameters.text(kOwnModel))) {
    return NodeReader(where, parameters).read(*own, nullptr);
  }
  const desc::Model* model = model_of_type(desc::ModelKind::Material, table, type);
  if (model == nullptr) {
    std::vector<std::string> types = types_of(desc::ModelKind::Material, table);
    for (std::string& known : stand_in_types(dialect)) types.push_back(std::move(known));
    report_unknown(context_, where, "material", type, types, kUnknownMaterial,
                   "A matte one stands in");
    return desc::material_node("diffuse");
  }
  if (context_.is_v4() && type == "mix") return make_mix(where, parameters);
  desc::Node node = NodeReader(where, parameters)
                        .with_materials([&](std::string_view parameter) {
                          return part(where, type, parameter, parameters);
                        })
                        .read(*model, find_theirs(table, type));
  if (context_.is_v4()) finish_v4(where, type, parameters, textures_, node);
  if (type == "disney") check_subsurface(where, parameters);
  return node;
}

desc::MaterialId MaterialTable::build(const SourceLocation& where, const std::string& type,
                                      const std::string& name,
                                      const TextureParameters& parameters) {
  desc::Material material;
  material.name = name;
  material.where = where;
  material.node = make_node(where, type, parameters);
  if (can_have_relief(material.node)) {
    // A bump that is the same everywhere is none.
    const std::optional<desc::Value> bump =
        parameters.find_number(context_.is_v4() ? "displacement" : "bumpmap");
    if (bump && std::holds_alternative<desc::TextureRef>(*bump)) {
      material.bump = std::get<desc::TextureRef>(*bump).id;
    }
    material.normal_map = read_normal_map(where, parameters, textures_);
    // The normal map takes precedence among pbrt-v4's two kinds of relief.
    if (context_.is_v4() && material.normal_map.texture != desc::kNone) material.bump = desc::kNone;
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
  if (names_.is_from_here(name)) warn_of_same_name(context_, where, "material", name);
  names_.set(name, make(where, *type, std::move(parameters), name));
}

MaterialPointer MaterialTable::named(const SourceLocation& where, const std::string& name) {
  if (const MaterialPointer* found = names_.find(name)) return *found;
  warn_of_unknown_name(context_, kMaterialNotMade, where, "named material", name, names_.names(),
                       "A matte one stands in");
  return default_material(where);
}

MaterialPointer MaterialTable::default_material(const SourceLocation& where) {
  const char* type = context_.is_v4() ? "diffuse" : "matte";
  if (!default_) default_ = make(where, type, std::make_shared<const ParameterList>());
  return default_;
}

desc::MaterialId MaterialTable::for_shape(const SourceLocation& where, MaterialPointer current,
                                          const ParameterList& shape) {
  if (!current) current = default_material(where);
  if (context_.is_v4() || shape.all_used()) return current->id;
  const std::size_t used = shape.used_count();
  const desc::MaterialId variant =
      build(where, current->type, current->name,
            TextureParameters(context_, textures_, shape, current->parameters.get()));
  const std::vector<desc::Material>& materials = context_.scene.materials;
  // Parameters that the shape itself reads, too, were used before, but may make another material.
  if (shape.used_count() > used ||
      materials.back().node != materials[static_cast<std::size_t>(current->id)].node) {
    return variant;
  }
  context_.scene.materials.pop_back();  // the shape's parameters were not about the material
  return current->id;
}

}  // namespace ajar::pbrt
