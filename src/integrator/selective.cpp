#include "integrator/selective.h"

#include <algorithm>
#include <array>

#include "integrator/chain_family.h"

namespace ajar {

namespace {
/// Parameters of chains that mean nothing here, because the survey decides or both halves always
/// run.
constexpr std::array<std::string_view, 3> kDecided = {"omc-samples", "direct", "split"};
}  // namespace

std::vector<ParameterSpec> selective_parameters() {
  std::vector<ParameterSpec> specs = chain_parameters(ChainKind::OnePath);
  std::erase_if(specs, [](const ParameterSpec& spec) {
    return std::find(kDecided.begin(), kDecided.end(), spec.name) != kDecided.end();
  });
  specs.push_back({.name = "bright",
                   .type = ParameterType::Float,
                   .default_value = "10",
                   .unit = "",
                   .help = "paths that bring more than about so many times the brightness of their "
                           "pixel are left to chains",
                   .choices = {},
                   .minimum = 0.1,
                   .maximum = 1e6});
  return specs;
}

std::unique_ptr<Integrator> make_selective_integrator(const Scene& scene,
                                                      const RenderSettings& settings,
                                                      const Parameters& parameters) {
  std::map<std::string, std::string> given(parameters.values().begin(), parameters.values().end());
  given["split"] = given.at("bright");
  given.erase("bright");
  given["omc-samples"] = "1";
  const ChainKind kind = ChainKind::OnePath;
  return make_chain_integrator(kind, scene, settings, Parameters(chain_parameters(kind), given),
                               Selection{});
}

}  // namespace ajar
