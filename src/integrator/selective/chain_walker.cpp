#include "integrator/selective/chain_walker.h"

#include <optional>

#include "mcmc/path_space/make_path_mutations.h"

namespace ajar {

namespace {

class PrimaryWalker final : public ChainWalker {
 public:
  PrimaryWalker(const ChainPlan& plan, const PathGroup& group, int replicate,
                const PlaneMoves* plane)
      : target_(plan.make_target(group, replicate)),
        runner_(plan.chain_settings_of(replicate), *plan.moves.mutation, group.shape, *target_,
                plane),
        mis_large_steps_(plan.moves.mis_large_steps) {}
  void start(SelectiveChain& chain) override { runner_.start(numbers_of(chain)); }
  ChainStatistics go_on(SelectiveChain& chain, std::uint64_t steps, DepositSink& sink,
                        double b) override {
    return runner_.go_on(numbers_of(chain), steps, sink,
                         mis_large_steps_ ? std::optional(b) : std::nullopt);
  }
  const PathTarget* target() const override { return target_.get(); }
  RayCounts ray_counts() const override { return target_->ray_counts(); }

 private:
  static PrimaryChain& numbers_of(SelectiveChain& chain) {
    return std::get<PrimaryChain>(chain.state);
  }
  std::unique_ptr<PathTarget> target_;
  PrimaryRunner runner_;
  bool mis_large_steps_;
};

class PathWalker final : public ChainWalker {
 public:
  PathWalker(const ChainPlan& plan, const PathGroup& group, int replicate)
      : share_(path_share_of(plan, group, replicate)),
        bounds_(bounds_of(group, plan.view)),
        kernel_(make_path_kernel(plan.scene, bounds_, plan.path_mutations, splat_layer, &share_)),
        runner_(kernel_) {}
  void start(SelectiveChain& chain) override { kernel_.start(std::get<PathChain>(chain.state)); }
  ChainStatistics go_on(SelectiveChain& chain, std::uint64_t steps, DepositSink& sink,
                        double /*b*/) override {
    return runner_.go_on(chain.chain(), steps, sink);
  }
  const PathTarget* target() const override { return nullptr; }
  RayCounts ray_counts() const override { return kernel_.ray_counts(); }

 private:
  PathShare share_;
  PathBounds bounds_;
  PathKernel kernel_;
  ChainRunner runner_;
};

}  // namespace

std::unique_ptr<ChainWalker> make_chain_walker(const ChainPlan& plan, const PathGroup& group,
                                               int replicate, const PlaneMoves* plane) {
  if (is_explicit(group.kind)) {
    return std::make_unique<PathWalker>(plan, group, replicate);
  }
  return std::make_unique<PrimaryWalker>(plan, group, replicate, plane);
}

std::span<const Move> moves_of(const PathGroup& group) {
  return is_explicit(group.kind) ? path_moves() : primary_moves();
}

PathShare path_share_of(const ChainPlan& plan, const PathGroup& group, int replicate) {
  return {plan.scene, group.sampler, plan.view.importance, plan.part_of(replicate), group.paths};
}

}  // namespace ajar
