#include "mcmc/primary/chain_numbers.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "mcmc/primary/fresh_numbers.h"

namespace ajar {

ChainNumbers::ChainNumbers(const PrimaryShape& shape, std::uint64_t key) : fresh_key_(key) {
  if (shape.camera_vertices < 0 || shape.light_vertices < 0) {
    throw std::logic_error("bug: a primary vector with a negative number of vertices");
  }
  static_assert(static_cast<int>(Stream::Camera) == 0 && static_cast<int>(Stream::Light) == 1 &&
                static_cast<int>(Stream::Connection) == 2);
  first_block_[1] = static_cast<std::uint32_t>(shape.camera_vertices);
  first_block_[2] = first_block_[1] + static_cast<std::uint32_t>(shape.light_vertices);
  first_block_[3] = first_block_[2] + 1;
  numbers_.resize(first_block_[kStreams] * kBlockSize);
  stamps_.resize(first_block_[kStreams], 0);
}

void ChainNumbers::refuse(SampleAddress address) {
  throw std::logic_error("bug: vertex " + std::to_string(address.vertex()) + " of stream " +
                         std::to_string(static_cast<int>(address.stream())) +
                         " is beyond the chain's primary vector");
}

void ChainNumbers::fill_fresh(std::span<float, kBlockSize> block, SampleAddress address,
                              std::uint64_t key) {
  const std::uint64_t own_key = block_key(key, address.stream(), address.vertex());
  for (std::size_t pair = 0; pair < kBlockSize / 2; ++pair) {
    const Vec2 numbers = fresh_pair(own_key, pair);
    block[2 * pair] = numbers.x;
    block[2 * pair + 1] = numbers.y;
  }
}

bool ChainNumbers::awaits_fresh(SampleAddress address) const {
  return stamps_[block_of(address)] < clock_of(address).fresh;
}

bool ChainNumbers::misses_small_steps(SampleAddress address) const {
  const Clock& clock = clock_of(address);
  return std::max(stamps_[block_of(address)], clock.fresh) < clock.now;
}

void ChainNumbers::catch_up(SampleAddress address, const Mutation& mutation, const StepSizes& sizes,
                            std::uint64_t key) {
  const std::size_t index = block_of(address);
  const Clock& clock = clock_of(address);
  if (stamps_[index] < clock.fresh) {
    fill_fresh(block(index), address, fresh_key_);
    stamps_[index] = clock.fresh;
  }
  if (stamps_[index] < clock.now) {
    mutation.perturb(block(index), sizes.scales(address.stream(), address.vertex()),
                     static_cast<double>(clock.now - stamps_[index]) / kStepUnits,
                     block_key(key, address.stream(), address.vertex()));
    stamps_[index] = clock.now;
  }
}

void ChainNumbers::advance(const Change& change, std::uint64_t units) {
  for (const Stream stream : {Stream::Camera, Stream::Light, Stream::Connection}) {
    if (change.moves(stream)) clocks_[static_cast<std::size_t>(stream)].now += units;
  }
}

void ChainNumbers::advance_to_fresh(std::uint64_t key) {
  fresh_key_ = key;
  for (Clock& clock : clocks_) clock.fresh = ++clock.now;
}

bool ChainNumbers::can_be_after(std::uint64_t steps) const {
  // A step takes two units of length at most (`ChainSource::accept_moved`).
  const double latest = 1.0 + 2.0 * kStepUnits * static_cast<double>(steps);
  for (std::size_t stream = 0; stream < kStreams; ++stream) {
    const Clock& clock = clocks_[stream];
    if (static_cast<double>(clock.now) > latest || clock.fresh > clock.now) return false;
    for (std::uint32_t block = first_block_[stream]; block < first_block_[stream + 1]; ++block) {
      if (stamps_[block] > clock.now) return false;
    }
  }
  return std::all_of(numbers_.begin(), numbers_.end(),
                     [](float number) { return number >= 0.F && number < 1.F; });
}

std::size_t ChainNumbers::memory_bytes() const {
  return sizeof(*this) + numbers_.capacity() * sizeof(numbers_[0]) +
         stamps_.capacity() * sizeof(stamps_[0]);
}

}  // namespace ajar
