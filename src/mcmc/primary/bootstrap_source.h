#pragma once
#include <cstdint>

#include "mcmc/primary/fresh_numbers.h"
#include "transport/sample_source.h"

namespace ajar {

/// Names the primary vector of bootstrap sample `index`; a chain that starts from it takes this
/// key.
constexpr std::uint64_t bootstrap_key(std::uint64_t seed, std::uint64_t index) {
  return hash_numbers(seed, index);
}

/// The independent uniform numbers of one bootstrap sample.
class BootstrapSource final : public SampleSource {
 public:
  BootstrapSource(std::uint64_t seed, std::uint64_t index) : key_(bootstrap_key(seed, index)) {}
  float get(SampleAddress address) override {
    const Vec2 pair = fresh_pair(key_, address);
    return (static_cast<unsigned>(address.slot()) & 1U) == 0 ? pair.x : pair.y;
  }
  Vec2 get_pair(SampleAddress address) override { return fresh_pair(key_, address); }

 private:
  std::uint64_t key_;
};

}  // namespace ajar
