#include "integrator/metropolis/metropolis.h"

#include <memory>
#include <utility>

#include "integrator/metropolis/chain_integrator.h"
#include "integrator/metropolis/chain_moves.h"
#include "mcmc/primary/primary_runner.h"

namespace ajar {

namespace {

/// Chains of primary numbers.
class PrimarySpace {
 public:
  using Member = MemberChain;

  explicit PrimarySpace(const Parameters& parameters) : moves_(parameters) {}

  static std::span<const Move> moves() { return primary_moves(); }

  static std::vector<Member> seed(const Scene& /*scene*/, const PathGroup& group,
                                  const ChainView& /*view*/, std::uint64_t bootstrap_seed,
                                  std::span<const double> weights, std::size_t chains) {
    return seed_chains(group, bootstrap_seed, weights, chains);
  }

  class Walker {
   public:
    Walker(const PrimarySpace& space, const Scene& scene, const PathGroup& group,
           const ChainView& view)
        : target_(make_path_target(scene, group, view)),
          runner_(space.moves_.settings, *space.moves_.mutation, group.shape, *target_),
          mis_large_steps_(space.moves_.mis_large_steps) {}
    void start(Member& member) { runner_.start(member.chain); }
    ChainStatistics go_on(Member& member, std::uint64_t steps, DepositSink& sink, double b) {
      return runner_.go_on(member.chain, steps, sink,
                           mis_large_steps_ ? std::optional(b) : std::nullopt);
    }
    const PathTarget* target() const { return target_.get(); }
    RayCounts ray_counts() const { return target_->ray_counts(); }

   private:
    std::unique_ptr<PathTarget> target_;
    PrimaryRunner runner_;
    bool mis_large_steps_;
  };

  static void save(OutputArchive& archive, const Scene& /*scene*/, const Member& member) {
    archive(member);
  }
  static void load(InputArchive& archive, const Scene& /*scene*/, Member& member) {
    archive(member);
  }
  static void check(const Member& member, const PathGroup& group, double most_steps) {
    check_member(member, group, most_steps);
  }
  static void check_state(const Scene& scene, const PathGroup& group, const ChainView& view,
                          const Member& member) {
    ajar::check_state(member, *make_path_target(scene, group, view));
  }

 private:
  ChainMoves moves_;
};

}  // namespace

std::vector<ParameterSpec> metropolis_parameters(ChainKind kind) {
  std::vector<ParameterSpec> specs = {techniques_parameter("bdpt"), heuristic_parameter()};
  specs.back().expert = true;
  for (ParameterSpec& spec : ChainMoves::parameters({})) specs.push_back(std::move(spec));
  add_chain_counts(specs);
  if (kind == ChainKind::WholePath) {
    specs.push_back(roulette_start_parameter("3"));
    specs.back().expert = true;
  }
  return specs;
}

std::unique_ptr<Integrator> make_metropolis_integrator(ChainKind kind, const Scene& scene,
                                                       const RenderSettings& settings,
                                                       const Parameters& parameters) {
  ChainOrder order = chain_order(settings, parameters,
                                 {{"techniques", parameters.get_text("techniques")},
                                  {"heuristic", parameters.get_text("heuristic")}});
  order.groups = make_path_groups(
      kind, order.sampler, kind == ChainKind::WholePath ? parameters.get_int("roulette-start") : 0);
  return std::make_unique<ChainIntegrator<PrimarySpace>>(scene, settings, std::move(order),
                                                         PrimarySpace(parameters));
}

}  // namespace ajar
