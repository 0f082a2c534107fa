#include "import/pbrt/stand_ins.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "import/common/scattering_presets.h"
#include "scene/desc/models.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kStandIn{Effect::Surface, "materials are not supported: matte ones stand in"};
constexpr WarningKind kNoSubsurface{
    Effect::Surface, "materials scatter below their surface: coated matte ones stand in"};

desc::Rgb map(const desc::Rgb& color, float (*function)(float)) {
  return {function(color.x), function(color.y), function(color.z)};
}

desc::Node matte(desc::Value color) {
  return desc::material_node("diffuse", {{"reflectance", std::move(color)}});
}

/// Colour of a mass of hair, which scatters light many times. Source: Chiang et al. 2016, "A
/// practical and controllable hair and fur model", section 4.2; absorption by melanin: d'Eon et al.
/// 2011, section 6.1.
desc::Node hair(const TextureParameters& p) {
  if (const std::optional<desc::Value> color = p.find_spectrum("color")) return matte(*color);
  desc::Rgb sigma_a;
  if (const std::optional<desc::Rgb> given = p.color("sigma_a", true)) {
    sigma_a = *given;
  } else {
    const std::optional<float> pheomelanin = p.number("pheomelanin");
    const float eumelanin = p.number("eumelanin").value_or(pheomelanin ? 0.F : 1.3F);
    sigma_a = desc::Rgb(0.419F, 0.697F, 1.37F) * std::max(eumelanin, 0.F) +
              desc::Rgb(0.187F, 0.4F, 1.05F) * std::max(pheomelanin.value_or(0.F), 0.F);
  }
  const float b = p.number("beta_n").value_or(0.3F);
  const float scattering = 5.969F - 0.215F * b + 2.532F * b * b - 10.73F * b * b * b +
                           5.574F * b * b * b * b + 0.245F * b * b * b * b * b;
  const desc::Rgb roots = map(sigma_a, [](float x) { return std::sqrt(x); });
  return matte(map(roots * -scattering, [](float x) { return std::exp(x); }));
}

/// Diffuse reflectance of a thick medium whose boundary refracts nothing; `reduced_albedo` is of
/// isotropic scattering. Source: Jensen et al. 2001, section 2.4, with A = 1.
float diffuse_reflectance(float reduced_albedo) {
  const float root = std::sqrt(3.F * std::max(1.F - reduced_albedo, 0.F));
  return 0.5F * reduced_albedo * (1.F + std::exp(-4.F / 3.F * root)) * std::exp(-root);
}

/// What light that enters the medium comes back as.
desc::Value subsurface_color(const TextureParameters& p, const char* reflectance) {
  if (const std::optional<desc::Value> color = p.find_spectrum(reflectance)) return *color;
  ScatteringPreset medium{{2.55F, 3.21F, 3.77F}, {0.0011F, 0.0024F, 0.014F}};
  bool is_reduced = true;
  if (const std::optional<std::string> name = p.text("name")) {
    medium = find_scattering_preset(*name).value_or(medium);
  }
  if (const std::optional<desc::Rgb> given = p.color("sigma_s", true)) {
    medium.sigma_s = *given;
    is_reduced = false;
  }
  medium.sigma_a = p.color("sigma_a", true).value_or(medium.sigma_a);
  const float g = is_reduced ? 0.F : std::clamp(p.number("g").value_or(0.F), -1.F, 1.F);
  desc::Rgb albedo(0.F);
  for (int i = 0; i < 3; ++i) {
    const float scattered = medium.sigma_s[i] * (1.F - g);
    if (scattered > 0.F) albedo[i] = scattered / (scattered + medium.sigma_a[i]);
  }
  return map(albedo, diffuse_reflectance);
}

desc::Node subsurface(const TextureParameters& p, const char* reflectance) {
  desc::Node node = desc::material_node("coated_diffuse", {{"coat", "dielectric"}});
  node.set("diffuse_reflectance", subsurface_color(p, reflectance));
  node.set("eta", p.find_number("eta").value_or(1.33F));
  const std::optional<desc::Value> both = p.find_number("roughness");
  const auto roughness = [&](const char* name) {
    return p.find_number(name).value_or(both.value_or(0.F));
  };
  node.set("roughness", roughness("uroughness"));
  node.set("roughness_v", roughness("vroughness"));
  const char* remapped = p.context().is_v4() ? "square" : "log";
  node.set("roughness_scale",
           std::string(p.flag("remaproughness").value_or(true) ? remapped : "alpha"));
  return node;
}

desc::Node grey(const TextureParameters&) { return matte(desc::Rgb(0.5F)); }
desc::Node by_coefficients(const TextureParameters& p) {
  // pbrt-v4 has one type for what are two in pbrt-v3.
  return subsurface(p, p.context().is_v4() ? "reflectance" : "");
}
desc::Node by_reflectance(const TextureParameters& p) { return subsurface(p, "Kd"); }

struct StandIn {
  std::string_view type;
  desc::Node (*make)(const TextureParameters& parameters);
  bool is_subsurface;
  std::optional<Dialect> only;
};
constexpr std::array<StandIn, 5> kStandIns = {{{"hair", hair, false, {}},
                                               {"subsurface", by_coefficients, true, {}},
                                               {"kdsubsurface", by_reflectance, true, Dialect::V3},
                                               {"fourier", grey, false, Dialect::V3},
                                               {"measured", grey, false, Dialect::V4}}};

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
    desc::Node node = known.make(parameters);
    parameters.accept({"bsdffile",    "filename",   "sigma_a",    "sigma_s",   "eumelanin",
                       "pheomelanin", "eta",        "beta_m",     "beta_n",    "alpha",
                       "name",        "scale",      "Kr",         "Kt",        "g",
                       "mfp",         "uroughness", "vroughness", "roughness", "remaproughness",
                       "reflectance"});
    return node;
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
