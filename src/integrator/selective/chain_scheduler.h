#pragma once
#include <cstdint>
#include <vector>

#include "core/archive_forward.h"
#include "integrator/integrator.h"
#include "integrator/selective/chain_population.h"
#include "integrator/selective/epoch.h"
#include "integrator/selective/preparation.h"
#include "integrator/selective/sample_allocation.h"

namespace ajar {

/// Chains as work items of a pass: an item is a chain.
class ChainScheduler {
 public:
  /// All must outlive it.
  ChainScheduler(const SelectivePreparation& prepared, SampleAllocation& allocation,
                 std::vector<ChainPopulation>& populations, const Epoch& epoch)
      : prepared_(prepared), allocation_(allocation), populations_(populations), epoch_(epoch) {}

  /// Lists the chains anew; to be called whenever the populations have got others.
  void list();
  std::size_t count() const { return items_.size(); }

  /// Makes an item's part of some samples per pixel; different items at the same time.
  void run(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples, Film& film,
           Counters& counters);

  /// Exchanges the chains of the items of a slice with other processes; `first`: number in the pass
  /// of the first of all items.
  void export_delta(OutputArchive& archive, const WorkSlice& slice, std::uint64_t first);
  void import_delta(InputArchive& archive, const WorkSlice& slice, std::uint64_t first);

 private:
  struct Item {
    std::size_t population;
    std::size_t chain;
  };

  template <typename A>
  void serialize_chains(A& archive, const WorkSlice& slice, std::uint64_t first);
  void share_mutations();
  double share_of(int replicate) const {
    return shares_[static_cast<std::size_t>(replicate) % shares_.size()];
  }

  const SelectivePreparation& prepared_;
  SampleAllocation& allocation_;
  std::vector<ChainPopulation>& populations_;
  const Epoch& epoch_;
  std::vector<Item> items_;
  std::vector<std::size_t> chain_counts_;  ///< per replicate
  std::vector<double> shares_;             ///< shares of the mutations, by division of the light
};

}  // namespace ajar
