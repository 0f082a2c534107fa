#include "import/pbrt/stand_ins.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "import/pbrt/presets.h"
#include "scene/desc/models.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kStandIn{Effect::Surface, "materials are not supported: matte ones stand in"};
constexpr WarningKind kNoSubsurface{
    Effect::Surface, "materials scatter below their surface: coated matte ones stand in"};

constexpr WarningKind kTexturedStandIn{
    Effect::Surface, "parameters of stand-ins are textures: their defaults count"};

/// Inputs of a stand-in.
struct Original {
  const SourceLocation& where;
  const TextureParameters& p;

  bool is_v4() const { return p.context().is_v4(); }
  /// Values that a stand-in computes with: of textures, only constant ones.
  std::optional<desc::Rgb> color(const char* name) const {
    const std::optional<desc::Value> given = plain(name, p.find_spectrum(name, true));
    return given ? std::optional(std::get<Vec3>(*given)) : std::nullopt;
  }
  std::optional<float> number(const char* name) const {
    const std::optional<desc::Value> given = plain(name, p.find_number(name));
    if (!given) return std::nullopt;
    const float* value = std::get_if<float>(&*given);
    return value == nullptr ? std::get<Vec3>(*given).x : *value;
  }
  /// Parameters that the stand-in has no use for. Textures that they name should be there.
  void ignore_numbers(std::initializer_list<const char*> names) const {
    for (const char* name : names) p.find_number(name);
  }

 private:
  std::optional<desc::Value> plain(const char* name, std::optional<desc::Value> given) const {
    const auto* texture = given ? std::get_if<desc::TextureRef>(&*given) : nullptr;
    if (texture == nullptr) return given;
    const desc::Node& node = p.context().scene.textures[static_cast<std::size_t>(texture->id)].node;
    if (node.is("constant")) return node.get("value");
    p.context().warnings.add(kTexturedStandIn, where,
                             "\"" + std::string(name) +
                                 "\" is a texture, which the stand-in cannot follow: its default "
                                 "counts",
                             name);
    return std::nullopt;
  }
};

desc::Rgb map(const desc::Rgb& color, float (*function)(float)) {
  return {function(color.x), function(color.y), function(color.z)};
}

desc::Node matte(desc::Value color) {
  return desc::material_node("diffuse", {{"reflectance", std::move(color)}});
}

/// Absorption of hair by its melanin. Source: d'Eon et al. 2011, section 6.1.
desc::Rgb melanin_absorption(const Original& from) {
  const std::optional<float> pheomelanin = from.number("pheomelanin");
  const float eumelanin = from.number("eumelanin").value_or(pheomelanin ? 0.F : 1.3F);
  return desc::Rgb(0.419F, 0.697F, 1.37F) * std::max(eumelanin, 0.F) +
         desc::Rgb(0.187F, 0.4F, 1.05F) * std::max(pheomelanin.value_or(0.F), 0.F);
}

/// Colour of a mass of hair, which scatters light many times. Source: Chiang et al. 2016, "A
/// practical and controllable hair and fur model", section 4.2.
desc::Node hair(const Original& from) {
  from.ignore_numbers({"eta", "beta_m", "alpha"});
  const float b = from.number("beta_n").value_or(0.3F);
  std::optional<desc::Rgb> sigma_a = from.color("sigma_a");
  if (!sigma_a) {
    // pbrt-v4 had the name of pbrt-v3 at first.
    std::optional<desc::Value> color;
    if (from.is_v4()) color = from.p.find_spectrum("reflectance", true);
    if (!color) color = from.p.find_spectrum("color", true);
    if (color) return matte(*color);
    sigma_a = melanin_absorption(from);
  }
  const float scattering = 5.969F - 0.215F * b + 2.532F * b * b - 10.73F * b * b * b +
                           5.574F * b * b * b * b + 0.245F * b * b * b * b * b;
  const desc::Rgb roots = map(*sigma_a, [](float x) { return std::sqrt(x); });
  return matte(map(roots * -scattering, [](float x) { return std::exp(x); }));
}

/// Diffuse reflectance of a thick medium whose boundary refracts nothing; `reduced_albedo` is of
/// isotropic scattering. Source: Jensen et al. 2001, section 2.4, with A = 1.
float diffuse_reflectance(float reduced_albedo) {
  const float root = std::sqrt(3.F * std::max(1.F - reduced_albedo, 0.F));
  return 0.5F * reduced_albedo * (1.F + std::exp(-4.F / 3.F * root)) * std::exp(-root);
}

