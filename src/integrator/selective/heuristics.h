#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace ajar {

/// The fitted numbers of `selective`: those that might as well be half or twice as large. Each with
/// unit, range, and where it comes from; commits have what was measured if no page of docs/ has.
/// Whatever they are, no expectation changes, only noise and time do.
struct SelectiveHeuristics {
  // -------------------------------------------------------- how bright is too bright
  //
  // All are in units of the brightness (mean luminance · importance of the picture).

  /// Thresholds T that a pilot may choose from for chains that start from what was found.
  /// Unit: brightness. Range: > 0, ascending. Source: docs/notebook/chains.md, "Where to divide":
  /// the best of them is 0.1 on door-ajar and 10 on bathroom.
  static constexpr std::array<double, 5> kThresholds = {0.1, 0.3, 1.0, 3.0, 10.0};
  /// One more where regions choose: what is shared by the error that is seen deserves fewer chains.
  /// Unit: brightness. Range: > the last of kThresholds. Source: docs/notebook/selective.md, "How":
  /// without it, up to 10, torus-in-glass has 1/0.98 of error and FLIP.
  static constexpr double kHighestThreshold = 30.0;

  /// Paths that bring more count as this where a pilot measures errors: what is brighter is rare,
  /// and for chains to deal with. Unit: brightness. Range: > 0. Source: docs/notebook/selective.md,
  /// "Constants"; cbffe58: without a bound, fireflies decided between ibpt and bdpt on bathroom.
  static constexpr double kBright = 3.0;
  /// Display white: brighter light looks no worse. Chains for fireflies only have it for T (with a
  /// number for `split`, so many times that), large steps do not learn from more, and paths count
  /// up to it where it is asked whether chains pay. Unit: brightness. Range: > kHighestThreshold.
  /// Source: docs/notebook/selective.md, "Whether chains pay": efficiency with 30, 100 and 1000
  /// is 5.8, 5.8 and 2.1 on torus-in-glass, 169, 173 and 176 on cornell; "Constants".
  static constexpr double kDisplayWhite = 100.0;
  /// Clamp of a path's contribution in the test whether chains for fireflies only are needed. Of
  /// light that is found in one sample of ten thousand, a pilot sees one or two paths. They are far
  /// brighter than white, and keep such chains busy.
  /// Unit: brightness. Range: > kDisplayWhite. Source: with kDisplayWhite instead, one of eight
  /// seeds of torus-in-glass at 48x36 pixels has nothing difficult in it.
  static constexpr double kFireflyClamp = 1000.0;

  // -------------------------------------------------------- how clear a gain has to be
  //
  // Error over error, of chains, of which blotches are to be feared. Techniques of ordinary Monte
  // Carlo all leave even noise: of them the better one is taken.

  /// Chains should bring clearly more than they cost, and the more they bring, the more they are
  /// trusted, since what they leave are blotches: of a gain
  /// of 0.8, as predicted and found on door-ajar and floor-lamps, nothing is seen, and after a blur
  /// of four pixels the error is up to six times as large.
  /// Unit: predicted error with chains over that without. Range: (0, 1]. Source:
  /// docs/notebook/selective.md, "Whether chains pay": with 0.7 teapot-full has 1.4 times the
  /// finished error, torus-in-glass 0.94.
  static constexpr double kClearGain = 0.35;

  // -------------------------------------------------------- pilot of the brightness
  /// Squares with a camera sample each that tell the brightness of a picture, unless they were
  /// wider than ImageHeuristics::kImportanceBlur. Unit: samples. Range: >= 1. Source:
  /// docs/notebook/selective.md, "What a preparation costs": as many as told the unit of sums
  /// before; half and double not measured.
  static constexpr std::uint64_t kBrightnessSamples = 4096;

