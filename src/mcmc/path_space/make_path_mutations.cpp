#include "mcmc/path_space/make_path_mutations.h"

#include <utility>

#include "mcmc/path_space/bidirectional_mutation.h"
#include "mcmc/path_space/caustic_perturbation.h"
#include "mcmc/path_space/half_vector_perturbation.h"
#include "mcmc/path_space/lens_perturbation.h"
#include "mcmc/path_space/lens_subpath_mutation.h"
#include "mcmc/path_space/manifold_perturbation.h"
#include "mcmc/path_space/multi_chain_perturbation.h"

namespace ajar {

namespace {

template <typename Perturbation>
std::unique_ptr<PathMutation> make(const Scene& scene, const PathBounds& bounds) {
  return std::make_unique<Perturbation>(scene, bounds.area);
}

template <>
std::unique_ptr<PathMutation> make<BidirectionalMutation>(const Scene& scene,
                                                          const PathBounds& bounds) {
  return std::make_unique<BidirectionalMutation>(
      scene, bounds.area, BidirectionalMutation::Depths{bounds.min_depth, bounds.max_depth});
}

template <>
std::unique_ptr<PathMutation> make<LensSubpathMutation>(const Scene& scene,
                                                        const PathBounds& bounds) {
  return std::make_unique<LensSubpathMutation>(scene, bounds.area, bounds.min_depth,
                                               bounds.max_depth);
}

constexpr std::array kMutations = {
    PathMutationInfo{"bidirectional",
                     "takes vertices out of a path, or all of it, and grows others from both ends",
                     "1", &make<BidirectionalMutation>},
    PathMutationInfo{
        "lens-subpath",
        "makes the end at the camera afresh, with the first vertex that is not specular", "1",
        &make<LensSubpathMutation>},
    PathMutationInfo{
        "lens",
        "moves the place on the film a little and follows specular events to the first "
        "other vertex",
        "1", &make<LensPerturbation>},
    PathMutationInfo{
        "caustic",
        "turns the direction of light before a specular chain a little and joins where "
        "it falls to the lens",
        "1", &make<CausticPerturbation>},
    PathMutationInfo{"multi-chain",
                     "moves the place on the film and the directions between specular chains a "
                     "little",
                     "1", &make<MultiChainPerturbation>},
    PathMutationInfo{
        "manifold",
        "moves the place on the film a little and lets the specular chain between what "
        "is seen and the light follow",
        "1", &make<ManifoldPerturbation>},
    PathMutationInfo{
        "half-vector",
        "moves the place on the film and the half vectors of glossy vertices a little, and lets "
        "the chain follow",
        "0.25", &make<HalfVectorPerturbation>},
};

}  // namespace

std::span<const PathMutationInfo> path_mutations() { return kMutations; }

std::span<const Move> path_moves() {
  static const auto kMoves = [] {
    std::array<Move, kMutations.size()> moves;
    for (std::size_t i = 0; i < moves.size(); ++i) moves[i] = {kMutations[i].name, false};
    return moves;
  }();
  return kMoves;
}

PathKernel make_path_kernel(const Scene& scene, const PathBounds& bounds,
                            std::span<const double> weights, std::int32_t (*layer)(int depth),
                            PathWeight* weight) {
  std::vector<MixedMutation> mutations;
  for (std::size_t i = 0; i < kMutations.size(); ++i) {
    mutations.push_back({kMutations[i].make(scene, bounds), weights[i]});
  }
  return {scene, bounds, std::move(mutations), layer, weight};
}

}  // namespace ajar