/// Albedo of a subsurface medium. pbrt-v3 takes coefficients that are not given from a preset;
/// pbrt-v4 has one of three: a preset, coefficients, a reflectance.
desc::Value color_below(const Original& from) {
  const std::optional<ScatteringPreset> preset =
      preset_named(from.p.context(), from.where, from.p.text("name"));
  ScatteringPreset medium = preset.value_or(default_preset());
  if (!preset || !from.is_v4()) {
    const std::optional<desc::Rgb> sigma_a = from.color("sigma_a");
    const std::optional<desc::Rgb> sigma_s = from.color("sigma_s");
    if (from.is_v4() && !sigma_a && !sigma_s) {
      const std::optional<desc::Value> color = from.p.find_spectrum("reflectance", true);
      from.p.find_spectrum("mfp");
      if (color) return *color;
    }
    medium.sigma_a = sigma_a.value_or(medium.sigma_a);
    medium.sigma_s = sigma_s.value_or(medium.sigma_s);
  }
  // Presets are of reduced scattering.
  const float g = preset ? 0.F : std::clamp(from.p.number("g").value_or(0.F), -1.F, 1.F);
  desc::Rgb albedo(0.F);
  for (int i = 0; i < 3; ++i) {
    const float scattered = medium.sigma_s[i] * (1.F - g);
    if (scattered > 0.F) albedo[i] = scattered / (scattered + medium.sigma_a[i]);
  }
  return map(albedo, diffuse_reflectance);
}

desc::Node coated(const Original& from, desc::Value color) {
  const TextureParameters& p = from.p;
  p.accept({"scale"});  // scale of distances below the surface
  desc::Node node = desc::material_node("coated_diffuse", {{"coat", "dielectric"}});
  if (!from.is_v4()) {
    // Light is tinted where it enters, not where it leaves.
    if (const auto tint = p.find_spectrum("Kt", true)) color = p.product(from.where, color, *tint);
    if (const auto tint = p.find_spectrum("Kr", true)) node.set("coat_reflectance", *tint);
  }
  node.set("diffuse_reflectance", std::move(color));
  node.set("eta", p.find_number("eta").value_or(1.33F));
  const std::optional<desc::Value> both = from.is_v4() ? p.find_number("roughness") : std::nullopt;
  const auto roughness = [&](const char* name) {
    return p.find_number(name).value_or(both.value_or(0.F));
  };
  node.set("roughness", roughness("uroughness"));
  node.set("roughness_v", roughness("vroughness"));
  const char* remapped = from.is_v4() ? "square" : "log";
  node.set("roughness_scale",
           std::string(p.flag("remaproughness").value_or(true) ? remapped : "alpha"));
  return node;
}

desc::Node subsurface(const Original& from) { return coated(from, color_below(from)); }
desc::Node kd_subsurface(const Original& from) {
  from.p.find_spectrum("mfp");
  from.p.accept({"g"});
  return coated(from, from.p.find_spectrum("Kd", true).value_or(Vec3(0.5F)));
}
desc::Node fourier(const Original& from) {
  from.p.accept({"bsdffile"});
  return matte(desc::Rgb(0.5F));
}
desc::Node measured(const Original& from) {
  from.p.accept({"filename"});
  return matte(desc::Rgb(0.5F));
}

struct StandIn {
  std::string_view type;
  desc::Node (*make)(const Original& from);
  bool is_subsurface;
  std::optional<Dialect> only;
};
constexpr std::array<StandIn, 5> kStandIns = {{{"hair", hair, false, {}},
                                               {"subsurface", subsurface, true, {}},
                                               {"kdsubsurface", kd_subsurface, true, Dialect::V3},
                                               {"fourier", fourier, false, Dialect::V3},
                                               {"measured", measured, false, Dialect::V4}}};

}  // namespace

std::optional<desc::Node> make_stand_in(const SourceLocation& where, const std::string& type,
                                        const TextureParameters& parameters) {
  const Context& context = parameters.context();
  for (const StandIn& known : kStandIns) {
    if (known.type != type || known.only.value_or(context.choice.dialect) != context.choice.dialect)
      continue;
    context.warnings.add(known.is_subsurface ? kNoSubsurface : kStandIn, where,
                         "material \"" + type + "\" is not supported: " +
                             (known.is_subsurface ? "a coated matte one" : "a matte one") +
                             " stands in",
                         type);
    return known.make({where, parameters});
  }
  return std::nullopt;
}

std::vector<std::string> stand_in_types(Dialect dialect) {
  std::vector<std::string> types;
  for (const StandIn& known : kStandIns) {
    if (known.only.value_or(dialect) == dialect) types.emplace_back(known.type);
  }
  return types;
}

}  // namespace ajar::pbrt