  // -------------------------------------------------------- pilot of techniques
  /// Places on the film with two groups of camera samples each.
  /// Unit: places. Range: a multiple of 16. Source: docs/notebook/selective.md, "Which techniques".
  static constexpr std::uint64_t kPilotPlaces = 1024;
  /// Unit: samples. Range: >= 2. Source: the same; half and double not measured.
  static constexpr std::uint32_t kSamplesOfGroup = 2;
  /// Techniques with fewer rays are taken unless the error of others in the same time is less by
  /// this factor.
  /// Unit: error over error. Range: >= 1. Source: docs/notebook/selective.md, "Which techniques".
  static constexpr double kClearlyFaster = 1.05;
  // -------------------------------------------------------- pilot of the division
  /// Camera samples of a whole picture that tell enough about it: a small picture tells as much as
  /// others by more samples of each pixel.
  /// Unit: samples. Range: > 0. Source: 1e1ec69, with the bounds that follow: with 4 per pixel at
  /// 96x72, halves on torus-in-glass expect 0.4 to 1.3 of chains, with 12 (as many as there are
  /// now, rounded to replicates) 0.3 to 0.6.
  static constexpr std::uint64_t kPilotSamples = 65536;
  /// Unit: samples per pixel. Range: >= 2. Source: the same.
  static constexpr std::uint64_t kFewestOfPixel = 4;
  /// Unit: samples per pixel. Range: >= kFewestOfPixel. Source: docs/notebook/selective.md, "Half
  /// and double": without it the pilot of 32x32 pixels has a third of 192 samples.
  static constexpr std::uint64_t kMostOfPixel = 16;
  /// Threshold of Russian roulette, below which paths survive in proportion to what they carry. Its
  /// noise counts in the few samples of a pilot; this threshold keeps about one path per sample.
  /// Unit: brightness. Range: > 0. Source: 3ed3aa3: at 1, roulette is a third of the variance on
  /// cornell-box.
  static constexpr double kPilotRoulette = 0.25;

  // -------------------------------------------------------- what mutations are worth
  /// C, before the render shows it: what a chain's mutations leave over what as many independent
  /// samples of its light would. Chains on trial showed 5 to 32; what follows from that is what
  /// follows from 10.
  /// Unit: variance over variance. Range: >= 1. Source: docs/notebook/selective.md, "Without a
  /// trial of chains".
  static constexpr double kCorrelation = 10.0;
  /// Chains of some scenes cluster more than of others, they turn out worse in the end, and what
  /// they leave are blotches, which the eye sees more easily than noise of the same variance. C is
  /// so many times as high where it is asked whether they pay.
  /// Unit: factor. Range: >= 1. Source: docs/notebook/selective.md, "Without a trial of chains":
  /// about 2 for the first, 2 for the second, 2.5 (C through 3x3 pixels) for the third. With 4, the
  /// halves of one render in eight of door-ajar disagree.
  static constexpr double kCostFactor = 8.0;

  // -------------------------------------------------------- what things cost before it is measured
  /// Unit: rays. Range: > 0. Source: docs/notebook/chains.md, "Steps, and what they are worth": 4.3
  /// to 5.3 on door-ajar.
  static constexpr double kRaysPerMutation = 4.5;
  /// Tries of manifold connections, by which chains of explicit paths are found.
  /// Unit: per camera sample. Range: > 0. Source: docs/notebook/mutations.md, "How many manifold
  /// connections are tried".
  static constexpr double kManifoldTries = 1.0 / 128.0;
  /// The part of a camera sample's rays that one light subpath has.
  /// Unit: share. Range: (0, 1). Source: docs/notebook/selective.md, "Half and double": 0.26 to
  /// 0.61 of the rays of `bdpt`. The time of a preparation follows from it, no picture.
  static constexpr double kEffortOfLight = 0.5;

  // -------------------------------------------------------- number of chains
  //
  // Many chains are well spread, but each begins a pass by looking up its state. What is found by
  // luck brings much at a time, and many chains would all begin with it, none of them getting far.
  // Small pictures have more, down to one step, because few chains depend on luck, too.

