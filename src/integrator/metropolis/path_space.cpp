#include "integrator/metropolis/path_space.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/archive.h"
#include "core/error.h"
#include "core/parallel_for.h"
#include "core/random_use.h"
#include "integrator/metropolis/path_seeds.h"
#include "mcmc/counter_random.h"
#include "path/path_archive.h"

namespace ajar {

std::vector<ParameterSpec> path_mutation_parameters(std::string_view without) {
  std::vector<ParameterSpec> specs;
  for (const PathMutationInfo& mutation : path_mutations()) {
    specs.push_back(
        {.name = std::string(mutation.name),
         .type = ParameterType::Float,
         .default_value = mutation.name == without ? "0" : std::string(mutation.weight),
         .unit = "",
         .help = "relative probability of the mutation that " + std::string(mutation.help),
         .choices = {},
         .minimum = 0.0,
         .maximum = 1000.0});
  }
  return specs;
}

std::vector<double> path_mutation_weights(const Parameters& parameters) {
  std::vector<double> weights;
  for (const PathMutationInfo& mutation : path_mutations()) {
    weights.push_back(parameters.get_float(std::string(mutation.name)));
  }
  if (*std::max_element(weights.begin(), weights.end()) == 0.0) {
    std::string names;
    for (const PathMutationInfo& mutation : path_mutations()) {
      names += (names.empty() ? "" : ", ") + std::string(mutation.name);
    }
    throw UsageError("all of " + names + " are 0: chains need a mutation that is not");
  }
  return weights;
}

std::optional<DividedPathWeight> PathSpace::share_of(const ChainProblem& problem) {
  if (problem.part == nullptr) return std::nullopt;
  return std::optional<DividedPathWeight>(std::in_place, problem.scene, problem.group.sampler,
                                          problem.view.importance, problem.part,
                                          problem.group.paths);
}

std::optional<PathMember> PathSpace::start(const ChainProblem& problem,
                                           const SampleOfChains& sample, std::uint64_t number) {
  std::optional<Path> path =
      choose_path(problem.scene, problem.group, problem.view, sample, number, problem.part);
  if (!path) return std::nullopt;
  PathMember member;
  member.chain.seed = sample.chain_seed(number);
  member.chain.scalar = 1.0;
  member.chain.path = std::move(*path);
  member.chain.origin = sample.index;
  return member;
}

std::vector<PathMember> PathSpace::seed(const ChainProblem& problem, std::uint64_t bootstrap_seed,
                                        std::span<const double> weights, std::size_t chains) {
  const double u = to_unit_double(hash_numbers(bootstrap_seed, RandomUse::Seeds));
  const std::vector<std::size_t> indices = choose_seeds(weights, chains, u);
  std::vector<std::optional<PathMember>> started(indices.size());
  parallel_for(indices.size(), [&](std::size_t i) {
    started[i] = start(problem, {bootstrap_seed, indices[i], weights[indices[i]]}, i);
  });
  std::vector<PathMember> members;
  for (std::optional<PathMember>& member : started) {
    if (member) members.push_back(std::move(*member));
  }
  return members;
}

void PathSpace::save(OutputArchive& archive, const Scene& scene, const PathMember& member) {
  archive(static_cast<const Chain&>(member.chain), member.chain.origin, member.record);
  save_path(archive, scene, member.chain.path);
}

void PathSpace::load(InputArchive& archive, const Scene& scene, PathMember& member) {
  archive(static_cast<Chain&>(member.chain), member.chain.origin, member.record);
  member.chain.path = load_path(archive, scene);
}

void PathSpace::check(const PathMember& member, const PathGroup& group, double most_steps) {
  check_record(member.record, group, path_moves().size());
  const PathChain& chain = member.chain;
  const int depth = chain.path.depth();
  if (static_cast<double>(chain.step) > most_steps || chain.scalar != 1.0 ||
      depth < group.sampler.min_depth || depth > group.sampler.max_depth) {
    throw std::runtime_error("a chain is where it cannot be");
  }
}

void PathSpace::check_state(const ChainProblem& problem, const PathMember& member) {
  SplatBuffer splats;
  std::optional<DividedPathWeight> share = share_of(problem);
  if (!std::isfinite(light_on(problem.scene, member.chain.path,
                              bounds_of(problem.group, problem.view), 0, splats,
                              share ? &*share : nullptr))) {
    throw std::runtime_error("corrupt checkpoint: a chain's path carries no light");
  }
}

}  // namespace ajar
