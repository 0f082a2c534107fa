#include "mcmc/primary/chain_source.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/random_use.h"
#include "mcmc/primary/fresh_numbers.h"
#include "mcmc/primary/heuristics.h"

namespace ajar {

namespace {
constexpr auto kRasterX = static_cast<std::size_t>(kEmissionDirection);
// Far beyond what a mutation draws for a block.
constexpr auto kRasterKey = static_cast<std::uint64_t>(RandomUse::RasterMove);
constexpr auto kLengthKey = static_cast<std::uint64_t>(RandomUse::RasterLength);
}  // namespace

ChainSource::ChainSource(const Mutation& mutation, const StepSizes& sizes,
                         const PrimaryShape& shape, const PlaneMoves* plane)
    : mutation_(mutation), default_sizes_(sizes), sizes_(sizes), plane_(plane) {
  undo_.reserve(static_cast<std::size_t>(shape.camera_vertices) +
                static_cast<std::size_t>(shape.light_vertices) + 1);
}

void ChainSource::start(bool uses_raster, float step_scale) {
  current_uses_raster_ = uses_raster;
  set_step_scale(step_scale);
}

void ChainSource::set_step_scale(float scale) {
  if (scale == step_scale_) return;
  step_scale_ = scale;
  sizes_ = default_sizes_.times(scale);
}

void ChainSource::propose(ChainNumbers& numbers, StepKind kind, const Change& change,
                          std::uint64_t key, std::uint64_t units) {
  numbers_ = &numbers;
  undo_.clear();
  raster_use_.forget();
  raster_log_ratio_ = 0.0;
  replaced_log_ratio_ = 0.0;
  large_ = kind == StepKind::Large;
  change_ = large_ ? Change{} : change;
  units_ = large_ ? 1 : units;
  fresh_key_ = counter_bits(key, 0);
  move_key_ = counter_bits(key, 1);
  catch_up_key_ = counter_bits(key, 2);
  ready_ = {numbers.now(Stream::Camera) + (change_.camera ? units_ : 0),
            numbers.now(Stream::Light) + (change_.light ? units_ : 0),
            numbers.now(Stream::Connection) + (change_.connection ? units_ : 0)};
  if (change_.raster) move_raster_alone();
}

void ChainSource::move_raster_alone() {
  const double u = to_unit_double(counter_bits(move_key_, kLengthKey));
  const auto times = static_cast<float>(std::pow(PrimaryHeuristics::kRasterLength, u));
  raster_scales_ = sizes_.camera_endpoint;
  for (const std::size_t i : {kRasterX, kRasterX + 1}) {
    raster_scales_[i] = std::min(raster_scales_[i] * times, StepSizes::kLargest);
  }
  // The state uses them, so they are up to date, and have no clock of their own to move.
  remember(SampleAddress(Stream::Camera, 0, kEmissionDirection), kRasterBlock, &raster_scales_);
  mutation_.perturb(numbers_->block(kRasterBlock).subspan<kRasterX, 2>(),
                    std::span(raster_scales_).subspan<kRasterX, 2>(), length(),
                    counter_bits(move_key_, kRasterKey));
}

const ChainSource::Undo& ChainSource::remember(SampleAddress address, std::size_t block,
                                               const StepSizes::Scales* scales) {
  const auto numbers = numbers_->block(block);
  Undo& undo = undo_.emplace_back(
      Undo{address, static_cast<std::uint32_t>(block), numbers_->stamp(block), scales, {}});
  std::copy(numbers.begin(), numbers.end(), undo.numbers.begin());
  return undo;
}

void ChainSource::prepare(SampleAddress address, std::size_t block) {
  const std::uint64_t ready = ready_[static_cast<std::size_t>(address.stream())];
  const bool moves = ready != numbers_->now(address.stream());
  // A large step does not depend on where it starts, so there is no need to know.
  if (!large_) numbers_->catch_up(address, mutation_, sizes_, catch_up_key_);
  if (!moves) return;

  const auto numbers = numbers_->block(block);
  const Undo& undo = remember(address, block, &sizes_.scales(address.stream(), address.vertex()));
  if (large_) {
    ChainNumbers::fill_fresh(numbers, address, fresh_key_);
  } else {
    const std::uint64_t key = block_key(move_key_, address.stream(), address.vertex());
    mutation_.perturb(numbers, *undo.scales, length(), key);
    const bool may_follow = plane_ != nullptr && units_ == kStepUnits && block == kRasterBlock;
    if (may_follow && current_uses_raster_ && raster_use_.used()) {
      follow_plane(numbers, undo, key);
    }
  }
  numbers_->set_stamp(block, ready);
}

void ChainSource::follow_plane(std::span<float, kBlockSize> numbers, const Undo& undo,
                               std::uint64_t key) {
  const Vec2 from(undo.numbers[kRasterX], undo.numbers[kRasterX + 1]);
  // The other numbers of the block must not know where these go.
  if (const std::optional<Vec2> to = plane_->move(from, counter_bits(key, kRasterKey))) {
    numbers[kRasterX] = to->x;
    numbers[kRasterX + 1] = to->y;
  }
  raster_log_ratio_ = plane_->log_ratio(from, Vec2(numbers[kRasterX], numbers[kRasterX + 1]));
}

void ChainSource::replace_pair(SampleAddress address, const Vec2& numbers, double log_density) {
  const std::size_t block = fetch(address);
  if (large_ || change_.moves(address.stream())) {
    throw std::logic_error("bug: a step would replace numbers that it moves");
  }
  remember(address, block, nullptr);
  const std::size_t even = static_cast<std::size_t>(address.slot()) / 2 * 2;
  const auto all = numbers_->block(block);
  all[even] = numbers.x;
  all[even + 1] = numbers.y;
  replaced_log_ratio_ += log_density;
}

void ChainSource::accept() {
  if (large_) {
    numbers_->advance_to_fresh(fresh_key_);
  } else {
    numbers_->advance(change_, units_);
  }
  const auto block = numbers_->block(kRasterBlock);
  arrive(raster_use_.used(), Vec2(block[kRasterX], block[kRasterX + 1]));
}

void ChainSource::arrive(bool uses_raster, const Vec2& raster) {
  current_uses_raster_ = uses_raster;
  if (large_ && plane_ != nullptr && plane_->published()) {
    set_step_scale(uses_raster ? plane_->factor(raster) : 1.F);
  }
}

void ChainSource::perturb(std::span<float> block, SampleAddress address, std::uint64_t key) const {
  mutation_.perturb(block, sizes_.scales(address.stream(), address.vertex()), length(),
                    block_key(key, address.stream(), address.vertex()));
}

void ChainSource::accept_moved(std::uint64_t key) {
  // Numbers not requested so far have two steps to catch up with.
  numbers_->advance(change_, 2 * units_);
  for (const Undo& undo : undo_) {
    perturb(numbers_->block(undo.block), undo.address, key);
    numbers_->set_stamp(undo.block, numbers_->now(undo.address.stream()));
  }
}

void ChainSource::reject() {
  for (const Undo& undo : undo_) {
    std::copy(undo.numbers.begin(), undo.numbers.end(), numbers_->block(undo.block).begin());
    numbers_->set_stamp(undo.block, undo.stamp);
  }
}

double ChainSource::log_ratio() const {
  if (large_) return 0.0;
  double sum = raster_log_ratio_ + replaced_log_ratio_;
  for (const Undo& undo : undo_) {
    if (undo.scales == nullptr) continue;
    sum += mutation_.log_ratio(undo.numbers, numbers_->block(undo.block), *undo.scales);
  }
  return sum;
}

Vec2 ReplaySource::get_pair(SampleAddress address) {
  raster_use_.note(address);
  if (numbers_.misses_small_steps(address)) {
    throw std::logic_error(
        "bug: the replay of a state asks for numbers that the state did not use: the target is not "
        "a function of its primary numbers");
  }
  if (numbers_.awaits_fresh(address)) return fresh_pair(numbers_.fresh_key(), address);
  const std::size_t even = static_cast<std::size_t>(address.slot()) / 2 * 2;
  const auto block = numbers_.block(numbers_.block_of(address));
  return {block[even], block[even + 1]};
}

}  // namespace ajar
