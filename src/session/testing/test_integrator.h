#pragma once
#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

#include "integrator/integrator.h"

namespace ajar {

/// For tests of the session: every pixel is an item; a sample's value is a hash of (pixel, sample),
/// so that the sums are known and depend on every sample that was taken.
class TestIntegrator final : public Integrator {
 public:
  TestIntegrator(Vec2i size, int replicates) : size_(size), replicates_(replicates) {}

  std::vector<LayerSpec> layers() const override {
    std::vector<LayerSpec> specs = {LayerSpec{.name = "direct"}, LayerSpec{.name = "indirect"}};
    if (has_part) specs.push_back({.name = "weak", .part_of = "indirect"});
    if (uneven) specs.push_back({.name = "albedo", .has_replicates = false});
    return specs;
  }
  std::uint64_t items_in_round() const override {
    return static_cast<std::uint64_t>(size_.x) * static_cast<std::uint64_t>(size_.y);
  }
  void run_item(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples, Film& film,
                Counters& counters) override {
    if (on_item) on_item(item, first_sample, samples);
    const auto width = static_cast<std::uint64_t>(size_.x);
    const Vec2i pixel(static_cast<int>(item % width), static_cast<int>(item / width));
    for (std::uint64_t i = first_sample; i < first_sample + samples; ++i) {
      const int replicate = static_cast<int>(i % static_cast<std::uint64_t>(replicates_));
      for (std::uint64_t k = 0; k < camera_samples(item); ++k) {
        const Spectrum seen(value(first_number + item, i + 1000 * k));
        film.add(0, replicate, pixel, seen);
        if (uneven) film.add(film.layer("albedo"), replicate, pixel, seen);
      }
      film.add(1, replicate, pixel, Spectrum(0.25F));
      if (has_part) film.add(2, replicate, pixel, Spectrum(0.5F));
      ++counters.samples;
      counters.rays += 2;
      if (item % 5 == 3 && i == 1) {
        ++counters.discarded_nan;
        ++counters.rays_out_of_range;
        if (counters.first_discarded.empty()) {
          counters.first_discarded = "item " + std::to_string(item);
        }
      }
    }
  }
  DevelopScale develop_scale(const LayerSpec& layer, std::uint64_t samples,
                             std::optional<int> replicate) const override {
    DevelopScale scale((replicate ? replicates_ : 1) / static_cast<double>(samples));
    if (!uneven || layer.name == "indirect") return scale;
    for (std::uint64_t item = 0; item < items_in_round(); ++item) {
      scale.pixels.push_back(1.F / static_cast<float>(camera_samples(item)));
    }
    return scale;
  }

  /// Samples of a pixel for each sample of the picture, of direct light alone.
  std::uint64_t camera_samples(std::uint64_t item) const {
    return uneven ? 1 + (first_number + item) % 3 : 1;
  }

  bool is_of_chains(std::uint64_t /*item*/) const override { return has_chains; }

  /// In [0, 1), different for every item and sample.
  static float value(std::uint64_t item, std::uint64_t sample) {
    std::uint64_t x = (item * 1000003U + sample + 1U) * 0x9E3779B97F4A7C15ULL;
    x = (x ^ (x >> 29U)) * 0xBF58476D1CE4E5B9ULL;
    return static_cast<float>(x >> 40U) * 0x1p-24F;
  }

  /// Called at the beginning of every item, on its thread; may be empty.
  std::function<void(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples)>
      on_item;
  /// Stands for a seed: that of item 0 in `value`.
  std::uint64_t first_number = 0;
  /// Adds a layer of 0.5 that is a part of the indirect light.
  bool has_part = false;
  /// Gives pixels different numbers of camera samples, and adds a layer of what they saw.
  bool uneven = false;
  bool has_chains = false;  ///< all items are of chains

 private:
  Vec2i size_;
  int replicates_;
};

}  // namespace ajar
