#pragma once
#include <cstddef>
#include <cstdint>

namespace ajar {

/// The fitted numbers of the room: those that might as well be half or twice as large. No
/// expectation hangs on them.
struct SessionHeuristics {
  // -------------------------------------------------------- time
  /// Of the time for a render, what its preparation may take; and of the effort of a render of so
  /// many samples, what may be spent on samples that are not of its picture.
  /// Unit: share. Range: (0, 1). Source: d9bd289: with three quarters, most of a short render was
  /// thrown away; no study of others.
  static constexpr double kMostOfTime = 0.25;
  /// Limit where the samples of the current round are kept: stopping it early loses them; and limit
  /// of the whole preparation's effort.
  /// Unit: share. Range: [kMostOfTime, 1). Source: set by hand, no study; as much is left to go on.
  static constexpr double kMostOfTimeForPicture = 0.5;
  /// A preparation of so few camera samples is never too much for a render of few samples: those
  /// of pictures of up to 160x120 pixels have no more.
  /// Unit: camera samples. Range: >= 0. Source: docs/results/speed.md, "The first picture": they
  /// take 0.5 to 0.6 CPU-seconds in small scenes. Half and double not measured.
  static constexpr double kFewToPrepare = 163840.0;
  /// Least finished part of a round of a preparation before its rate is used.
  /// Unit: share. Range: (0, 1]. Source: 8145106; set by hand, no study.
  static constexpr double kTelling = 0.1;
  /// Least finished part of a phase before its remaining time is shown.
  /// Unit: share. Range: (0, 1). Source: 1a1aa89; set by hand, no study.
  static constexpr double kLeastDone = 0.01;
  /// Limit of writing files now and then, relative to the time of a render.
  /// Unit: share. Range: (0, 1]. Source: 7410de2; set by hand, no study.
  static constexpr double kMostForWriting = 0.1;
  /// Limit of copying and developing pictures for viewers, relative to the time of a render.
  /// Unit: share. Range: (0, 1]. Source: 8adbb67; set by hand, no study.
  static constexpr double kMostForPreviews = 0.05;
  /// From a file that could not be written to the next attempt.
  /// Unit: seconds. Range: > 0. Source: 7410de2; set by hand, no study.
  static constexpr double kUntilRetry = 10.0;

  // -------------------------------------------------------- when a target error is reached
  /// Fewer samples per replicate say too little about the error to stop a render.
  /// Unit: samples per pixel. Range: >= 1. Source: a0a7cc1; set by hand, no study.
  static constexpr std::uint64_t kSamplesBeforeTarget = 4;
  /// Estimates that must agree.
  /// Unit: estimates. Range: >= 1. Source: 7410de2: fewer agree by chance too easily.
  static constexpr std::size_t kFewestMarks = 3;

  // -------------------------------------------------------- when an exposure is advised
  /// Unit: share of the pixels. Range: (0, 1]. Source: cb9085a; set by hand, no study.
  static constexpr double kMuchWhite = 0.1;
  /// Unit: share of the pixels. Range: (0, 1]. Source: the same; a night is black, too.
  static constexpr double kNearlyAllBlack = 0.9;
  /// Least change by the advice.
  /// Unit: stops. Range: >= 0. Source: the same.
  static constexpr float kWorthIt = 1.F;
};

}  // namespace ajar
