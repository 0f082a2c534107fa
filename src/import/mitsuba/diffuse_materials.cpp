#include <cmath>

#include "import/common/name_table.h"
#include "import/mitsuba/material_plugins.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kBlackMetal{
    Effect::Surface, "metals have no \"specular\", with which they are black in Mitsuba"};

Surface diffuse(const MaterialInputs& in, const desc::Value& sigma) {
  // Mitsuba 0.x takes either name.
  const bool is_long_name = !in.arguments.has("reflectance") &&
                            in.arguments.has("diffuse_reflectance") &&
                            in.context().document.major_version == 0;
  const desc::Value reflectance = in.textures.color(
      in.arguments, is_long_name ? "diffuse_reflectance" : "reflectance", desc::Rgb(0.5F));
  const bool is_black = reflectance == desc::Value(Vec3(0.F));
  const bool is_rough = sigma != desc::Value(0.F);
  return {in.materials.add(in.arguments.element(),
                           desc::material_node("diffuse", {{"reflectance", reflectance},
                                                           {"sigma", sigma},
                                                           {"between_facets", is_rough}})),
          desc::kNone, !is_black};
}

/// Mitsuba's names of the parameters of our principled material. Its defaults are ours.
ModelName principled_names(bool thin) {
  ModelName names{"principled",
                  "principled",
                  {{"specular_tint", {"spec_tint"}},
                   {"specular_transmission", {"spec_trans"}},
                   {"sheen_tint", {"sheen_tint"}, "0"},
                   {"blend", {}},
                   {"coat", {}},
                   {"coat_roughness", {}},
                   {"eta", {"eta"}},
                   {"thin", {}}}};
  if (thin) {
    names.parameters.push_back({"diffuse_transmission", {"diff_trans"}, "0"});
    for (const char* name : {"metallic", "clearcoat", "clearcoat_gloss"}) {
      names.parameters.push_back({name, {}});
    }
  } else {
    names.parameters.push_back({"diffuse_transmission", {}});
    names.parameters.push_back({"clearcoat_gloss", {"clearcoat_gloss"}, "0"});
  }
  return names;
}

/// Index of refraction of Burley's "specular" from 0 to 1. Source: Burley 2015.
float index_of_specular(float specular) { return 2.F / (1.F - std::sqrt(0.08F * specular)) - 1.F; }

Surface principled(const MaterialInputs& in, bool thin) {
  static const ModelName kSolidNames = principled_names(false);
  static const ModelName kThinNames = principled_names(true);
  desc::Node node = desc::material_node("principled", {{"thin", thin}});
  for (const ParameterSpec& spec : node.model().parameters) {
    const ParameterName* names = (thin ? kThinNames : kSolidNames).find(spec.name);
    const std::string_view theirs = names == nullptr        ? std::string_view(spec.name)
                                    : names->theirs.empty() ? std::string_view()
                                                            : names->theirs.front();
    if (theirs.empty()) continue;
    std::optional<desc::Value> value = spec.type == ParameterType::Color
                                           ? in.textures.find_color(in.arguments, theirs)
                                           : in.textures.find_number(in.arguments, theirs);
    if (!value && names != nullptr && !names->fallback.empty()) {
      ParameterSpec with_fallback = spec;
      with_fallback.default_value = names->fallback;
      value = desc::default_value(with_fallback);
    }
    if (value) node.set(spec.name, *value);
  }
  if (thin) {
    in.arguments.accept({"diffuse_reflectance_sampling_rate", "diffuse_transmittance_sampling_rate",
                         "specular_reflectance_sampling_rate",
                         "specular_transmittance_sampling_rate"});
  } else {
    if (const std::optional<double> specular = in.arguments.number("specular")) {
      node.set("eta", index_of_specular(static_cast<float>(*specular)));
    }
    in.arguments.accept({"diffuse_reflectance_sampling_rate", "main_specular_sampling_rate",
                         "clearcoat_sampling_rate", "specular_sampling_rate"});
  }
  const bool is_one_sided = !thin && node.get("specular_transmission") == desc::Value(0.F);
  if (is_one_sided && node.number("eta") == 1.F && node.get("metallic") != desc::Value(0.F)) {
    in.context().warnings.add(kBlackMetal, in.where(),
                              "in Mitsuba metal is black with a \"specular\" of 0 or an \"eta\" of "
                              "1; here it reflects");
  }
  return {in.materials.add(in.arguments.element(), std::move(node)), desc::kNone, is_one_sided};
}

}  // namespace

Surface make_diffuse(const MaterialInputs& in) { return diffuse(in, 0.F); }

Surface make_rough_diffuse(const MaterialInputs& in) {
  // The root mean square of the facets' slopes is alpha / √2 (Mitsuba 0.6, roughdiffuse), in
  // radians as long as it is small.
  constexpr float kDegrees = 180.F / kPi;
  const desc::Value alpha = in.textures.number(in.arguments, "alpha", 0.2F);
  in.arguments.accept({"use_fast_approx"});
  return diffuse(in, in.textures.scaled(in.where(), alpha, kDegrees / std::sqrt(2.F)));
}

Surface make_diffuse_transmitter(const MaterialInputs& in) {
  // Mitsuba 0.x takes either name.
  const bool is_long_name = in.arguments.has("diffuse_transmittance");
  const desc::Value share = in.textures.color(
      in.arguments, is_long_name ? "diffuse_transmittance" : "transmittance", desc::Rgb(0.5F));
  return {in.materials.add(in.arguments.element(),
                           desc::material_node("translucent", {{"diffuse", share},
                                                               {"glossy", Vec3(0.F)},
                                                               {"reflectance", Vec3(0.F)},
                                                               {"transmittance", Vec3(1.F)}}))};
}

Surface make_principled(const MaterialInputs& in) { return principled(in, false); }
Surface make_thin_principled(const MaterialInputs& in) { return principled(in, true); }

}  // namespace ajar::mitsuba
