#pragma once
#include <cstdint>
#include <vector>

#include "core/archive_forward.h"
#include "integrator/integrator.h"
#include "integrator/selective/chain_effort.h"
#include "integrator/selective/chain_plan.h"
#include "integrator/selective/chain_population.h"
#include "integrator/selective/chain_stretch.h"
#include "integrator/selective/plane_maps.h"

namespace ajar {

/// What chains do in a pass: an item is a chain, or the plain samples of a population without
/// seeds (`takes_plain_samples`). And b, the brightness of what they deposit.
class ChainItems {
 public:
  /// What these refer to must outlive it.
  ChainItems(const ChainPlan& plan, ChainEffort& effort, std::vector<ChainPopulation>& populations,
             const ChainStretch& stretch)
      : plan_(plan), effort_(effort), populations_(populations), stretch_(stretch) {}

  /// To be called whenever the populations have got other chains. `plain`: whether those without
  /// a seed take plain samples at all.
  void list(bool plain);
  std::size_t count() const { return items_.size(); }

  /// Estimates b of each population anew. Between passes, after a number of samples per pixel that
  /// is fixed in advance.
  void refine_b(std::uint64_t samples);
  /// Of samples after the bootstrap, in all estimates of b (see `ChainPopulation::b`).
  double later_weight() const { return later_weight_; }

  /// Makes the item's part of some samples per pixel; different items at the same time. `maps`:
  /// null if steps do not follow the image plane.
  void run(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples, PlaneMaps* maps,
           Film& film, Counters& counters);

  /// b; the populations have what else is to be kept. `load_state` raises std::runtime_error if
  /// there are other populations.
  void save_state(OutputArchive& archive) const;
  void load_state(InputArchive& archive);
  /// Raises it, too, if it cannot be b of the populations, which have been read meanwhile.
  void check_b() const;
  /// What the items of a share have left behind in their own chains; `first`: number in the pass
  /// of the first of all items.
  void give_news(OutputArchive& archive, const WorkShare& share, std::uint64_t first);
  void take_news(InputArchive& archive, const WorkShare& share, std::uint64_t first);

 private:
  struct Item {
    std::size_t population;
    std::size_t chain;
  };

  void run_chain(const Item& item, std::uint64_t first_sample, std::uint64_t samples,
                 PlaneMaps* maps, Film& film, Counters& counters);
  /// One mutation per pixel's worth.
  void run_plain(ChainPopulation& population, PlaneMaps* maps, Film& film, Counters& counters);
  template <typename A>
  void serialize_chains(A& archive, const WorkShare& share, std::uint64_t first);
  /// What of a chain's deposits the picture takes, if that is not all.
  const Division* kept_by(int replicate) const {
    return plan_.selective && plan_.selective->exclusive && plan_.divisions
               ? &plan_.divisions->of(replicate)
               : nullptr;
  }
  /// Whether plain samples stand for its chains: where the bootstrap has found no seed, but not
  /// for chains of explicit paths, whose b knows of the bootstrap alone.
  bool takes_plain_samples(const ChainPopulation& population) const;
  void share_mutations();
  double share_of(int replicate) const {
    return shares_[static_cast<std::size_t>(replicate) % shares_.size()];
  }
  std::size_t chains_in(int replicate) const {
    return chain_counts_[static_cast<std::size_t>(replicate)];
  }

  const ChainPlan& plan_;
  ChainEffort& effort_;
  std::vector<ChainPopulation>& populations_;
  const ChainStretch& stretch_;
  std::vector<Item> items_;
  std::vector<std::size_t> chain_counts_;  ///< per replicate
  std::vector<double> shares_;  ///< of the mutations, of replicates of each division of the light
  std::vector<double> b_;       ///< of each population
  double later_weight_ = 0.0;
};

}  // namespace ajar
