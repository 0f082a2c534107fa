#include "integrator/metropolis/path_group.h"

#include <algorithm>

#include "core/error.h"
#include "integrator/make_filter.h"
#include "integrator/metropolis/heuristics.h"
#include "integrator/metropolis/path_seeds.h"

namespace ajar {

namespace {

PathGroup group_of_all_depths(const Scene& scene, ChainSpace kind, PathClass paths,
                              PathSamplerSettings sampler, int roulette_start) {
  sampler.roulette_start = roulette_start;
  return {kind,
          paths,
          0,
          sampler,
          TechniqueChoice(sampler.techniques, 0),
          {sampler.max_depth + 1, sampler.max_depth + 1},
          is_explicit(kind) ? std::make_shared<SpecularPhotons>(scene) : nullptr};
}

std::vector<PathGroup> groups_by_depth(PathClass paths, PathSamplerSettings sampler) {
  std::vector<PathGroup> groups;
  sampler.roulette_start = MetropolisHeuristics::kMostEdges + 1;
  for (int depth = sampler.min_depth; depth <= sampler.max_depth; ++depth) {
    const TechniqueChoice choice(sampler.techniques, depth);
    if (choice.empty()) continue;
    PathSamplerSettings own = sampler;
    own.min_depth = depth;
    own.max_depth = depth;
    groups.push_back(
        {ChainSpace::Mmlt, paths, depth, own, choice, {depth + 1, depth + 1}, nullptr});
  }
  return groups;
}

}  // namespace

std::vector<PathGroup> make_path_groups(const Scene& scene, ChainSpace kind,
                                        const PathSamplerSettings& sampler, int roulette_start) {
  if (sampler.min_depth > sampler.max_depth) return {};
  if (kind == ChainSpace::Mmlt) return groups_by_depth(PathClass::All, sampler);
  if (kind != ChainSpace::Auto) {
    return {group_of_all_depths(scene, kind, PathClass::All, sampler, roulette_start)};
  }
  if (!sampler.techniques.any(TechniqueClass::Implicit)) {
    return groups_by_depth(PathClass::All, sampler);
  }
  std::vector<PathGroup> groups = groups_by_depth(PathClass::Connectible, sampler);
  groups.push_back(group_of_all_depths(scene, ChainSpace::Paths, PathClass::UnidirectionalOnly,
                                       sampler, roulette_start));
  return groups;
}

double bootstrap_share(std::span<const PathGroup> groups, std::size_t group) {
  const auto weight = [](const PathGroup& g) { return 1.0 / std::max(1, g.depth); };
  double whole = 0.0;
  for (const PathGroup& other : groups) whole += weight(other);
  return weight(groups[group]) / whole;
}

ChainView view_of(const Scene& scene, const RenderSettings& settings) {
  const Vec2i size = settings.crop.size() + Vec2i(1, 1);
  const Vec2 beyond = make_filter(scene.film().filter).radius() - Vec2(0.5F, 0.5F);
  ChainView view;
  view.low = Vec2(settings.crop.min) - beyond;
  view.size = Vec2(size) + beyond * 2.F;
  view.pixels = static_cast<double>(size.x) * static_cast<double>(size.y);
  return view;
}

std::unique_ptr<PathTarget> make_path_target(const Scene& scene, const PathGroup& group,
                                             const ChainView& view, const ChainWeight* part) {
  if (group.depth == 0) {
    return std::make_unique<WholePathTarget>(scene, group.sampler, view, part, group.paths);
  }
  return std::make_unique<OnePathTarget>(scene, group.sampler, group.choice, view, part,
                                         group.paths);
}

std::unique_ptr<PathTarget> make_seed_target(const Scene& scene, const PathGroup& group,
                                             const ChainView& view, const ChainWeight* part) {
  if (!is_explicit(group.kind)) return make_path_target(scene, group, view, part);
  return std::make_unique<PathSeeds>(scene, group, view, part);
}

TechniqueSet techniques_of_chains(const Parameters& parameters) {
  TechniqueSet techniques = TechniqueSet::parse(parameters.get_text("techniques"));
  if (techniques.tries_once()) return techniques;
  throw UsageError("techniques: Markov chains try each technique once, so leave out counts: " +
                   parameters.get_text("techniques"));
}

}  // namespace ajar