  /// Steps that a chain makes in a short pass, if it starts from what was found.
  /// Unit: steps. Range: >= 1. Source: docs/notebook/chains.md, "Recruits": with half as many
  /// chains FLIP is 0.258 instead of 0.264 on pool, 0.070 instead of 0.066 on torus-in-glass; with
  /// about twice as many 0.282 to 0.298 and 0.064 to 0.065. Finished pictures are alike within a
  /// quarter and four times as many (docs/notebook/selective.md, "Tried and left").
  static constexpr std::uint64_t kStepsOfChain = 144;
  /// Unit: chains of a replicate. Range: >= 1. Source: docs/notebook/selective.md, "Half and
  /// double": half and double tell nothing, but with 1 the error of blotches on door-ajar is 1.16
  /// of what it was.
  static constexpr std::uint64_t kFewestChains = 32;
  /// Mutations expected to pay in a picture all of whose light is the chains'. There are as many
  /// chains as if so many paid, as long as they do not take much memory: few of them, for what
  /// there is to explore, leave islands of light to luck for the rest of the render. And it is the
  /// first guess of the effort: until more is known of the strongest paths, more mutations than are
  /// worth their seeds would only repeat what the pilot happened to find. Unit: mutations per pixel
  /// and sample. Range: > 0. Source: 65ab297: torus-in-glass had 128 chains where 768 left 0.87 of
  /// the error; e243d5c for the first guess.
  static constexpr double kExpectedMutations = 3.0;
  /// Upper bound of that rule.
  /// Unit: chains of a replicate. Range: >= kFewestChains. Source: ccdfc72, for memory.
  static constexpr std::uint64_t kMostExpectedChains = 8192;

  // -------------------------------------------------------- seeds
  /// What chains make of a picture is at least this share of it, as far as memory is concerned.
  /// Unit: share of the brightness. Range: (0, 1]. Source: docs/notebook/selective.md, "Half and
  /// double": 0 to twice as much leave the same errors, so it bounds memory alone.
  static constexpr double kLeastShareOfChains = 0.02;

  // -------------------------------------------------------- effort, as the render goes on
  /// Bound on mutations, and 1 over this the other: neither estimator starves.
  /// Unit: mutations per pixel and sample. Range: (0, 1). Source: 5b5c42c: four times as many cost
  /// pictures in which nothing is hard.
  static constexpr double kFewestMutations = 1.0 / 128;
  // -------------------------------------------------------- how chains move
  /// Probability of a step that makes the whole path afresh.
  /// Unit: probability. Range: (0, 1]. Source: docs/notebook/chains.md, "Steps, and what they are
  /// worth": seeds are joined all the time, so few are needed.
  static constexpr double kLargeSteps = 0.1;
  /// Share of the other steps that have 1/8 or 1/64 of their length, for light that is found in
  /// narrow places.
  /// Unit: share. Range: [0, 1]. Source: docs/notebook/chains.md, "Steps, and what they are worth".
  static constexpr double kFineSteps = 0.2;
  /// Share of small steps that move the place on the picture alone, where `raster-steps` is auto.
  /// Unit: share. Range: [0, 1]. Source: docs/notebook/chains.md, "Steps, and what they are worth":
  /// 0.5 and 0.9 are worse by a few percent on pool and level on torus-in-glass.
  static constexpr double kRasterSteps = 0.7;
  /// Share of small steps on the raster where what chains make has no islands that only other steps
  /// would lead to. Elsewhere it is kRasterSteps.
  /// Unit: share. Range: [0, 1]. Source: docs/notebook/chains.md, "Steps, and what they are worth":
  /// better than 0.7 by 4 to 12 % where T is 0.2, a third worse on pool.
  static constexpr double kRasterStepsOfAllLight = 0.9;
  /// Threshold up to which that is so.
  /// Unit: brightness. Range: >= 0. Source: the same; a value of kThresholds.
  static constexpr double kNearlyAllLight = 0.3;
};

}  // namespace ajar
