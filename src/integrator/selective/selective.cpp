#include "integrator/selective/selective.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "core/error.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/selective/chain_family.h"
#include "integrator/selective/selective_settings.h"

namespace ajar {

namespace {

/// Parameters of chains that mean nothing where regions are divided.
constexpr std::array<std::string_view, 2> kOfNoRegions = {"direct", "omc-samples"};
/// Parameters that say what is done, not how.
constexpr std::array<std::string_view, 3> kOfAnyDivision = {"division", "chain", "preset"};

bool is_among(std::span<const std::string_view> names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Parameters of chains that are left to a pilot unless the user knows better. That is a value of
/// theirs, since a checkpoint keeps values and not who gave them.
const std::array<std::string, 2> kOpen = {"techniques", kLightPathsPerPixel};

bool can_be_open(const std::string& name) {
  return std::find(kOpen.begin(), kOpen.end(), name) != kOpen.end();
}

void leave_open(ParameterSpec& spec) {
  spec.default_value = SelectiveSettings::kOpen;
  if (spec.type != ParameterType::Text) spec.choices = {SelectiveSettings::kOpen};
  spec.help += "; auto: as omc has it";
}

ChainKind chain_kind(const Parameters& parameters) {
  return parameters.get_text("chain") == "mmlt" ? ChainKind::OnePath : ChainKind::WholePath;
}

bool divides_regions(const Parameters& parameters) {
  return parameters.get_text("division") == "regions";
}

/// What is given but would mean nothing.
void check_division(const Parameters& parameters) {
  const bool regions = divides_regions(parameters);
  const auto refuse = [](std::string_view name, const char* division) {
    throw UsageError(std::string(name) + ": only with division=" + division);
  };
  const std::vector<ParameterSpec> of_regions = SelectiveSettings::parameters();
  for (const auto& [name, value] : parameters.given()) {
    const bool is_of_regions =
        std::any_of(of_regions.begin(), of_regions.end(),
                    [&, &own = name](const ParameterSpec& spec) { return spec.name == own; });
    if (regions && is_among(kOfNoRegions, name)) refuse(name, "everywhere");
    if (!regions && is_of_regions && !is_among(kOfAnyDivision, name)) refuse(name, "regions");
  }
}

}  // namespace

std::vector<ParameterSpec> selective_parameters() {
  std::vector<ParameterSpec> specs = SelectiveSettings::parameters();
  // Defaults are shown as mmlt has them.
  for (const ChainKind kind : {ChainKind::OnePath, ChainKind::WholePath}) {
    for (ParameterSpec& spec : chain_parameters(kind)) {
      const bool known = std::any_of(specs.begin(), specs.end(), [&](const ParameterSpec& other) {
        return other.name == spec.name;
      });
      if (can_be_open(spec.name)) leave_open(spec);
      if (is_among(kOfNoRegions, spec.name)) spec.help += "; for division=everywhere";
      if (!known) specs.push_back(std::move(spec));
    }
  }
  mark_experts(specs,
               {"chain", "techniques", kLightPathsPerPixel, "regions", "importance", "edges"});
  return specs;
}

std::unique_ptr<Integrator> make_selective_integrator(const Scene& scene,
                                                      const RenderSettings& settings,
                                                      const Parameters& parameters) {
  check_division(parameters);
  const ChainKind kind = chain_kind(parameters);
  const bool has_light_paths = parameters.get_text(kLightPathsPerPixel) != SelectiveSettings::kOpen;
  if (has_light_paths && kind == ChainKind::WholePath) {
    throw UsageError(kLightPathsPerPixel +
                     ": only with chain=mmlt; a state of pssmlt has one light subpath");
  }
  const std::vector<ParameterSpec> specs = chain_parameters(kind);
  std::map<std::string, std::string> chain;
  for (const ParameterSpec& spec : specs) {
    const auto value = parameters.given().find(spec.name);
    if (value == parameters.given().end()) continue;
    const bool is_open = can_be_open(spec.name) && value->second == SelectiveSettings::kOpen;
    if (!is_open) chain[spec.name] = value->second;
  }
  std::optional<SelectiveSettings> regions;
  if (divides_regions(parameters)) regions = SelectiveSettings::read(parameters, settings);
  return make_chain_integrator(kind, scene, settings, Parameters(specs, chain), std::move(regions));
}

}  // namespace ajar
