#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mcmc/primary/bootstrap_source.h"
#include "mcmc/primary/chain_source.h"
#include "mcmc/primary/primary_chain.h"
#include "mcmc/primary/primary_runner.h"
#include "mcmc/primary/target.h"

/// Targets whose distribution is known, for tests of chains.
namespace ajar::testing {

/// Value of a toy function: I, and the bin it is counted in.
struct ToyValue {
  double scalar;
  int bin;
};
using ToyFunction = std::function<ToyValue(SampleSource&)>;

/// One splat per state, in layer `bin`, of value I: with weights, the deposits are a histogram.
class ToyTarget final : public Target {
 public:
  explicit ToyTarget(ToyFunction function) : function_(std::move(function)) {}
  double evaluate(SampleSource& numbers, const Change&, SplatBuffer& splats) override {
    last_ = function_(numbers);
    splats.push_back({Vec2(0.F, 0.F), last_.bin, Spectrum(static_cast<float>(last_.scalar))});
    return last_.scalar;
  }
  const ToyValue& last() const { return last_; }

 private:
  ToyFunction function_;
  ToyValue last_{0.0, 0};
};

/// Adds up deposits by layer.
class Histogram final : public DepositSink {
 public:
  explicit Histogram(std::size_t bins) : sums_(bins, 0.0) {}
  void deposit(std::span<const Splat> splats, double factor) override {
    for (const Splat& splat : splats) {
      sums_[static_cast<std::size_t>(splat.layer)] += double{splat.value[0]} * factor;
    }
  }
  const std::vector<double>& sums() const { return sums_; }

 private:
  std::vector<double> sums_;
};

/// Sink for chains whose last states alone matter.
struct Nowhere final : DepositSink {
  void deposit(std::span<const Splat>, double) override {}
};

inline constexpr SampleAddress kCameraX{Stream::Camera, 0, Slot::BsdfDirectionX};
inline constexpr SampleAddress kCameraY{Stream::Camera, 0, Slot::BsdfDirectionY};
inline constexpr SampleAddress kInner{Stream::Camera, 1, Slot::BsdfLobe};
inline constexpr SampleAddress kLight{Stream::Light, 0, Slot::LightPositionX};
inline constexpr SampleAddress kInnerLight{Stream::Light, 2, Slot::LightChoice};
inline constexpr SampleAddress kChoice{Stream::Connection, 0, Slot::LightChoice};
inline constexpr PrimaryShape kToyShape{3, 3};

inline int bin_of(float u, int bins) {
  return std::min(static_cast<int>(u * static_cast<float>(bins)), bins - 1);
}

/// A target with its exact distribution over bins.
struct Toy {
  const char* name;
  ToyFunction function;
  double largest;                 ///< largest I
  double mean;                    ///< b
  std::vector<double> fractions;  ///< fractions of ∫ I by bin
};

/// 1-D: a peak of width 0.03 on the seam of the unit interval.
inline Toy peak() {
  constexpr int kBins = 40;
  const auto value = [](double u) { return std::exp(-std::min(u, 1.0 - u) / 0.03); };
  Toy toy{"peak",
          [value](SampleSource& numbers) {
            const float u = numbers.get(kCameraX);
            return ToyValue{value(u), bin_of(u, kBins)};
          },
          1.0, 0.06 * (1.0 - std::exp(-0.5 / 0.03)), std::vector<double>(kBins)};
  for (int i = 0; i < kBins; ++i) {
    const int k = std::min(i, kBins - 1 - i);
    toy.fractions[static_cast<std::size_t>(i)] =
        0.03 * (std::exp(-k / (kBins * 0.03)) - std::exp(-(k + 1) / (kBins * 0.03))) / toy.mean;
  }
  return toy;
}

/// 2-D: 1 inside a triangle, 1/20 outside; bins are 6 × 6 squares.
inline Toy step() {
  constexpr int kSide = 6;
  Toy toy{"step",
          [](SampleSource& numbers) {
            const Vec2 u = numbers.get_pair(kCameraX);
            return ToyValue{u.x + u.y < 1.F ? 1.0 : 0.05,
                            bin_of(u.x, kSide) + kSide * bin_of(u.y, kSide)};
          },
          1.0, 0.525, std::vector<double>(kSide * kSide)};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const int sum = x + y + 1;
      const double inside = sum < kSide ? 1.0 : sum == kSide ? 0.5 : 0.0;
      toy.fractions[static_cast<std::size_t>(x) + kSide * static_cast<std::size_t>(y)] =
          (inside + 0.05 * (1.0 - inside)) / (kSide * kSide * toy.mean);
    }
  }
  return toy;
}

