#include "integrator/selective.h"

#include <algorithm>
#include <array>

#include "integrator/chain_pilot.h"
#include "integrator/chain_spreader.h"

namespace ajar {

namespace {

/// Parameters of chains that mean something here.
constexpr std::array<std::string_view, 6> kShared = {"techniques", "heuristic",  "mutation",
                                                     "sigma",      "importance", "split"};

/// The plan of chains that only follow what ordinary Monte Carlo finds.
Parameters chain_parameters_of(const Parameters& parameters) {
  std::map<std::string, std::string> given(parameters.values().begin(), parameters.values().end());
  return {chain_parameters(ChainKind::OnePath), given};
}

class SelectiveIntegrator final : public Integrator {
 public:
  SelectiveIntegrator(const Scene& scene, const RenderSettings& settings,
                      const Parameters& parameters)
      : plan_(ChainKind::OnePath, scene, settings, chain_parameters_of(parameters)),
        pilot_(plan_),
        spreaders_(plan_) {
    // Large steps would only lead away from where the path's light belongs.
    plan_.chain_settings.probabilities.large = 0.0;
  }

  std::uint64_t begin_preparation(int round) override {
    if (round == 0) return pilot_.begin();
    pilot_.end();
    const RenderSettings& settings = plan_.settings;
    // With a black pilot there is nothing to divide by, and nothing to see either.
    const bool divided = plan_.split.has_value();
    omc_ = plan_.make_omc(settings, {settings.min_depth, settings.max_depth},
                          divided ? &*plan_.split : nullptr, divided ? &spreaders_ : nullptr);
    return 0;
  }
  void prepare_item(int /*round*/, std::uint64_t item, Counters& counters) override {
    pilot_.run(item, counters);
  }

  std::vector<LayerSpec> layers() const override { return omc_->layers(); }
  std::uint64_t items_in_pass() const override { return omc_->items_in_pass(); }
  void run_item(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples, Film& film,
                Counters& counters) override {
    omc_->run_item(item, first_sample, samples, film, counters);
  }
  double develop_scale(const LayerSpec& layer, std::uint64_t samples,
                       std::optional<int> replicate) const override {
    return omc_->develop_scale(layer, samples, replicate);
  }
  // Its chains live for one path only.
  bool can_save_state() const override { return true; }
  bool keeps_state() const override { return false; }

 private:
  ChainPlan plan_;
  ChainPilot pilot_;
  ChainSpreaders spreaders_;
  std::unique_ptr<Integrator> omc_;
};

}  // namespace

std::vector<ParameterSpec> selective_parameters() {
  std::vector<ParameterSpec> specs = chain_parameters(ChainKind::OnePath);
  std::erase_if(specs, [](const ParameterSpec& spec) {
    return std::find(kShared.begin(), kShared.end(), spec.name) == kShared.end();
  });
  for (ParameterSpec& spec : specs) {
    if (spec.name == "split") spec.minimum = 0.01;
    if (spec.name == "mutation") spec.choices = {"gaussian", "kelemen"};
  }
  return specs;
}

std::unique_ptr<Integrator> make_selective_integrator(const Scene& scene,
                                                      const RenderSettings& settings,
                                                      const Parameters& parameters) {
  return std::make_unique<SelectiveIntegrator>(scene, settings, parameters);
}

}  // namespace ajar
