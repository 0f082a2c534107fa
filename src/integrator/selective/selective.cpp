#include "integrator/selective/selective.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/meaningless_parameters.h"
#include "integrator/metropolis/path_space.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/selective/chain_family.h"
#include "integrator/selective/selective_moves.h"
#include "integrator/selective/selective_settings.h"

namespace ajar {

namespace {

/// Parameters of chains that mean nothing where regions are divided.
constexpr std::array<std::string_view, 2> kOfNoRegions = {"direct", "omc-samples"};

bool is_of_no_regions(std::string_view name) {
  return std::find(kOfNoRegions.begin(), kOfNoRegions.end(), name) != kOfNoRegions.end();
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
  const std::string& chain = parameters.get_text("chain");
  if (chain == "mlt") return ChainKind::ExplicitPath;
  if (chain == "erpt") return ChainKind::SpreadPath;
  if (chain == "pssmlt") return ChainKind::WholePath;
  return chain == "mmlt" ? ChainKind::OnePath : ChainKind::ByPath;
}

bool has(std::span<const ParameterSpec> specs, const std::string& name) {
  return std::any_of(specs.begin(), specs.end(),
                     [&](const ParameterSpec& spec) { return spec.name == name; });
}

/// Parameters of one kind of chains mean nothing for others: how numbers move, and which samples
/// of a bootstrap are seeds, for explicit paths; how these do, for numbers.
void limit_to_chains(ParameterSpec& spec) {
  const bool of_numbers =
      has(SelectiveMoves::parameters(), spec.name) || spec.name.starts_with("seed");
  const bool of_paths = has(path_mutation_parameters(), spec.name);
  if (!of_numbers && !of_paths) return;
  spec.depends_on = "chain";
  spec.matters_for = of_paths ? std::vector<std::string>{"auto", "mlt", "erpt"}
                              : std::vector<std::string>{"auto", "mmlt", "pssmlt"};
}

bool divides_regions(const Parameters& parameters) {
  return parameters.get_text("division") == "regions";
}

}  // namespace

std::vector<ParameterSpec> selective_parameters() {
  std::vector<ParameterSpec> specs = SelectiveSettings::parameters();
  // Defaults are shown as mmlt has them.
  for (const ChainKind kind : {ChainKind::OnePath, ChainKind::ExplicitPath, ChainKind::WholePath}) {
    for (ParameterSpec& spec : chain_parameters(kind)) {
      const bool known = has(specs, spec.name);
      if (can_be_open(spec.name)) leave_open(spec);
      if (is_of_no_regions(spec.name)) {
        spec.depends_on = "division";
        spec.matters_for = {"everywhere"};
      }
      limit_to_chains(spec);
      if (!known) specs.push_back(std::move(spec));
    }
  }
  mark_experts(specs, {"objective", "chain", "techniques", kLightPathsPerPixel, "regions",
                       "importance", "edges"});
  return specs;
}

std::unique_ptr<Integrator> make_selective_integrator(const Scene& scene,
                                                      const RenderSettings& settings,
                                                      const Parameters& parameters) {
  refuse_meaningless(selective_parameters(), parameters);
  const ChainKind kind = chain_kind(parameters);
  const bool has_light_paths = parameters.get_text(kLightPathsPerPixel) != SelectiveSettings::kOpen;
  if (has_light_paths && kind == ChainKind::WholePath) {
    throw UsageError(kLightPathsPerPixel +
                     ": not with chain=pssmlt, of which a state has one light subpath");
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
  if (divides_regions(parameters)) {
    regions = SelectiveSettings::read(parameters, settings);
    chain.emplace("techniques", regions->techniques);
  }
  return make_chain_integrator(kind, scene, settings, Parameters(specs, chain), std::move(regions));
}

}  // namespace ajar
