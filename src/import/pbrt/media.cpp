#include "import/pbrt/media.h"

#include <array>
#include <numeric>

#include "import/common/printable.h"
#include "import/pbrt/lexer.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kUnknownPreset{Effect::Surface,
                                     "media have unknown presets: Wholemilk stands in"};
constexpr WarningKind kHeterogeneous{
    Effect::Surface,
    "heterogeneous media are not supported: homogeneous ones of the mean density stand in"};

/// Reduced scattering and absorption coefficients, 1/mm.
struct Preset {
  std::string_view name;
  float sigma_s[3];
  float sigma_a[3];
};
/// Source: Jensen et al. 2001, A practical model for subsurface light transport, figure 5.
constexpr std::array<Preset, 12> kPresets = {
    {{"Apple", {2.29F, 2.39F, 1.97F}, {0.0030F, 0.0034F, 0.046F}},
     {"Chicken1", {0.15F, 0.21F, 0.38F}, {0.015F, 0.077F, 0.19F}},
     {"Chicken2", {0.19F, 0.25F, 0.32F}, {0.018F, 0.088F, 0.20F}},
     {"Cream", {7.38F, 5.47F, 3.15F}, {0.0002F, 0.0028F, 0.0163F}},
     {"Ketchup", {0.18F, 0.07F, 0.03F}, {0.061F, 0.97F, 1.45F}},
     {"Marble", {2.19F, 2.62F, 3.00F}, {0.0021F, 0.0041F, 0.0071F}},
     {"Potato", {0.68F, 0.70F, 0.55F}, {0.0024F, 0.0090F, 0.12F}},
     {"Skimmilk", {0.70F, 1.22F, 1.90F}, {0.0014F, 0.0025F, 0.0142F}},
     {"Skin1", {0.74F, 0.88F, 1.01F}, {0.032F, 0.17F, 0.48F}},
     {"Skin2", {1.09F, 1.59F, 1.79F}, {0.013F, 0.070F, 0.145F}},
     {"Spectralon", {11.6F, 20.4F, 14.9F}, {0.0F, 0.0F, 0.0F}},
     {"Wholemilk", {2.55F, 3.21F, 3.77F}, {0.0011F, 0.0024F, 0.014F}}}};
/// What pbrt-v3 takes if nothing is said: whole milk.
constexpr const Preset& kDefault = kPresets[11];

const Preset& preset_of(Context& context, const SourceLocation& where,
                        const ParameterList& parameters) {
  const std::optional<std::string> name = parameters.get_string("preset");
  if (!name || name->empty()) return kDefault;
  std::vector<std::string> valid;
  for (const Preset& preset : kPresets) {
    if (preset.name == *name) return preset;
    valid.emplace_back(preset.name);
  }
  context.warnings.add(kUnknownPreset, where,
                       unknown_name_message("medium preset", printable(*name), valid) + ". " +
                           std::string(kDefault.name) + " stands in",
                       printable(*name));
  return kDefault;
}

/// Mean of the grid of a heterogeneous medium, 1 if there is none.
float mean_density(const ParameterList& parameters) {
  const Parameter* density = parameters.find("density", ParameterKind::Float);
  if (density == nullptr || density->numbers.empty()) return 1.F;
  const double sum = std::accumulate(density->numbers.begin(), density->numbers.end(), 0.0);
  return static_cast<float>(sum / static_cast<double>(density->numbers.size()));
}

}  // namespace

desc::Medium make_medium(Context& context, const SourceLocation& where, const std::string& name,
                         const ParameterList& parameters) {
  const std::optional<std::string> type = parameters.get_string("type");
  if (!type) throw SceneError(where, "MakeNamedMedium needs \"string type\"");
  if (*type != "homogeneous" && *type != "heterogeneous") {
    fail_unknown(where, "medium", *type, {"homogeneous", "heterogeneous"});
  }
  const Preset& preset = preset_of(context, where, parameters);
  const auto rgb = [](const float(&v)[3]) { return desc::Rgb(v[0], v[1], v[2]); };
  desc::Medium medium;
  medium.name = name;
  medium.where = where;
  float scale = parameters.get_float("scale", 1.F);
  medium.g = parameters.get_float("g", 0.F);
  if (*type == "heterogeneous") {
    context.warnings.add(
        kHeterogeneous, where,
        "heterogeneous media are not supported: a homogeneous one of the mean density stands in",
        printable(name));
    scale *= mean_density(parameters);
    parameters.accept({"nx", "ny", "nz", "p0", "p1"});
  }
  if (scale < 0.F) throw SceneError(where, "\"scale\" of a medium is negative");
  if (!(medium.g > -1.F && medium.g < 1.F))
    throw SceneError(where, "\"g\" must be between -1 and 1");
  medium.sigma_a = context.spectra.get_positive(parameters, "sigma_a", rgb(preset.sigma_a)) * scale;
  medium.sigma_s = context.spectra.get_positive(parameters, "sigma_s", rgb(preset.sigma_s)) * scale;
  if (!is_finite(medium.sigma_a) || !is_finite(medium.sigma_s))
    throw SceneError(where, "the medium is too dense");
  parameters.report_unused(context.warnings);
  return medium;
}

}  // namespace ajar::pbrt