/// 5-D: a product over all streams. Each factor is 1 + 0.6·cos(2πu); the bin says in which half
/// (around 0, or around ½) each number lies.
inline Toy product() {
  Toy toy{"product",
          [](SampleSource& numbers) {
            const Vec2 pair = numbers.get_pair(kCameraX);
            const float u[5] = {pair.y, numbers.get(kInner), numbers.get(kLight),
                                numbers.get(kInnerLight), numbers.get(kChoice)};
            ToyValue value{1.0, 0};
            for (int i = 0; i < 5; ++i) {
              const double c = std::cos(2.0 * double{kPi} * double{u[i]});
              value.scalar *= 1.0 + 0.6 * c;
              if (c > 0.0) value.bin |= 1 << i;
            }
            return value;
          },
          std::pow(1.6, 5), 1.0, std::vector<double>(32, 1.0)};
  // ∫ of 1 + 0.6·cos(2πu) over |u| < ¼ is ½ + 0.6/π.
  const double near = 0.5 + 0.6 / double{kPi};
  for (int bin = 0; bin < 32; ++bin) {
    for (int i = 0; i < 5; ++i) {
      toy.fractions[static_cast<std::size_t>(bin)] *= (bin >> i & 1) != 0 ? near : 1.0 - near;
    }
  }
  return toy;
}

/// Paths of different length: states with u < ½ use a second number v, for which I is 1 below ¼ and
/// 0.05 above; the others have I = ½ and do not ask for it. Bins: 12 of v, and the rest.
inline Toy variable_dimension() {
  constexpr int kBins = 12;
  Toy toy{"variable dimension",
          [](SampleSource& numbers) {
            if (numbers.get(kCameraY) >= 0.5F) return ToyValue{0.5, kBins};
            const float v = numbers.get(kInner);
            return ToyValue{v < 0.25F ? 1.0 : 0.05, bin_of(v, kBins)};
          },
          1.0, 0.5 * (0.25 + 0.75 * 0.05) + 0.25, std::vector<double>(kBins + 1)};
  for (int i = 0; i < kBins; ++i) {
    toy.fractions[static_cast<std::size_t>(i)] =
        0.5 / kBins * (i < kBins / 4 ? 1.0 : 0.05) / toy.mean;
  }
  toy.fractions[kBins] = 0.25 / toy.mean;
  return toy;
}

inline std::vector<Toy> toys() { return {peak(), step(), product(), variable_dimension()}; }

/// A chain that starts exactly in the target's distribution: at an independent sample, taken with
/// probability I / largest. `index` names the chain.
inline PrimaryChain exact_start(const Toy& toy, std::uint64_t seed, std::uint64_t index) {
  const std::uint64_t own_seed = hash_numbers(seed, index);
  for (std::uint64_t attempt = 0;; ++attempt) {
    BootstrapSource source(own_seed, attempt);
    const double scalar = toy.function(source).scalar;
    const double u = to_unit_double(counter_bits(own_seed, attempt));
    if (u * toy.largest < scalar) {
      return PrimaryChain(kToyShape, hash_numbers(own_seed, 1, 2), bootstrap_key(own_seed, attempt),
                          scalar);
    }
  }
}

}  // namespace ajar::testing
