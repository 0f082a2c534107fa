#include "import/mitsuba/media.h"

#include <algorithm>

#include "core/printable_text.h"
#include "import/common/scattering_presets.h"
#include "import/mitsuba/names.h"
#include "import/mitsuba/plugin_types.h"
#include "import/mitsuba/volumes.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kUnknownMedium{Effect::Surface,
                                     "media are unknown: homogeneous ones stand in"};
constexpr WarningKind kPreset{Effect::Surface, "media are unknown presets: skin stands in"};
constexpr WarningKind kTwoKinds{
    Effect::Surface,
    "media say their coefficients twice, which Mitsuba refuses: one of them counts"};
constexpr WarningKind kPresetAnisotropy{
    Effect::Surface, "media have a \"g\" beside that of their preset: they scatter too little"};
constexpr WarningKind kPhase{
    Effect::Surface, "media have a phase function that is not supported: another stands in"};
constexpr WarningKind kNegative{Effect::Slight, "coefficients of media are negative: taken as 0"};

constexpr const char* kUsualPreset = "Skin1";

/// Presets of Mitsuba 0.x, by names in small letters: the coefficients of the sources by 100, but
/// for a digit; the scattering is the reduced one, and isotropic. Source: its table of materials.
std::optional<ScatteringPreset> find_preset(const std::string& name) {
  const bool is_beer = name == "budweiser beder";
  const bool is_orange = name == "orange juice powder";
  std::optional<ScatteringPreset> preset = find_scattering_preset(is_beer     ? "Budweiser Beer"
                                                                  : is_orange ? "Orange Powder"
                                                                              : name);
  if (!preset) return preset;
  if (name == "chicken1") preset->sigma_a.x = 0.0015F;
  if (name == "chicken2") preset->sigma_a.x = 0.0018F;
  preset->sigma_s *= 100.F;
  preset->sigma_a *= 100.F;
  return preset;
}

/// The preset "material", or skin, the default of Mitsuba 0.x.
ScatteringPreset preset_of(Arguments& arguments) {
  const std::string name = arguments.text("material", kUsualPreset);
  if (const std::optional<ScatteringPreset> preset = find_preset(lower_case(name))) return *preset;
  arguments.context().warnings.add(
      kPreset, arguments.where(),
      unknown_name_message("medium preset", printable(name), scattering_preset_names()) +
          ". Skin1 stands in",
      printable(name));
  return *find_preset(lower_case(kUsualPreset));
}

/// Defaults of Mitsuba 2 and 3.
constexpr float kDefaultExtinction = 1.F;
constexpr float kDefaultAlbedo = 0.75F;

bool has_presets(const Arguments& arguments) {
  return arguments.context().document.major_version == 0 &&
         arguments.element().type != "heterogeneous";
}

/// Mitsuba 0.x refuses such media, and later versions do not know "sigma_a" and "sigma_s".
void check_coefficients(Arguments& arguments, bool has_parts, bool has_sum) {
  const auto warn = [&](const std::string& reason) {
    arguments.context().warnings.add(kTwoKinds, arguments.where(), reason);
  };
  if (has_parts && has_sum) {
    warn("\"sigma_a\" and \"sigma_s\" are left out beside \"sigma_t\" or \"albedo\"");
  }
  if ((has_parts || has_sum) && has_presets(arguments) && arguments.has("material")) {
    warn("beside coefficients a preset is only what they leave open");
  }
}

