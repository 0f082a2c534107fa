#include "mcmc/primary/try_source.h"

#include <algorithm>

#include "mcmc/primary/fresh_numbers.h"

namespace ajar {

TrySource::TrySource(ChainSource& centre, const PrimaryShape& shape)
    : centre_(centre),
      made_(static_cast<std::size_t>(shape.camera_vertices) +
                static_cast<std::size_t>(shape.light_vertices) + 1,
            0),
      blocks_(made_.size()) {}

void TrySource::make_fresh(std::uint64_t key) {
  fresh_ = true;
  key_ = key;
  raster_use_.forget();
}

void TrySource::move_from_centre(const Change& change, std::uint64_t key) {
  fresh_ = false;
  change_ = change;
  key_ = key;
  raster_use_.forget();
  ++try_;
}

Vec2 TrySource::get_pair(SampleAddress address) {
  const bool knew = raster_use_.used();
  raster_use_.note(address);
  const Vec2 pair = pair_at(address);
  if (raster_use_.used() && !knew) raster_ = pair;
  return pair;
}

Vec2 TrySource::pair_at(SampleAddress address) {
  if (fresh_) return fresh_pair(key_, address);
  if (!change_.moves(address.stream())) return centre_.get_pair(address);
  const std::size_t index = centre_.block_of(address);
  auto& block = blocks_[index];
  if (made_[index] != try_) {
    made_[index] = try_;
    const auto start = centre_.moved_block(address);
    std::copy(start.begin(), start.end(), block.begin());
    centre_.perturb(block, address, key_);
  }
  const std::size_t even = static_cast<std::size_t>(address.slot()) / 2 * 2;
  return {block[even], block[even + 1]};
}

}  // namespace ajar
