#pragma once
#include <mutex>
#include <optional>
#include <vector>

#include "core/archive_forward.h"
#include "integrator/selective/chain_plan.h"
#include "integrator/selective/chain_population.h"
#include "integrator/selective/manifold_recruits.h"
#include "integrator/selective/path_numbers.h"

namespace ajar {

/// Strong paths that ordinary Monte Carlo finds while it renders, kept as seeds for chains. A
/// camera sample of bidirectional path tracing tries every technique of every depth, so it finds
/// many times as many of them as the bootstrap and the large steps of chains in the same time;
/// light that a bootstrap misses, such as the islands of a caustic seen through water, has chains
/// all over it after a while. What no connection makes is found by manifold connections, too.
///
/// Found paths with weights (what they carry per sample) are a sample of the chains' target, as the
/// states of a population of chains are, with the weight b shared among them; both are right on
/// average for any number of samples behind them. So is their union, each weighed by a share fixed
/// in advance, and what is systematically resampled from it (Kitagawa 1996). So each time they
/// `join`, chains start anew from a sample that stands for all that was found so far, and b is its
/// total: exact on average, not only in the limit.
class ChainRecruits final : public StrongPathSinks {
 public:
  explicit ChainRecruits(const ChainPlan& plan) : plan_(plan), manifolds_(plan) {}

  /// Prepares for a stretch of the render: of the paths found in so many camera samples per pixel,
  /// it keeps one per chain, on average.
  void expect(const std::vector<ChainPopulation>& populations, double camera_samples);
  /// The same before anything is known of the chains' light, which may be all there is.
  void expect_unknown(double camera_samples);
  /// Luminance · importance of all that was found since chains were last joined.
  double energy() const;
  /// After the division has changed, from `before` to that of the plan.
  void divide_anew(const Divisions& before);
  /// Between passes: tries manifold connections as far as camera sample `now` of a stretch from
  /// `first` to `last` per pixel.
  void look_on(const std::vector<ChainPopulation>& populations, std::uint64_t first,
               std::uint64_t now, std::uint64_t last);
  /// Merges what was found in camera samples `first` to `last` per pixel into the populations.
  void join(std::vector<ChainPopulation>& populations, std::uint64_t first, std::uint64_t last);
  /// The same for so many camera samples of no replicate, which are scattered over all.
  void join_scattered(std::vector<ChainPopulation>& populations, double camera_samples);

  std::unique_ptr<StrongPathSink> make(Film& film, Counters& counters) const override;

  /// Between passes: all that was found since chains were last joined, and what else is kept.
  void save_state(OutputArchive& archive) const;
  void load_state(InputArchive& archive);
  /// Gives away what this process has found since it did so last; and takes what one of the
  /// processes has given, which may have been this one.
  void give_news(OutputArchive& archive);
  void take_news(InputArchive& archive);

 private:
  class Sink;
  struct Recruit {
    StrongPath path;
    PathNumbers numbers;
    std::optional<double> scalar;  ///< I of the path as a chain's state; unknown once divided anew
    template <typename Archive>
    void serialize(Archive& archive) {
      archive(path, numbers, scalar);
    }
  };

  /// What chains of a population may start from.
  struct Found {
    std::vector<const Recruit*> recruits;
    std::vector<ManifoldRecruit> joined;
  };

  /// I of a chain that starts there; 0 if none can.
  double evaluate(const Recruit& recruit, RayCounts& rays) const;
  /// A recruit's energy without what manifold connections find of its path.
  void share_with_manifolds(Recruit& recruit, const SelectiveChain& chain, RayCounts& rays) const;
  void set_grain(double per_sample, double camera_samples);
  /// By replicate, for camera samples `first` to `last` per pixel.
  std::vector<RecruitStretch> stretches(std::uint64_t first, std::uint64_t last) const;
  void join_all(std::vector<ChainPopulation>& populations,
                const std::vector<RecruitStretch>& stretches);
  void join_replicate(std::vector<ChainPopulation>& populations, const std::vector<Found>& found,
                      int replicate, const RecruitStretch& stretch) const;
  /// Of each population, in an order that does not depend on threads.
  std::vector<Found> sorted_recruits(const std::vector<ChainPopulation>& populations);
  static void end_chains(ChainPopulation& population);
  void merge(ChainPopulation& population, const Found& found, double samples) const;
  /// A chain at one of what was found, recruits first; empty if it cannot be there.
  std::optional<SelectiveChain> start(const Found& found, std::size_t number,
                                      RayCounts& rays) const;
  void resample(ChainPopulation& population, const Found& found, std::size_t chains,
                std::uint64_t stretch) const;
  void keep(Recruit recruit) const;
  /// Appends the recruits of an archive to `recruits`.
  void load_recruits(InputArchive& archive, std::vector<Recruit>& recruits) const;
  /// Raises std::runtime_error unless a chain can start there.
  void check_recruit(const Recruit& recruit) const;

  const ChainPlan& plan_;
  ManifoldRecruits manifolds_;
  double grain_ = 0.0;  ///< luminance · importance; paths that carry less are kept now and then
  mutable std::mutex mutex_;
  mutable std::vector<Recruit> recruits_;  ///< in the order in which threads found them
  std::vector<Recruit> shared_;            ///< those that were news of some process
};

}  // namespace ajar
