#include "integrator/selective/chain_starts.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/random_use.h"
#include "integrator/selective/chain_walker.h"
#include "mcmc/path_space/path_kernel.h"
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

/// Tests whether a chain of explicit paths can be there.
bool is_lit(const SelectivePreparation& prepared, const PathGroup& group, int replicate,
            const Path& path) {
  DividedPathWeight share = path_weight_of(prepared, group, replicate);
  SplatBuffer splats;
  return std::isfinite(
      light_on(prepared.scene(), path, bounds_of(group, prepared.view), 0, splats, &share));
}

std::optional<PathChain> path_chain_at(const SelectivePreparation& prepared,
                                       const PathNumbers& numbers, const OutlierPath& found,
                                       bool known, RayCounts& rays) {
  const PathGroup& of_depth = prepared.group_of(found.technique.depth());
  const PrimaryChain chain = numbers.start_chain(prepared, of_depth, found);
  ReplaySource source(chain.numbers);
  std::optional<Path> path = replay_halves(prepared.scene(), of_depth.sampler, source, found.raster,
                                           found.technique, rays);
  if (!path) return std::nullopt;
  if (!known && !is_lit(prepared, prepared.group_of(found), found.replicate, *path))
    return std::nullopt;
  return chain_at(std::move(*path), chain.seed, chain.origin);
}

void check_path_chain(const SelectivePreparation& prepared, const ChainPopulation& population,
                      const SelectiveChain& chain, double most_steps) {
  const PathGroup& group = prepared.groups()[population.group];
  check_record(chain.record, group, moves_of(group).size());
  const auto& own = std::get<PathChain>(chain.state);
  const int depth = own.path.depth();
  if (static_cast<double>(own.step) > most_steps || own.scalar != 1.0 || chain.weight == 0.0 ||
      !std::isfinite(chain.weight) || depth < group.sampler.min_depth ||
      depth > group.sampler.max_depth || !is_lit(prepared, group, population.replicate, own.path)) {
    throw std::runtime_error("corrupt checkpoint: invalid state of a chain");
  }
}

}  // namespace

std::optional<SelectiveChain> start_chain_of(const SelectivePreparation& prepared,
                                             const PathNumbers& numbers, const OutlierPath& found,
                                             std::optional<double> known, RayCounts& rays) {
  SelectiveChain start;
  start.weight = std::copysign(1.0, found.energy);
  const PathGroup& group = prepared.group_of(found);
  if (is_explicit(group.kind)) {
    std::optional<PathChain> chain =
        path_chain_at(prepared, numbers, found, known.has_value(), rays);
    if (!chain) return std::nullopt;
    start.state = std::move(*chain);
    return start;
  }
  PrimaryChain chain = numbers.start_chain(prepared, group, found);
  if (known) {
    chain.scalar = *known;
  } else {
    const auto target = make_path_target(prepared.problem(group, found.replicate));
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

void check_chain(const SelectivePreparation& prepared, const ChainPopulation& population,
                 const SelectiveChain& chain, double most_steps) {
  const PathGroup& group = prepared.groups()[population.group];
  if (is_explicit(group.kind)) {
    check_path_chain(prepared, population, chain, most_steps);
    return;
  }
  const MemberChain member{std::get<PrimaryChain>(chain.state), chain.record, chain.weight};
  check_member(member, group, most_steps);
  check_state(member, *make_path_target(prepared.problem(group, population.replicate)));
}

}  // namespace ajar
