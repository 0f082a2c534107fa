#include "import/pbrt/media.h"

#include <numeric>

#include "import/common/printable.h"
#include "import/common/scattering_presets.h"
#include "import/pbrt/lexer.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kUnknownPreset{Effect::Surface,
                                     "media have unknown presets: Wholemilk stands in"};
constexpr WarningKind kHeterogeneous{
    Effect::Surface,
    "heterogeneous media are not supported: homogeneous ones of the mean density stand in"};

/// What pbrt-v3 takes if nothing is said, or nothing it knows.
constexpr const char* kDefault = "Wholemilk";

ScatteringPreset preset_of(Context& context, const SourceLocation& where,
                           const ParameterList& parameters) {
  const std::string name = parameters.get_string("preset", "");
  if (const auto preset = find_scattering_preset(name.empty() ? kDefault : name)) return *preset;
  context.warnings.add(
      kUnknownPreset, where,
      unknown_name_message("medium preset", printable(name), scattering_preset_names()) + ". " +
          kDefault + " stands in",
      printable(name));
  return *find_scattering_preset(kDefault);
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
  const ScatteringPreset preset = preset_of(context, where, parameters);
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
  medium.sigma_a = context.spectra.get_positive(parameters, "sigma_a", preset.sigma_a) * scale;
  medium.sigma_s = context.spectra.get_positive(parameters, "sigma_s", preset.sigma_s) * scale;
  if (!is_finite(medium.sigma_a) || !is_finite(medium.sigma_s))
    throw SceneError(where, "the medium is too dense");
  parameters.report_unused(context.warnings);
  return medium;
}

}  // namespace ajar::pbrt
