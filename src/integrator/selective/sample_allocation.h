#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/archive_forward.h"
#include "integrator/montecarlo/weighted_errors.h"
#include "integrator/selective/preparation.h"

namespace ajar {

/// Allocation of a render's effort between its halves: how many camera samples and how many
/// mutations its "samples per pixel" are.
class SampleAllocation {
 public:
  /// The plan must outlive it; to be asked after the preparation.
  explicit SampleAllocation(const SelectivePreparation& prepared) : prepared_(prepared) {}

  /// Camera samples of ordinary Monte Carlo per pixel that belong to the first `samples`; those of
  /// a pilot that stays come before.
  std::uint64_t omc_samples(std::uint64_t samples) const;
  /// Mutations per pixel that do.
  double mutations(std::uint64_t samples) const;
  /// Mutations of each of so many chains of a replicate in sample number `sample`; at least one.
  /// `share`: of the replicate, relative to the mean of all.
  std::uint64_t steps(std::uint64_t sample, std::size_t chains, double share) const;

  /// To be told what was spent; from any thread.
  void count_omc(std::uint64_t rays, std::uint64_t samples);
  void count_chains(std::uint64_t rays, std::uint64_t mutations);

  /// Mean so far; 0 if nothing is known.
  double rays_per_camera_sample() const {
    return omc_samples_ > 0 ? static_cast<double>(omc_rays_) / static_cast<double>(omc_samples_)
                            : 0.0;
  }
  /// Tests whether both halves have been at work.
  bool can_adjust() const {
    return !prepared_.preparation_cut && mutations_ > 0 && omc_samples_ > 0;
  }
  /// Shares the effort anew, by the errors that replicates show after `samples` samples of what
  /// either half makes: for the least that is seen (image/visible_error.h), or for the least
  /// squared error where the objective is the raw picture. What is on the film stays as it is: each
  /// sample stands for the whole picture, however many mutations it has, so nothing is biased. Only
  /// if `can_adjust`.
  void adjust(std::uint64_t samples, const WeightedErrors& of_omc, const WeightedErrors& of_chains);
  /// Measurements, as far as there are any.
  struct Known {
    double mutations_per_sample;
    std::optional<double> correlation;  ///< variance of chains over that of as many samples
    double chain_rays;                  ///< share of the rays
    std::optional<double> chain_error;  ///< share of the squared error, luminance · importance
  };
  Known known() const;

  /// Between passes.
  void save_state(OutputArchive& archive) const;
  /// Raises a std::exception if that cannot be after `samples` samples per pixel.
  void load_state(InputArchive& archive, std::uint64_t samples);
  /// Gives away what this process was told since it did so last; and takes what one of the
  /// processes has given, which may have been this one.
  void export_delta(OutputArchive& archive);
  void import_delta(InputArchive& archive);

 private:
  /// Mutations per pixel of a sample, now.
  double rate() const { return adjusted_ > 0.0 ? adjusted_ : prepared_.mutations; }
  std::array<std::uint64_t, 4> counts() const {
    return {omc_rays_, omc_samples_, chain_rays_, mutations_};
  }
  void set_counts(const std::array<std::uint64_t, 4>& counts);

  const SelectivePreparation& prepared_;
  double adjusted_ = 0.0;    ///< `rate` since it was; 0 until then
  std::uint64_t since_ = 0;  ///< samples
  double before_ = 0.0;      ///< mutations per pixel until then
  std::atomic<std::uint64_t> omc_rays_{0};
  std::atomic<std::uint64_t> omc_samples_{0};
  std::atomic<std::uint64_t> chain_rays_{0};
  std::atomic<std::uint64_t> mutations_{0};
  std::array<std::uint64_t, 4> known_{};  ///< counts that all processes have
  double correlation_ = 0.0;
  double chain_error_ = 0.0;  ///< share of the squared error
};

}  // namespace ajar
