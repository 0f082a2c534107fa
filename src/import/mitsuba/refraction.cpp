#include "import/mitsuba/refraction.h"

#include <algorithm>
#include <array>

#include "core/printable_text.h"
#include "import/mitsuba/names.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kUnknownMaterial{
    Effect::Surface, "indices of refraction have unknown names: that of glass stands in"};

struct NamedIndex {
  std::string_view name;
  float index;
};
/// The materials that Mitsuba has by name. Source: Hecht, Optics, 4th edition, and the makers of
/// the plastics; at about 589 nm and room temperature.
constexpr std::array<NamedIndex, 23> kIndices = {
    {{"vacuum", 1.F},       {"helium", 1.000036F},        {"hydrogen", 1.000132F},
     {"air", 1.000277F},    {"carbon dioxide", 1.00045F}, {"water", 1.333F},
     {"acetone", 1.36F},    {"ethanol", 1.361F},          {"carbon tetrachloride", 1.461F},
     {"glycerol", 1.4729F}, {"benzene", 1.501F},          {"silicone oil", 1.52045F},
     {"bromine", 1.661F},   {"water ice", 1.31F},         {"fused quartz", 1.458F},
     {"pyrex", 1.47F},      {"acrylic glass", 1.49F},     {"polypropylene", 1.49F},
     {"bk7", 1.5046F},      {"sodium chloride", 1.544F},  {"amber", 1.55F},
     {"pet", 1.575F},       {"diamond", 2.419F}}};

std::optional<float> index_named(std::string_view name) {
  const auto found = std::find_if(kIndices.begin(), kIndices.end(),
                                  [&](const NamedIndex& entry) { return entry.name == name; });
  return found == kIndices.end() ? std::nullopt : std::optional<float>(found->index);
}

}  // namespace

float index_of_refraction(Arguments& arguments, std::string_view parameter,
                          std::string_view fallback) {
  const bool is_named = arguments.has_text(parameter);
  if (!is_named) {
    const std::optional<double> index = arguments.number(parameter);
    if (!index) return *index_named(fallback);
    if (!(*index > 0.0)) {
      throw SceneError(arguments.where(), "\"" + std::string(parameter) + "\" must be above 0");
    }
    return static_cast<float>(*index);
  }
  const std::string name = *arguments.text(parameter);
  if (const std::optional<float> index = index_named(lower_case(name))) return *index;
  std::vector<std::string> valid;
  for (const NamedIndex& entry : kIndices) valid.emplace_back(entry.name);
  arguments.context().warnings.add(
      kUnknownMaterial, arguments.where(),
      unknown_name_message("material for \"" + std::string(parameter) + "\"", printable(name),
                           valid) +
          ". Its default stands in",
      printable(name));
  return *index_named(fallback);
}

float relative_index(Arguments& arguments, std::string_view interior) {
  const float inside = index_of_refraction(arguments, "int_ior", interior);
  return inside / index_of_refraction(arguments, "ext_ior", "air");
}

}  // namespace ajar::mitsuba
