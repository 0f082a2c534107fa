#pragma once
#include <mutex>
#include <optional>
#include <vector>

#include "core/archive_forward.h"
#include "integrator/selective/chain_population.h"
#include "integrator/selective/manifold_seed_batch.h"
#include "integrator/selective/path_numbers.h"
#include "integrator/selective/preparation.h"

namespace ajar {

/// Outlier paths of ordinary Monte Carlo, kept as seeds of chains. A camera sample of bidirectional
/// path tracing tries every technique of every depth, so it finds many times as many of them as a
/// bootstrap in the same time; light that a bootstrap misses, such as the islands of a caustic seen
/// through water, has chains all over it after a while. Paths that no connection makes are found by
/// manifold connections, too.
///
/// Found paths with weights (what they carry per sample) are a sample of the chains' target, as the
/// states of a population of chains are, with the weight b shared among them. Both are right on
/// average for any number of samples. So is their union, each weighed by a fraction fixed in
/// advance, and its systematic resampling (Kitagawa 1996). At the end of each epoch chains start
/// anew from a sample of all that was found so far, and b is its total: exact on average, not only
/// in the limit.
class SeedReservoir final : public OutlierSinkFactory {
 public:
  /// `prepared` must outlive it.
  explicit SeedReservoir(const SelectivePreparation& prepared)
      : prepared_(prepared), manifolds_(prepared) {}

  /// Sets the threshold of Russian roulette so that of the paths found in so many camera samples
  /// per pixel one per chain is kept, on average.
  void set_rate(const std::vector<ChainPopulation>& populations, double camera_samples);
  /// Sets it before anything is known of the chains' light, which may be all there is.
  void set_initial_rate(double camera_samples);
  /// Luminance · importance of all that was found since the last merge.
  double energy() const;
  /// Divides the finds anew after the division has changed from `before` to that of the
  /// preparation.
  void divide_anew(const Divisions& before);
  /// Between passes: tries manifold connections as far as camera sample `now` of an epoch from
  /// `first` to `last` per pixel.
  void advance(const std::vector<ChainPopulation>& populations, std::uint64_t first,
               std::uint64_t now, std::uint64_t last);
  /// Merges the finds of camera samples `first` to `last` per pixel into the populations.
  void merge(std::vector<ChainPopulation>& populations, std::uint64_t first, std::uint64_t last);
  /// Merges the finds of so many camera samples of no replicate, which are scattered over all.
  void merge_unassigned(std::vector<ChainPopulation>& populations, double camera_samples);

  std::unique_ptr<OutlierSink> make(Film& film, Counters& counters) const override;

  // Between passes.
  void save_state(OutputArchive& archive) const;
  void load_state(InputArchive& archive);
  /// Exchange between processes: writes what this one has found since it last did; takes what one
  /// of them, which may be this one, has written.
  void export_delta(OutputArchive& archive);
  void import_delta(InputArchive& archive);

 private:
  class Sink;
  struct SeedPath {
    OutlierPath path;
    PathNumbers numbers;
    std::optional<double> scalar;  ///< I of a chain at the path; unknown once divided anew
    template <typename Archive>
    void serialize(Archive& archive) {
      archive(path, numbers, scalar);
    }
  };

  /// Seeds of the chains of one population.
  struct Found {
    std::vector<const SeedPath*> paths;
    std::vector<ManifoldSeedPath> joined;
  };

  /// I of a chain that starts there; 0 if none can.
  double evaluate(const SeedPath& seed, RayCounts& rays) const;
  /// Takes what manifold connections find of a path away from its energy.
  void share_with_manifolds(SeedPath& seed, const SelectiveChain& chain, RayCounts& rays) const;
  void set_threshold(double per_sample, double camera_samples);
  /// Camera samples `first` to `last` per pixel, by replicate.
  std::vector<SampleRange> ranges(std::uint64_t first, std::uint64_t last) const;
  void merge_all(std::vector<ChainPopulation>& populations, const std::vector<SampleRange>& ranges);
  void merge_replicate(std::vector<ChainPopulation>& populations, const std::vector<Found>& found,
                       int replicate, const SampleRange& range) const;
  /// Finds of each population, in an order that does not depend on threads.
  std::vector<Found> sorted_finds(const std::vector<ChainPopulation>& populations);
  void add_mass(ChainPopulation& population, const Found& found, double samples) const;
  /// A chain at one of the finds, `paths` first; empty if it cannot be there.
  std::optional<SelectiveChain> start(const Found& found, std::size_t number,
                                      RayCounts& rays) const;
  void resample(ChainPopulation& population, const Found& found, std::size_t chains,
                std::uint64_t epoch) const;
  void keep(SeedPath seed) const;
  /// Appends the seeds of an archive.
  void load_seeds(InputArchive& archive, std::vector<SeedPath>& seeds) const;
  /// Raises std::runtime_error unless a chain can start there.
  void check_seed(const SeedPath& seed) const;

  const SelectivePreparation& prepared_;
  ManifoldSeedBatch manifolds_;
  double threshold_ = 0.0;  ///< luminance · importance below which Russian roulette decides
  mutable std::mutex mutex_;
  mutable std::vector<SeedPath> seeds_;  ///< in the order in which threads found them
  std::vector<SeedPath> shared_;         ///< seeds that processes have exchanged
};

}  // namespace ajar
