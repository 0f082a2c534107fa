#pragma once
#include "core/random.h"
#include "core/sobol.h"
#include "transport/sample_source.h"

namespace ajar {

/// Identity of one sample of an ordinary Monte Carlo render. The camera's numbers come from a sequence per pixel; the light's
/// from one sequence for the whole image, since light subpaths belong to no pixel.
struct SampleIdentity {
  std::uint64_t camera_seed;   ///< of the pixel and replicate
  std::uint32_t camera_index;  ///< within the pixel
  std::uint64_t light_seed;    ///< of the replicate
  std::uint32_t light_index;   ///< within the image
};

inline std::uint64_t address_key(SampleAddress address) {
  return static_cast<std::uint64_t>(address.stream) << 32U |
         static_cast<std::uint64_t>(address.vertex) << 8U | static_cast<std::uint64_t>(address.slot);
}

/// Owen-scrambled Sobol' points, one independently scrambled and shuffled set per address ("padding").
/// Source: Kollig & Keller 2002; Burley 2020.
class SobolSource final : public SampleSource {
 public:
  explicit SobolSource(const SampleIdentity& identity) : identity_(identity) {}
  float get(SampleAddress address) override {
    const bool light = address.stream == Stream::Light;
    return sobol_1d(light ? identity_.light_index : identity_.camera_index, seed(address, light));
  }
  Vec2 get_pair(SampleAddress address) override {
    const bool light = address.stream == Stream::Light;
    return sobol_2d(light ? identity_.light_index : identity_.camera_index, seed(address, light));
  }

 private:
  std::uint32_t seed(SampleAddress address, bool light) const {
    const std::uint64_t base = light ? identity_.light_seed : identity_.camera_seed;
    return static_cast<std::uint32_t>(mix_bits(base + address_key(address) * 0x9e3779b97f4a7c15ULL));
  }
  SampleIdentity identity_;
};

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
    const std::uint64_t base = address.stream == Stream::Light ? light_ : camera_;
    return mix_bits(base + address_key(address) * 0x9e3779b97f4a7c15ULL);
  }
  std::uint64_t camera_;
  std::uint64_t light_;
};

}  // namespace ajar
