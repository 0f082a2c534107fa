#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/archive_forward.h"
#include "core/parameters.h"
#include "integrator/metropolis/divided_path_weight.h"
#include "integrator/metropolis/member_chain.h"
#include "integrator/metropolis/sample_of_chains.h"
#include "integrator/metropolis/visit_maps.h"
#include "mcmc/chain_runner.h"
#include "mcmc/path_space/make_path_mutations.h"

namespace ajar {

/// A chain in path space, and what it has done.
struct PathMember {
  PathChain chain;
  ChainRecord record;
  double weight = 1.0;

  std::uint64_t memory_bytes() const {
    return sizeof(PathMember) + chain.path.vertices.capacity() * sizeof(InnerVertex) +
           chain.path.segments.capacity() * sizeof(Segment);
  }
};

/// A weight for each mutation of paths, by name. `without`: those that are switched off by default.
std::vector<ParameterSpec> path_mutation_parameters(std::string_view without = "");
/// Their values, by number. Raises UsageError if all are switched off.
std::vector<double> path_mutation_weights(const Parameters& parameters);

/// Chains of explicit paths.
class PathSpace {
 public:
  using Member = PathMember;

  /// Weights by `path_mutation_parameters`. Raises UsageError.
  explicit PathSpace(const Parameters& parameters) : weights_(path_mutation_weights(parameters)) {}

  static std::span<const Move> moves() { return path_moves(); }

  static std::vector<Member> seed(const ChainProblem& problem, std::uint64_t bootstrap_seed,
                                  std::span<const double> weights, std::size_t chains);
  static void begin(const ChainView& /*view*/, int /*replicates*/, double /*magnitude*/) {}
  static VisitMaps* maps() { return nullptr; }

  /// Chain `number` of those that start from a sample; empty if it has no path for one.
  static std::optional<Member> start(const ChainProblem& problem, const SampleOfChains& sample,
                                     std::uint64_t number);

  class Walker {
   public:
    Walker(const PathSpace& space, const ChainProblem& problem, int /*replicate*/)
        : bounds_(bounds_of(problem.group, problem.view)),
          share_(share_of(problem)),
          kernel_(make_path_kernel(problem.scene, bounds_, space.weights_, splat_layer,
                                   share_ ? &*share_ : nullptr)),
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
    std::optional<DividedPathWeight> share_;
    PathKernel kernel_;
    ChainRunner runner_;
  };

  static void save(OutputArchive& archive, const Scene& scene, const Member& member);
  static void load(InputArchive& archive, const Scene& scene, Member& member);
  static void check(const Member& member, const PathGroup& group, double most_steps);
  static void check_state(const ChainProblem& problem, const Member& member);

 private:
  /// The weight of paths if chains do not make all light.
  static std::optional<DividedPathWeight> share_of(const ChainProblem& problem);

  std::vector<double> weights_;  ///< weights of the mutations
};

}  // namespace ajar
