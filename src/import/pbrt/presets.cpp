#include "import/pbrt/presets.h"

#include "core/printable_text.h"
#include "import/pbrt/lexer.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kUnknownPreset{Effect::Surface,
                                     "presets of scattering are unknown: Wholemilk stands in"};
constexpr const char* kDefaultPreset = "Wholemilk";

}  // namespace

ScatteringPreset default_preset() { return *find_scattering_preset(kDefaultPreset); }

std::optional<ScatteringPreset> preset_named(const Context& context, const SourceLocation& where,
                                             const std::optional<std::string>& name) {
  if (!name || name->empty()) return std::nullopt;
  if (const std::optional<ScatteringPreset> preset = find_scattering_preset(*name)) return preset;
  context.warnings.add(
      kUnknownPreset, where,
      unknown_name_message("medium preset", printable(*name), scattering_preset_names()) + ". " +
          kDefaultPreset + " stands in",
      printable(*name));
  return default_preset();
}

}  // namespace ajar::pbrt
