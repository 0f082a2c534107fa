#pragma once
#include <atomic>
#include <deque>
#include <memory>
#include <vector>

#include "integrator/preparation_stage.h"
#include "integrator/selective/chain_plan.h"
#include "integrator/selective/chain_population.h"
#include "integrator/selective/chain_recruits.h"
#include "integrator/selective/division_pilot.h"

namespace ajar {

/// Finds out what mutations are worth in a scene, before it is decided how the light is divided:
/// seeds chains with what the pilot has found, lets them run for a while, and looks how much more
/// the picture varies than if each mutation were independent of all others (C of
/// optimal_thresholds.h). Chains that go through glass to a small lamp land in clusters, those that
/// light a room through a wide door do not, and so much less light is worth leaving to the former.
/// What they render is thrown away.
class ChainTrial final : public PreparationStage {
 public:
  /// `recruits` may be null. Without them, or if there are no thresholds to decide between, or if
  /// chains would not pay anyway, costs are taken to be typical. All must outlive it.
  ChainTrial(const ChainPlan& plan, DivisionPilot& pilot, ChainRecruits* recruits)
      : plan_(plan), pilot_(pilot), recruits_(recruits) {}
  double effort() const override;
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;
  /// Instead of what is left of it: costs are taken to be typical.
  void give_up() { halves_.clear(); }

 private:
  /// A chain of a population, which lands in one of several pictures of its half.
  struct Item {
    std::size_t population;
    std::size_t chain;
    std::size_t half;
    std::size_t picture;
  };
  struct Half {
    std::uint64_t chains = 0;
    std::atomic<std::uint64_t> rays{0};
    std::atomic<std::uint64_t> mutations{0};
  };
  /// Chains of these halves.
  void list_items(const std::vector<std::size_t>& halves);
  ChainCosts costs_of(std::size_t h) const;

  const ChainPlan& plan_;
  DivisionPilot& pilot_;
  ChainRecruits* recruits_;
  std::vector<ChainPopulation> populations_;
  std::vector<Item> items_;
  std::deque<Half> halves_;
  std::unique_ptr<Film> film_;  ///< its replicates are the pictures
  std::vector<double> light_;   ///< of each picture: the part of b that its chains make
};

}  // namespace ajar
