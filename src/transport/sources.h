#pragma once
#include <array>

#include "core/random.h"
#include "core/sobol.h"
#include "transport/sample_source.h"

namespace ajar {

/// Identity of one sample of an ordinary Monte Carlo render. The camera's numbers come from a
/// sequence per pixel; the light's from one sequence for the whole image, since light subpaths
/// belong to no pixel.
struct SampleIdentity {
  std::uint64_t camera_seed;   ///< seed of the pixel and replicate
  std::uint32_t camera_index;  ///< within the pixel
  std::uint64_t light_seed;    ///< seed of the replicate
  std::uint32_t light_index;   ///< within the image
};

inline std::uint64_t vertex_key(SampleAddress address) {
  return static_cast<std::uint64_t>(address.repeat()) << 40U |
         static_cast<std::uint64_t>(address.stream()) << 32U |
         static_cast<std::uint64_t>(address.vertex()) << 8U;
}

/// Independent uniform numbers: a hash of identity and address.
class IndependentSource final : public SampleSource {
 public:
  explicit IndependentSource(const SampleIdentity& identity)
      : camera_(hash_numbers(identity.camera_seed, identity.camera_index)),
        light_(hash_numbers(identity.light_seed, identity.light_index)) {}
  float get(SampleAddress address) override {
    return to_unit_float(static_cast<std::uint32_t>(bits(address) >> 32U));
  }
  Vec2 get_pair(SampleAddress address) override {
    const std::uint64_t v = bits(address);
    return {to_unit_float(static_cast<std::uint32_t>(v >> 32U)),
            to_unit_float(static_cast<std::uint32_t>(v))};
  }

 private:
  std::uint64_t bits(SampleAddress address) const {
    const std::uint64_t base = address.stream() == Stream::Light ? light_ : camera_;
    const std::uint64_t key = vertex_key(address) | static_cast<std::uint64_t>(address.slot());
    return mix_bits(base + key * 0x9e3779b97f4a7c15ULL);
  }
  std::uint64_t camera_;
  std::uint64_t light_;
};

/// Owen-scrambled Sobol' points: each pair of slots of each vertex has its own scrambled and
/// shuffled two-dimensional set ("padding"). The numbers of a vertex are made at once when the
/// first of them is requested, but for those of media, which few paths need. The roulette of
/// connections uses independent numbers: there are many of them, one at a time, and points so far
/// from the first would be no better. Source: Kollig & Keller 2002; Burley 2020.
class SobolSource final : public SampleSource {
 public:
  explicit SobolSource(const SampleIdentity& identity)
      : identity_(identity), independent_(identity) {}

  float get(SampleAddress address) override {
    if (address.stream() == Stream::Connection) return independent_.get(address);
    const Vec2 pair = fetch(address);
    return (static_cast<unsigned>(address.slot()) & 1U) == 0 ? pair.x : pair.y;
  }
  Vec2 get_pair(SampleAddress address) override {
    return address.stream() == Stream::Connection ? independent_.get_pair(address) : fetch(address);
  }

 private:
  /// Slots 2k and 2k + 1 share pad k; these are made at once.
  static_assert(static_cast<std::size_t>(Slot::MediumLane) == 2 * kSobolPads);
  struct Block {
    std::uint64_t key = ~std::uint64_t{0};
    SobolPads pads;
  };

  Vec2 fetch(SampleAddress address) {
    const bool light = address.stream() == Stream::Light;
    const std::uint32_t index = light ? identity_.light_index : identity_.camera_index;
    const std::uint64_t base = light ? identity_.light_seed : identity_.camera_seed;
    const std::uint64_t key = vertex_key(address);
    const auto seed = [&](std::size_t pad) {
      return base + (key + pad + 1) * 0x9e3779b97f4a7c15ULL;
    };
    const std::size_t pad = static_cast<std::size_t>(address.slot()) / 2;
    if (pad >= kSobolPads) return sobol_2d(index, seed(pad));
    Block& block = blocks_[static_cast<std::size_t>(address.stream())];
    if (block.key != key) {
      std::array<std::uint64_t, kSobolPads> seeds;
      for (std::size_t k = 0; k < kSobolPads; ++k) seeds[k] = seed(k);
      block.pads = sobol_pads(index, seeds);
      block.key = key;
    }
    return block.pads[pad];
  }

  SampleIdentity identity_;
  IndependentSource independent_;
  std::array<Block, 2> blocks_;  // blocks of the camera, and of the light
};

}  // namespace ajar
