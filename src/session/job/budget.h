#pragma once
#include <cstdint>
#include <optional>

namespace ajar {

/// When a render ends: at whichever limit is reached first. With none, it ends only when
/// interrupted.
struct Budget {
  std::optional<std::uint64_t> samples_per_pixel;  ///< rounded up to whole samples per replicate
  std::optional<double> seconds;                   ///< wall clock
  std::optional<double> target_error;              ///< relative error of the whole picture
  bool denoised_target = false;                    ///< ... of the denoised one
  bool is_empty() const { return !samples_per_pixel && !seconds && !target_error; }
};

/// Seconds that passes may take of a limit: what comes before them has taken `before`, of which
/// `kept` were for samples of the picture, and `after` is expected of what follows. If that is more
/// than half of what is left for the picture, its samples take half.
double seconds_of_passes(double limit, double before, double kept, double after);

/// Statistics for planning the next pass.
struct PassHistory {
  std::uint64_t samples_done = 0;   ///< per pixel
  double seconds = 0.0;             ///< since the render began
  double seconds_per_sample = 0.0;  ///< seconds of the latest pass, per sample per pixel
};

/// Cuts a render into passes of one or more samples per pixel. Decisions that look
/// at the picture are taken at milestones (`milestone_after`) only. Between milestones
/// the clock decides how the samples are cut into passes: short passes keep the program responsive,
/// and cutting does not change the sums. At milestones all replicates have the same number of
/// samples; a render that runs out of time elsewhere leaves some with one sample more than others.
class PassSchedule {
 public:
  /// Largest number of samples per pixel: sample indices have 32 bits.
  static constexpr std::uint64_t kMaxSamples = std::uint64_t{1} << 31;

  /// `pass_seconds`: how long a pass should take at most; one sample per pixel may take longer.
  PassSchedule(const Budget& budget, int replicates, double pass_seconds);

  /// Samples per pixel of the next pass; 0 if the samples or the seconds are used up.
  std::uint64_t next_pass(const PassHistory& history) const;
  /// Samples per pixel at which the render ends: the budget, rounded up to a multiple of the
  /// replicates.
  std::uint64_t total() const { return total_; }
  /// True if samples per pixel `samples` is a milestone or the end.
  bool is_milestone(std::uint64_t samples) const;
  /// True if it is one whatever the budget.
  bool is_natural_milestone(std::uint64_t samples) const;

 private:
  Budget budget_;
  std::uint64_t replicates_;
  double pass_seconds_;
  std::uint64_t total_;
};

}  // namespace ajar
