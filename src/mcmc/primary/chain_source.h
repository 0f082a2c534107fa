#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mcmc/primary/chain_numbers.h"
#include "mcmc/primary/mutation.h"
#include "mcmc/primary/plane_moves.h"
#include "mcmc/primary/step_kind.h"
#include "mcmc/primary/step_sizes.h"
#include "transport/sample_source.h"

namespace ajar {

/// The block whose first pair are the raster numbers, vertex 0 of the camera's stream, and whether
/// a state places itself by them: it does if that pair is the first of its block to be asked for.
class RasterUse {
 public:
  void forget() { seen_ = false, used_ = false; }
  void note(SampleAddress address) {
    if (seen_ || address.stream() != Stream::Camera || address.vertex() != 0) return;
    seen_ = true;
    used_ = static_cast<int>(address.slot()) / 2 == static_cast<int>(kEmissionDirection) / 2;
  }
  bool used() const { return used_; }

 private:
  bool seen_ = false;
  bool used_ = false;
};

/// Serves the numbers of a proposal, moving each block of a chain when it is first asked for, and
/// takes the move back if the proposal is rejected. Scratch memory of one thread: only one chain
/// steps at a time. The mutation must outlive it.
///
/// With `PlaneMoves`, the raster numbers of a small step of full length move by them if both the
/// current state and the proposal use them (`RasterUse`), and by the mutation otherwise. The use is
/// known before the numbers are drawn, since a state's use of them depends on numbers that it asks
/// for earlier; and it is the same for the step back.
class ChainSource final : public SampleSource {
 public:
  /// `plane` may be null.
  ChainSource(const Mutation& mutation, const StepSizes& sizes, const PrimaryShape& shape,
              const PlaneMoves* plane = nullptr);

  /// Start of a run: whether the current state uses the raster numbers, and the scale of its small
  /// steps.
  void start(bool uses_raster, float step_scale);
  /// After a step was accepted; 1 unless a published `PlaneMoves` adapts it.
  float step_scale() const { return step_scale_; }
  /// True if the current state uses the raster numbers for its position.
  bool uses_raster() const { return current_uses_raster_; }

  /// Starts a step of `numbers`, which must stay where it is until the step is accepted or
  /// rejected. `key` names the randomness of the step; `change` and `units`, its length, are
  /// ignored for a large step, which moves all.
  void propose(ChainNumbers& numbers, StepKind kind, const Change& change, std::uint64_t key,
               std::uint64_t units = kStepUnits);
  void accept();
  /// Restores every number that this step has moved, but keeps catch-up moves (see `ChainNumbers`).
  void reject();
  /// Accepts a state one small step away from the proposal instead, as `perturb` makes it.
  void accept_moved(std::uint64_t key);
  /// Notes a state that was accepted with numbers from elsewhere: whether it uses the raster
  /// numbers for its position, and their values.
  void arrive(bool uses_raster, const Vec2& raster);
  std::size_t block_of(SampleAddress address) const { return numbers_->block_of(address); }
  /// The proposal's block that holds `address`.
  std::span<const float, kBlockSize> moved_block(SampleAddress address) {
    return numbers_->block(fetch(address));
  }
  /// One small step of the block of `address`, as long as the proposal's.
  void perturb(std::span<float> block, SampleAddress address, std::uint64_t key) const;
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
  /// For numbers that the step leaves as they are, such as directions in a step of the raster
  /// numbers alone.
  void replace_pair(SampleAddress address, const Vec2& numbers, double log_density) override;

 private:
  static constexpr std::size_t kRasterBlock = 0;

  struct Undo {
    SampleAddress address;  ///< any in the block
    std::uint32_t block;
    std::uint64_t stamp;
    const StepSizes::Scales* scales;  ///< null if numbers were replaced
    std::array<float, kBlockSize> numbers;
  };
  std::size_t fetch(SampleAddress address) {
    const std::size_t block = numbers_->block_of(address);
    if (block == kRasterBlock) raster_use_.note(address);
    if (numbers_->stamp(block) != ready_[static_cast<std::size_t>(address.stream())]) {
      prepare(address, block);
    }
    return block;
  }
  void prepare(SampleAddress address, std::size_t block);
  /// Keeps what the block holds, to be restored if the step is rejected; `scales` are those of it.
  const Undo& remember(SampleAddress address, std::size_t block, const StepSizes::Scales* scales);
  void follow_plane(std::span<float, kBlockSize> numbers, const Undo& undo, std::uint64_t key);
  void move_raster_alone();
  void set_step_scale(float scale);
  /// Length of the step, in steps of the mutation.
  double length() const { return static_cast<double>(units_) / kStepUnits; }

  const Mutation& mutation_;
  StepSizes default_sizes_;
  StepSizes sizes_;                  ///< times the step scale
  StepSizes::Scales raster_scales_;  ///< sizes of steps of the raster numbers alone
  float step_scale_ = 1.F;
  const PlaneMoves* plane_;
  bool current_uses_raster_ = false;
  RasterUse raster_use_;             ///< use by the proposal
  double raster_log_ratio_ = 0.0;    ///< log ratio of moves in the plane
  double replaced_log_ratio_ = 0.0;  ///< log ratio of numbers that were replaced
  std::vector<Undo> undo_;
  ChainNumbers* numbers_ = nullptr;
  bool large_ = false;
  std::uint64_t units_ = kStepUnits;
  Change change_;
  std::uint64_t fresh_key_ = 0;
  std::uint64_t move_key_ = 0;
  std::uint64_t catch_up_key_ = 0;
  /// The stamp of a block that the proposal can use, per stream: now, or one later if it moves.
  std::array<std::uint64_t, 3> ready_{};
};

/// Serves the current state of a chain, unchanged. Raises std::logic_error for numbers that the
/// state cannot have used.
class ReplaySource final : public SampleSource {
 public:
  explicit ReplaySource(const ChainNumbers& numbers) : numbers_(numbers) {}
  /// True if the state uses the raster numbers for its position.
  bool uses_raster() const { return raster_use_.used(); }
  float get(SampleAddress address) override {
    const Vec2 pair = get_pair(address);
    return (static_cast<unsigned>(address.slot()) & 1U) == 0 ? pair.x : pair.y;
  }
  Vec2 get_pair(SampleAddress address) override;

 private:
  const ChainNumbers& numbers_;
  RasterUse raster_use_;
};

}  // namespace ajar
