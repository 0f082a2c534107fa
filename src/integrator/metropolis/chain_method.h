#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "integrator/integrator.h"
#include "integrator/metropolis/path_group.h"

namespace ajar {

/// Common settings of published methods whose chains make all light.
struct ChainOrder {
  PathSamplerSettings sampler;  ///< sampler of the bootstrap
  std::vector<PathGroup> groups;
  std::uint64_t bootstrap = 0;          ///< samples, over all groups and replicates
  Parameters monte_carlo;               ///< parameters of the fallback without a bootstrap
  std::vector<std::string> notes = {};  ///< notes for the user on the chains
  const ChainWeight* part = nullptr;    ///< weight of chains; null if they make all light
};

/// All but the groups, by the parameter `bootstrap` and those of the family of path sampling.
ChainOrder chain_order(const RenderSettings& settings, const Parameters& parameters,
                       const std::map<std::string, std::string>& path_parameters);

/// The parameter of that name.
ParameterSpec bootstrap_parameter();

/// Common base of them, beside their chains: film and messages.
class ChainMethod : public Integrator {
 public:
  ChainMethod(const Scene& scene, const RenderSettings& settings, ChainOrder order);

  void skip_preparation(PreparationCut of) override;
  Findings findings() const override;
  std::vector<LayerSpec> layers() const override;
  bool is_of_chains(std::uint64_t /*item*/) const override { return !unprepared_; }
  DevelopScale develop_scale(const LayerSpec& layer, std::uint64_t samples,
                             std::optional<int> replicate) const override;
  bool keeps_state() const override { return !unprepared_; }

 protected:
  /// Light of the picture, the mean over its pixels; 0 if none was found.
  virtual double brightness() const = 0;
  virtual bool has_chains() const = 0;

  const Scene& scene() const { return scene_; }
  const RenderSettings& settings() const { return settings_; }
  const ChainView& view() const { return view_; }
  const ChainOrder& order() const { return order_; }
  std::span<const PathGroup> groups() const { return order_.groups; }
  /// In camera samples per pixel, if a path of the bootstrap is as dear as one.
  double bootstrap_effort() const { return static_cast<double>(order_.bootstrap) / view_.pixels; }
  void add_concern(Warning concern) { concerns_.push_back(std::move(concern)); }
  /// Integrator in use if there was no time for a bootstrap; else null.
  Integrator* unprepared() const { return unprepared_.get(); }

 private:
  const Scene& scene_;
  RenderSettings settings_;
  ChainView view_;
  ChainOrder order_;
  std::vector<Warning> concerns_;
  bool misses_light_ = !concerns_.empty();
  std::unique_ptr<Integrator> unprepared_;
};

}  // namespace ajar
