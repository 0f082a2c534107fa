#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "integrator/integrator.h"
#include "session/job/interrupts.h"
#include "session/job/ranks.h"
#include "session/job/resources.h"

namespace ajar {

/// Limits of a preparation.
struct PreparationLimits {
  std::optional<double> seconds = std::nullopt;  ///< for this and the render together
  /// Clock of these seconds, from any start; the wall clock if there is none.
  std::function<double()> clock = {};
  /// Samples of the picture, per pixel, if they end the render.
  std::optional<std::uint64_t> samples = std::nullopt;
  std::uint64_t pixels = 1;  ///< size of the picture
  /// State of an earlier run, which this one repeats.
  struct CutShort {
    std::uint64_t rounds = 0;
    PreparationCut of = PreparationCut::Time;
  };
  std::optional<CutShort> earlier = std::nullopt;
  const InterruptCount* interrupts = nullptr;
  Ranks* ranks = nullptr;  ///< cooperating processes; they check the limits between rounds only
};

/// End of a preparation: all but `Done` mean that it was cut short.
enum class PreparationEnd { Done, FewSamples, NoTime, Interrupted };

/// Runs the rounds of an integrator's preparation on all threads that TBB may use. If the user asks
/// to stop, or what does not become part of the picture would take more than a quarter of the time
/// for the render, or the whole more than half of it, the integrator has to do without what is left
/// (`Integrator::skip_preparation`). Rounds that serve alone run as long as they themselves end in
/// that time. Where a round shows in its first tenth that it would take longer, it is given up
/// there, and what it did is lost.
///
/// Renders with a limit of samples: no round begins if samples that are not kept would be more than
/// a quarter of all effort, or the whole preparation more than half of it. Effort is counted, so
/// that the decision is the same wherever the render runs. Small pictures are prepared all the same
/// (`SessionHeuristics::kFewToPrepare`).
class Preparation {
 public:
  /// Is shown what the integrator has seen so far (`Integrator::take_first_look`), on the thread of
  /// `run`.
  using Show = std::function<void(std::vector<float> rgb)>;

  explicit Preparation(Integrator& integrator, PreparationLimits limits = {}, Show show = {})
      : integrator_(integrator),
        limits_(std::move(limits)),
        show_(std::move(show)),
        began_(limits_.clock ? limits_.clock() : 0.0) {}
  /// To be called once. What was spent.
  Counters run();
  PreparationEnd end() const { return end_; }
  /// Completed rounds.
  std::uint64_t rounds() const { return rounds_; }
  /// Time of rounds whose samples stay in the picture.
  double seconds_kept() const { return seconds_kept_; }
  /// At any time, from any thread: estimate, 0…1.
  double fraction_done() const;
  double seconds() const { return limits_.clock ? limits_.clock() - began_ : clock_.seconds(); }

 private:
  /// Seconds for all rounds, or for those that are not kept.
  double limit(bool stays) const;
  /// When a round is to have ended, seconds. Rounds that are kept do not count against others.
  double deadline(bool stays) const;
  /// Why to stop at once, if it is to end then; `Done`: not at all.
  PreparationEnd must_stop(double deadline) const;
  /// True if the current round will not end by then. Decided once, as soon as a tenth of it is
  /// done: of many estimates the worst would decide.
  bool will_be_late(double deadline);
  /// Up to the end of the round that is about to begin, or of the last if it needs that.
  struct Efforts {
    double all;
    double lost;  ///< part of it that is not kept
  };
  Efforts efforts_with(const PreparationRound& next) const;
  /// True if the picture has too few samples for the round that is about to begin, and for the
  /// later ones if it needs them.
  bool has_few_samples(const PreparationRound& next) const;
  /// Why to do without the round that is about to begin, and the later ones; the same on all ranks.
  PreparationEnd must_skip(const PreparationRound& next) const;
  /// Why it was cut short; `Done`: it was not.
  PreparationEnd run_round(int round, double deadline, Counters& whole);

  Integrator& integrator_;
  PreparationLimits limits_;
  Show show_;
  const Stopwatch clock_;
  const double began_;  ///< by the limits' clock
  PreparationEnd end_ = PreparationEnd::Done;
  std::uint64_t rounds_ = 0;
  double stays_ = 0.0;         ///< effort, of rounds that are over
  double seconds_kept_ = 0.0;  ///< time of rounds that are over
  double round_began_ = 0.0;   ///< seconds
  // Efforts: of rounds that are over, of the one that runs, and of all.
  std::atomic<double> over_{0.0};
  std::atomic<double> running_{0.0};
  std::atomic<double> all_{0.0};
  std::atomic<std::uint64_t> items_{1};
  std::atomic<std::uint64_t> items_begun_{0};
  std::atomic<std::uint64_t> items_done_{0};
  std::atomic<bool> has_told_{false};  ///< the lateness of the round was decided
};

/// The whole of it.
Counters prepare(Integrator& integrator);

}  // namespace ajar
