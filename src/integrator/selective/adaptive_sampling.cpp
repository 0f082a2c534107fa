#include "integrator/selective/adaptive_sampling.h"

#include <utility>

#include "integrator/montecarlo/g_buffer.h"

namespace ajar {

AdaptiveSampling::AdaptiveSampling(const SelectivePreparation& prepared,
                                   const RenderSettings& settings)
    : price_(prepared.ray_price) {
  // Layers of the G-buffer are means over camera samples, and have as many everywhere.
  const bool has_rates = prepared.config.adaptive_samples && !prepared.preparation_cut &&
                         settings.replicates > 1 && GBuffer::layers(settings.aovs, 1.F).empty();
  if (!has_rates) return;
  rates_.emplace(settings.crop, settings.replicates, settings.seed);
}

void AdaptiveSampling::tell(PathIntegratorContext& context) const {
  context.rates = rates_ ? &*rates_ : nullptr;
  context.price = price_ ? &*price_ : nullptr;
}

void AdaptiveSampling::adjust(const std::vector<double>& variance, SampleRates::Guesses guesses,
                              std::uint64_t samples, double rays) {
  if (price_) {
    std::vector<double> of_one_sample = variance;
    for (double& value : of_one_sample) value *= static_cast<double>(samples);
    price_->adjust(of_one_sample, rays);
  }
  if (rates_) rates_->adjust(variance, std::move(guesses), samples);
}

std::uint64_t AdaptiveSampling::memory_bytes() const { return rates_ ? rates_->memory_bytes() : 0; }

void AdaptiveSampling::save_state(OutputArchive& archive) const {
  if (rates_) rates_->save_state(archive);
  if (price_) price_->save_state(archive);
}

void AdaptiveSampling::load_state(InputArchive& archive, std::uint64_t samples) {
  if (rates_) rates_->load_state(archive, samples);
  if (price_) price_->load_state(archive);
}

}  // namespace ajar
