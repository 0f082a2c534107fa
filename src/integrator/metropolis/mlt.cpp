#include "integrator/metropolis/mlt.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/error.h"
#include "integrator/metropolis/chain_integrator.h"
#include "integrator/metropolis/path_seeds.h"
#include "mcmc/chain_runner.h"
#include "mcmc/counter_random.h"
#include "mcmc/path_space/make_path_mutations.h"
#include "path/path_archive.h"

namespace ajar {

namespace {

/// A chain in path space, and what it has done.
struct PathMember {
  PathChain chain;
  ChainRecord record;

  std::uint64_t memory_bytes() const {
    return sizeof(PathMember) + chain.path.vertices.capacity() * sizeof(InnerVertex) +
           chain.path.segments.capacity() * sizeof(Segment);
  }
};

/// Chains of explicit paths.
class PathSpace {
 public:
  using Member = PathMember;

  explicit PathSpace(const Parameters& parameters) {
    for (const PathMutationInfo& mutation : path_mutations()) {
      weights_.push_back(parameters.get_float(std::string(mutation.name)));
    }
    if (*std::max_element(weights_.begin(), weights_.end()) == 0.0) {
      throw UsageError("bidirectional: chains need a mutation that is not switched off");
    }
  }

  static std::span<const Move> moves() { return path_moves(); }

  static std::vector<Member> seed(const Scene& scene, const PathGroup& group, const ChainView& view,
                                  std::uint64_t bootstrap_seed, std::span<const double> weights,
                                  std::size_t chains) {
    const double u = to_unit_double(hash_numbers(bootstrap_seed, RandomUse::Seeds));
    const std::vector<std::size_t> indices = choose_seeds(weights, chains, u);
    std::vector<std::optional<Path>> paths(indices.size());
    parallel_for(indices.size(), [&](std::size_t i) {
      const double which = to_unit_double(hash_numbers(bootstrap_seed, RandomUse::PathSeed, i));
      paths[i] = choose_path(scene, group, view, bootstrap_seed, indices[i], which);
    });
    std::vector<Member> members;
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (!paths[i]) continue;
      PathChain chain;
      chain.seed = hash_numbers(bootstrap_seed, RandomUse::Chain, i);
      chain.scalar = 1.0;
      chain.path = std::move(*paths[i]);
      chain.origin = indices[i];
      members.push_back({std::move(chain), {}});
    }
    return members;
  }

  class Walker {
   public:
    Walker(const PathSpace& space, const Scene& scene, const PathGroup& group,
           const ChainView& view)
        : bounds_{view, group.sampler.min_depth, group.sampler.max_depth},
          kernel_(make_path_kernel(scene, bounds_, space.weights_, splat_layer)),
          runner_(kernel_) {}
    Walker(const Walker&) = delete;
    Walker& operator=(const Walker&) = delete;

    void start(Member& member) { kernel_.start(member.chain); }
    ChainStatistics go_on(Member& member, std::uint64_t steps, DepositSink& sink, double /*b*/) {
      return runner_.go_on(member.chain, steps, sink);
    }
    static const PathTarget* target() { return nullptr; }
    RayCounts ray_counts() const { return kernel_.ray_counts(); }

   private:
    PathBounds bounds_;
    PathKernel kernel_;
    ChainRunner runner_;
  };

  static void save(OutputArchive& archive, const Scene& scene, const Member& member) {
    archive(static_cast<const Chain&>(member.chain), member.chain.origin, member.record);
    save_path(archive, scene, member.chain.path);
  }
  static void load(InputArchive& archive, const Scene& scene, Member& member) {
    archive(static_cast<Chain&>(member.chain), member.chain.origin, member.record);
    member.chain.path = load_path(archive, scene);
  }
  static void check(const Member& member, const PathGroup& group, double most_steps) {
    check_record(member.record, group, path_moves().size());
    const PathChain& chain = member.chain;
    const int depth = chain.path.depth();
    if (static_cast<double>(chain.step) > most_steps || chain.scalar != 1.0 ||
        depth < group.sampler.min_depth || depth > group.sampler.max_depth) {
      throw std::runtime_error("a chain is where it cannot be");
    }
  }
  static void check_state(const Scene& scene, const PathGroup& /*group*/, const ChainView& view,
                          const Member& member) {
    SplatBuffer splats;
    if (!std::isfinite(light_on(scene, member.chain.path, view, 0, splats))) {
      throw std::runtime_error("a chain is in the dark");
    }
  }

 private:
  std::vector<double> weights_;  ///< of the mutations
};

}  // namespace

std::vector<ParameterSpec> mlt_parameters() {
  std::vector<ParameterSpec> specs;
  for (const PathMutationInfo& mutation : path_mutations()) {
    specs.push_back({.name = std::string(mutation.name),
                     .type = ParameterType::Float,
                     .default_value = std::string(mutation.weight),
                     .unit = "",
                     .help = "how often, beside other mutations that are for the path, one " +
                             std::string(mutation.help),
                     .choices = {},
                     .minimum = 0.0,
                     .maximum = 1000.0});
    specs.back().expert = true;
  }
  add_chain_counts(specs);
  specs.push_back(roulette_start_parameter("3"));
  specs.back().expert = true;
  return specs;
}

std::unique_ptr<Integrator> make_mlt_integrator(const Scene& scene, const RenderSettings& settings,
                                                const Parameters& parameters) {
  ChainOrder order = chain_order(settings, parameters, {{"techniques", "bdpt"}});
  order.groups =
      make_path_groups(ChainKind::WholePath, order.sampler, parameters.get_int("roulette-start"));
  return std::make_unique<ChainIntegrator<PathSpace>>(scene, settings, std::move(order),
                                                      PathSpace(parameters));
}

}  // namespace ajar
