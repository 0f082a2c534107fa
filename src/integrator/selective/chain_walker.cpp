#include "integrator/selective/chain_walker.h"

#include "mcmc/path_space/make_path_mutations.h"

namespace ajar {

namespace {

class PrimaryWalker final : public ChainWalker {
 public:
  PrimaryWalker(const SelectivePreparation& prepared, const PathGroup& group, int replicate)
      : target_(make_path_target(prepared.problem(group, replicate))),
        runner_(prepared.moves_of(replicate), *prepared.config.mutation, group.shape, *target_) {}
  void start(SelectiveChain& chain) override { runner_.start(numbers_of(chain)); }
  ChainStatistics go_on(SelectiveChain& chain, std::uint64_t steps, DepositSink& sink) override {
    return runner_.go_on(numbers_of(chain), steps, sink);
  }
  const PathTarget* target() const override { return target_.get(); }
  RayCounts ray_counts() const override { return target_->ray_counts(); }

 private:
  static PrimaryChain& numbers_of(SelectiveChain& chain) {
    return std::get<PrimaryChain>(chain.state);
  }
  std::unique_ptr<PathTarget> target_;
  PrimaryRunner runner_;
};

class PathWalker final : public ChainWalker {
 public:
  PathWalker(const SelectivePreparation& prepared, const PathGroup& group, int replicate)
      : share_(path_weight_of(prepared, group, replicate)),
        bounds_(bounds_of(group, prepared.view)),
        kernel_(make_path_kernel(prepared.scene(), bounds_, prepared.config.path_mutations,
                                 splat_layer, &share_)),
        runner_(kernel_) {}
  void start(SelectiveChain& chain) override { kernel_.start(std::get<PathChain>(chain.state)); }
  ChainStatistics go_on(SelectiveChain& chain, std::uint64_t steps, DepositSink& sink) override {
    return runner_.go_on(chain.chain(), steps, sink);
  }
  const PathTarget* target() const override { return nullptr; }
  RayCounts ray_counts() const override { return kernel_.ray_counts(); }

 private:
  DividedPathWeight share_;
  PathBounds bounds_;
  PathKernel kernel_;
  ChainRunner runner_;
};

}  // namespace

std::unique_ptr<ChainWalker> make_chain_walker(const SelectivePreparation& prepared,
                                               const PathGroup& group, int replicate) {
  if (is_explicit(group.kind)) return std::make_unique<PathWalker>(prepared, group, replicate);
  return std::make_unique<PrimaryWalker>(prepared, group, replicate);
}

std::span<const Move> moves_of(const PathGroup& group) {
  return is_explicit(group.kind) ? path_moves() : primary_moves();
}

DividedPathWeight path_weight_of(const SelectivePreparation& prepared, const PathGroup& group,
                                 int replicate) {
  return {prepared.scene(), group.sampler, prepared.view.importance, prepared.part_of(replicate),
          group.paths};
}

}  // namespace ajar
