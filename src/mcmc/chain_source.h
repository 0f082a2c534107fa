#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "mcmc/chain_numbers.h"
#include "mcmc/mutation.h"
#include "mcmc/step_kind.h"
#include "mcmc/step_sizes.h"
#include "transport/sample_source.h"

namespace ajar {

/// Serves the numbers of a proposal, moving each block of a chain when it is first asked for, and
/// takes the move back if the proposal is rejected. Scratch memory of one thread: only one chain
/// steps at a time. The mutation must outlive it.
class ChainSource final : public SampleSource {
 public:
  ChainSource(const Mutation& mutation, const StepSizes& sizes, const PrimaryShape& shape);

  /// Starts a step of `numbers`, which must stay where it is until the step is accepted or
  /// rejected. `key` names the randomness of the step; `change` is ignored for a large step, which
  /// moves all.
  void propose(ChainNumbers& numbers, StepKind kind, const Change& change, std::uint64_t key);
  void accept();
  /// Restores every number that this step has moved, but keeps what was made up for (see
  /// `ChainNumbers`).
  void reject();
  /// log T(proposal → current) − log T(current → proposal).
  double log_ratio() const;

  float get(SampleAddress address) override {
    return numbers_->block(fetch(address))[static_cast<std::size_t>(address.slot())];
  }
  Vec2 get_pair(SampleAddress address) override {
    const std::size_t even = static_cast<std::size_t>(address.slot()) / 2 * 2;
    const auto block = numbers_->block(fetch(address));
    return {block[even], block[even + 1]};
  }

 private:
  struct Undo {
    std::uint32_t block;
    std::uint32_t stamp;
    const StepSizes::Scales* scales;
    std::array<float, kBlockSize> numbers;
  };
  std::size_t fetch(SampleAddress address) {
    const std::size_t block = numbers_->block_of(address);
    if (numbers_->stamp(block) != ready_[static_cast<std::size_t>(address.stream())]) {
      prepare(address, block);
    }
    return block;
  }
  void prepare(SampleAddress address, std::size_t block);

  const Mutation& mutation_;
  StepSizes sizes_;
  std::vector<Undo> undo_;
  ChainNumbers* numbers_ = nullptr;
  bool large_ = false;
  Change change_;
  std::uint64_t fresh_key_ = 0;
  std::uint64_t move_key_ = 0;
  std::uint64_t catch_up_key_ = 0;
  /// The stamp of a block that the proposal can use, per stream: now, or one later if it moves.
  std::array<std::uint32_t, 3> ready_{};
};

/// Serves the current state of a chain, unchanged. Raises std::logic_error for numbers that the
/// state cannot have used.
class ReplaySource final : public SampleSource {
 public:
  explicit ReplaySource(const ChainNumbers& numbers) : numbers_(numbers) {}
  float get(SampleAddress address) override {
    const Vec2 pair = get_pair(address);
    return (static_cast<unsigned>(address.slot()) & 1U) == 0 ? pair.x : pair.y;
  }
  Vec2 get_pair(SampleAddress address) override;

 private:
  const ChainNumbers& numbers_;
};

}  // namespace ajar
