#include "integrator/selective/chain_starts.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/parallel_for.h"
#include "core/random_use.h"
#include "integrator/metropolis/path_seeds.h"
#include "integrator/metropolis/sample_of_chains.h"
#include "integrator/selective/chain_walker.h"
#include "mcmc/primary/chain_source.h"
#include "path/replay.h"

namespace ajar {

namespace {

PathChain chain_at(Path path, std::uint64_t seed, std::uint64_t origin) {
  PathChain chain;
  chain.seed = seed;
  chain.scalar = 1.0;
  chain.path = std::move(path);
  chain.origin = origin;
  return chain;
}

std::optional<PathChain> seed_path(const ChainPlan& plan, const ChainPopulation& population,
                                   const SampleOfChains& sample, std::uint64_t number) {
  std::optional<Path> path = choose_path(plan.scene, plan.groups[population.group], plan.view,
                                         sample, number, plan.part_of(population.replicate));
  if (!path) return std::nullopt;
  return chain_at(std::move(*path), sample.chain_seed(number), sample.index);
}

std::vector<SelectiveChain> seed_paths(const ChainPlan& plan, const ChainPopulation& population,
                                       std::size_t count) {
  const double u = to_unit_double(hash_numbers(population.seed, RandomUse::Seeds));
  const std::vector<std::size_t> indices = choose_seeds(population.weights, count, u);
  std::vector<std::optional<PathChain>> started(indices.size());
  parallel_for(indices.size(), [&](std::size_t i) {
    const SampleOfChains sample{population.seed, indices[i], population.weights[indices[i]]};
    started[i] = seed_path(plan, population, sample, i);
  });
  std::vector<SelectiveChain> chains;
  for (std::optional<PathChain>& chain : started) {
    if (chain) chains.push_back({std::move(*chain), {}, 1.0});
  }
  return chains;
}

/// Whether a chain of explicit paths can be there.
bool is_lit(const ChainPlan& plan, const PathGroup& group, int replicate, const Path& path) {
  PathShare share = path_share_of(plan, group, replicate);
  SplatBuffer splats;
  return std::isfinite(light_on(plan.scene, path, bounds_of(group, plan.view), 0, splats, &share));
}

std::optional<PathChain> path_chain_at(const ChainPlan& plan, const PathNumbers& numbers,
                                       const StrongPath& found, bool known, RayCounts& rays) {
  const PathGroup& of_depth = plan.group_of(found.technique.depth());
  const PrimaryChain chain = numbers.start_chain(plan, of_depth, found);
  ReplaySource source(chain.numbers);
  std::optional<Path> path =
      replay_halves(plan.scene, of_depth.sampler, source, found.raster, found.technique, rays);
  if (!path) return std::nullopt;
  if (!known && !is_lit(plan, plan.group_of(found), found.replicate, *path)) return std::nullopt;
  return chain_at(std::move(*path), chain.seed, chain.origin);
}

void check_path_chain(const ChainPlan& plan, const ChainPopulation& population,
                      const SelectiveChain& chain, double most_steps) {
  const PathGroup& group = plan.groups[population.group];
  check_record(chain.record, group, moves_of(group).size());
  const auto& own = std::get<PathChain>(chain.state);
  const int depth = own.path.depth();
  if (static_cast<double>(own.step) > most_steps || own.scalar != 1.0 || chain.weight == 0.0 ||
      !std::isfinite(chain.weight) || depth < group.sampler.min_depth ||
      depth > group.sampler.max_depth || !is_lit(plan, group, population.replicate, own.path)) {
    throw std::runtime_error("a chain is where it cannot be");
  }
}

}  // namespace

std::vector<SelectiveChain> seed_chains_of(const ChainPlan& plan, const ChainPopulation& population,
                                           std::size_t count) {
  if (is_explicit(plan.groups[population.group].kind)) return seed_paths(plan, population, count);
  std::vector<SelectiveChain> chains;
  for (MemberChain& member : seed_chains(plan.groups[population.group], population.seed,
                                         population.weights, count, plan.seed_rule)) {
    chains.push_back({std::move(member.chain), std::move(member.record), member.weight});
  }
  return chains;
}

std::optional<SelectiveChain> start_chain_of(const ChainPlan& plan, const PathNumbers& numbers,
                                             const StrongPath& found, std::optional<double> known,
                                             RayCounts& rays) {
  SelectiveChain start;
  start.weight = std::copysign(1.0, found.energy);
  const PathGroup& group = plan.group_of(found);
  if (is_explicit(group.kind)) {
    std::optional<PathChain> chain = path_chain_at(plan, numbers, found, known.has_value(), rays);
    if (!chain) return std::nullopt;
    start.state = std::move(*chain);
    return start;
  }
  PrimaryChain chain = numbers.start_chain(plan, group, found);
  if (known) {
    chain.scalar = *known;
  } else {
    const auto target = plan.make_target(group, found.replicate);
    ReplaySource replay(chain.numbers);
    SplatBuffer splats;
    chain.scalar = target->evaluate(replay, Change{}, splats);
    rays.add_rays(target->ray_counts());
  }
  start.record.by_technique.resize(group.choice.size());
  start.state = std::move(chain);
  return start;
}

SelectiveChain start_chain_at(const Path& path, std::uint64_t seed) {
  SelectiveChain start;
  start.weight = 1.0;
  start.state = chain_at(path, seed, seed);
  return start;
}

void check_chain(const ChainPlan& plan, const ChainPopulation& population,
                 const SelectiveChain& chain, double most_steps) {
  const PathGroup& group = plan.groups[population.group];
  if (is_explicit(group.kind)) {
    check_path_chain(plan, population, chain, most_steps);
    return;
  }
  const MemberChain member{std::get<PrimaryChain>(chain.state), chain.record, chain.weight};
  check_member(member, group, most_steps);
  check_state(member, *plan.make_target(group, population.replicate));
}

}  // namespace ajar
