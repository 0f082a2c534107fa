#pragma once
#include <optional>
#include <vector>

#include "core/archive_forward.h"
#include "integrator/montecarlo/ray_price.h"
#include "integrator/montecarlo/sample_rates.h"
#include "integrator/selective/preparation.h"

namespace ajar {

/// Adaptation of ordinary Monte Carlo while a render with chains goes on: where its camera samples
/// go, and what its rays have to bring. Every sample of the picture stands for the whole of it,
/// whatever was known by then, so nothing is biased, though it is learnt from samples that stay.
class AdaptiveSampling {
 public:
  /// `settings`: of ordinary Monte Carlo. The plan, whose preparation has ended, must outlive it.
  AdaptiveSampling(const SelectivePreparation& prepared, const RenderSettings& settings);
  AdaptiveSampling(const AdaptiveSampling&) = delete;
  AdaptiveSampling& operator=(const AdaptiveSampling&) = delete;

  /// Tells ordinary Monte Carlo, which this must outlive.
  void tell(PathIntegratorContext& context) const;
  bool learns() const { return rates_ || price_; }
  bool needs_guesses() const { return rates_.has_value(); }
  /// `variance`, `guesses`, `samples`: as `SampleRates::adjust` has them; guesses only if they are
  /// needed. `rays`: per camera sample.
  void adjust(const std::vector<double>& variance, SampleRates::Guesses guesses,
              std::uint64_t samples, double rays);
  /// Current price, if there is one.
  const std::optional<RayPrice>& price() const { return price_; }

  std::uint64_t memory_bytes() const;
  void save_state(OutputArchive& archive) const;
  /// May raise any std::exception if the bytes make no sense.
  void load_state(InputArchive& archive, std::uint64_t samples);

 private:
  std::optional<SampleRates> rates_;  ///< none if all pixels have as many camera samples
  std::optional<RayPrice> price_;
};

}  // namespace ajar