/// Sets absorption and scattering from the two themselves, or from their sum and the albedo.
void set_coefficients(Arguments& arguments, desc::Medium& medium) {
  std::optional<ScatteringPreset> preset;
  if (has_presets(arguments)) preset = preset_of(arguments);
  const std::optional<desc::Rgb> sigma_a = find_coefficient(arguments, "sigma_a");
  const std::optional<desc::Rgb> sigma_s = find_coefficient(arguments, "sigma_s");
  std::optional<VolumeValue> sigma_t = find_density(arguments, "sigma_t");
  const std::optional<VolumeValue> albedo = find_albedo(arguments, "albedo");
  if (!sigma_t && arguments.has("density")) sigma_t = find_density(arguments, "density");
  check_coefficients(arguments, sigma_a || sigma_s, sigma_t || albedo);
  const desc::Rgb sum = preset ? preset->sigma_s + preset->sigma_a : desc::Rgb(kDefaultExtinction);
  const VolumeValue usual_extinction = constant_density(arguments, sum);
  const VolumeValue usual_albedo{preset ? preset->sigma_s / sum : desc::Rgb(kDefaultAlbedo)};
  if (sigma_t || albedo) {
    set_extinction(arguments, medium, sigma_t.value_or(usual_extinction),
                   albedo.value_or(usual_albedo));
  } else if (sigma_a || sigma_s) {
    medium.sigma_a = sigma_a.value_or(preset ? preset->sigma_a : desc::Rgb(0.F));
    medium.sigma_s = sigma_s.value_or(preset ? preset->sigma_s : desc::Rgb(0.F));
  } else if (preset) {
    medium.sigma_a = preset->sigma_a;
    medium.sigma_s = preset->sigma_s;
  } else {
    set_extinction(arguments, medium, usual_extinction, usual_albedo);
  }
}

/// Mitsuba 0.x takes a "g" of the medium for how much less it scatters, not for its phase function.
void reduce_scattering(Arguments& arguments, desc::Medium& medium) {
  const desc::Rgb g = arguments.color("g", "a number").value_or(desc::Rgb(0.F));
  for (int i = 0; i < 3; ++i) {
    if (!(g[i] > -1.F && g[i] < 1.F)) {
      throw SceneError(arguments.where(), "\"g\" must be between -1 and 1");
    }
  }
  if (!has_presets(arguments)) return;
  if (arguments.has("g") && arguments.has("material")) {
    arguments.context().warnings.add(
        kPresetAnisotropy, arguments.where(),
        "the \"g\" of a preset is counted already, and that of the file beside it");
  }
  medium.sigma_s *= desc::Rgb(1.F) - g;
}

float read_phase(Arguments& arguments) {
  const Element* element = arguments.only_child("phase");
  if (element == nullptr) {
    return arguments.context().document.major_version == 0 ? 0.F : arguments.number("g", 0.F);
  }
  Arguments phase(arguments.context(), *element);
  const std::string& type = element->type;
  const float g = type == "hg" ? phase.number("g", 0.8F) : 0.F;
  if (!is_known(*element)) {
    arguments.context().warnings.add(
        kPhase, phase.where(),
        "phase function \"" + printable(type) + "\" is not supported: an isotropic one stands in",
        printable(type));
    phase.accept_all();
  }
  return g;
}

}  // namespace

desc::MediumId MediumTable::make(const Element& element) {
  if (const auto known = made_.find(&element); known != made_.end()) return known->second;
  Arguments arguments(context_, element);
  desc::Medium medium;
  medium.name = element.id;
  medium.where = element.where;
  if (!is_known(element)) {
    context_.warnings.add(kUnknownMedium, element.where,
                          unknown_type_message(element) + ". A homogeneous one stands in",
                          printable(element.type));
  }
  set_coefficients(arguments, medium);
  if (context_.document.major_version == 0) reduce_scattering(arguments, medium);
  const float scale = arguments.number("scale", 1.F);
  for (desc::Rgb* coefficients : {&medium.sigma_a, &medium.sigma_s}) {
    *coefficients *= scale;
    if (!is_finite(*coefficients)) throw SceneError(element.where, "the medium is too dense");
    const desc::Rgb given = *coefficients;
    for (int i = 0; i < 3; ++i) (*coefficients)[i] = std::max(given[i], 0.F);
    if (*coefficients != given) {
      context_.warnings.add(kNegative, element.where,
                            "a coefficient of this medium is negative: taken as 0");
    }
  }
  medium.g = read_phase(arguments);
  if (!(medium.g > -1.F && medium.g < 1.F)) {
    throw SceneError(element.where, "\"g\" must be between -1 and 1");
  }
  arguments.accept({"has_spectral_extinction", "sample_emitters", "method", "strategy"});
  if (!is_known(element)) arguments.accept_all();
  context_.scene.media.push_back(std::move(medium));
  return made_[&element] = static_cast<desc::MediumId>(context_.scene.media.size()) - 1;
}

desc::MediumId MediumTable::find(Arguments& arguments, std::string_view name) {
  const Element* medium = arguments.child(name, "medium");
  return medium == nullptr ? desc::kNone : make(*medium);
}

}  // namespace ajar::mitsuba
