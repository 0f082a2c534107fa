#pragma once
#include <cstdint>

namespace ajar {

/// Probabilities and sizes of moves in path space, beside parameters, which declare their own
/// ranges. No picture's expectation depends on them, but for `kReturnTolerance`,
/// `kConstraintTolerance` and `kSeparationTolerance`: too large, they confuse chains, and detailed
/// balance, or the weight of a seed, fails there.
struct PathSpaceHeuristics {
  /// Probability of a bidirectional mutation to replace the whole path.
  /// Unit: probability. Range: (0, 1). Source: docs/notebook/mutations.md, "Half and double of
  /// other numbers": double may be a twentieth better.
  static constexpr double kWholePath = 0.1;
  /// Weight of replacing no vertex, only an edge; r > 1 vertices have 2^−(r+1).
  /// Unit: weight. Range: > 0. Source: Veach 1997, 11.4.2.1.
  static constexpr double kNoVertex = 0.25;
  /// Weight of replacing one vertex.
  /// Unit: weight, as above. Range: > 0. Source: Veach 1997, 11.4.2.1.
  static constexpr double kOneVertex = 0.5;
  /// Weight of keeping the depth.
  /// Unit: weight. Range: > 0. Source: Veach 1997, 11.4.2.2.
  static constexpr double kSameDepth = 0.5;
  /// Weight of one edge more, and of one edge less.
  /// Unit: weight, as above. Range: > 0. Source: Veach 1997, 11.4.2.2.
  static constexpr double kNextDepth = 0.15;
  /// Weight of j > 1 edges more or less, times 2^−j.
  /// Unit: weight, as above. Range: > 0. Source: Veach 1997, 11.4.2.2.
  static constexpr double kOtherDepth = 0.2;
  /// Largest change of depth.
  /// Unit: edges. Range: >= 2. Source: set by hand: one in 2^20.
  static constexpr int kMostEdgesAtOnce = 20;
  /// Perturbations move places on the film by no less than this.
  /// Unit: pixels. Range: > 0. Source: Veach 1997, 11.4.3.1.
  static constexpr double kSmallestRasterMove = 0.1;
  /// And by no more than the radius of a disc of this size.
  /// Unit: share of the image's area. Range: (0, 1]. Source: Veach 1997, 11.4.3.1.
  static constexpr double kLargestRasterDisc = 0.05;
  /// Perturbations between two specular chains turn directions by no less than this.
  /// Unit: radians. Range: > 0. Source: Veach 1997, 11.4.3.3.
  static constexpr double kSmallestTurn = 0.0001;
  /// And by no more than this.
  /// Unit: radians. Range: (0, π). Source: Veach 1997, 11.4.3.3.
  static constexpr double kLargestTurn = 0.1;
  /// Caustic perturbations turn directions by no more, however near the light is to where it falls.
  /// Unit: radians. Range: (0, π/2). Source: as of `kWholePath`: half makes no difference.
  static constexpr double kWidestTurn = 1.0;
  /// Perturbations move offset normals of glossy vertices by no less than this.
  /// Unit: radius of a disc of normals over which their light would spread evenly; of microfacets
  /// about their roughness. Range: > 0. Source: set by hand, no study.
  static constexpr double kSmallestOffsetMove = 0.01;
  /// And by no more than this.
  /// Unit: the same. Range: > kSmallestOffsetMove. Source: docs/notebook/mutations.md, "How often
  /// half vectors move": half may be a tenth better, double makes no difference that two seeds
  /// show.
  static constexpr double kLargestOffsetMove = 1.0;
  /// Tolerance of a reverse manifold walk at each vertex, beside the error that the tolerance of
  /// walks causes.
  /// Unit: share of the longest move of a vertex, or of the shortest edge if that is less. Range:
  /// (0, 1). Source: docs/notebook/mutations.md, "When a walk back counts": half and double make
  /// next to no difference. Other solutions are about as far as the move, but at the borders of
  /// caustics, where the sign of a determinant tells them apart.
  static constexpr double kReturnTolerance = 0.001;
  /// Nor does one if that tolerance makes more than this of it: then it cannot be told. At the
  /// borders of caustics it grows without bound.
  /// Unit: the same share. Range: (0, 1). Source: as above: in pool half refuses seven of a
  /// hundred moves more, and double seven fewer. In pictures of 2000 pixels it is about this of the
  /// smallest moves.
  static constexpr double kConstraintTolerance = 0.5;
  /// Largest error by the tolerance of walks for which a manifold connection accepts a chain: it
  /// has to be recognised when it is found again. Others are left to unidirectional hits.
  /// Unit: share of the shortest edge after the first. Range: (0, 1). Source: set by hand: in
  /// water-caustic walks come to a chain again within 1e-4, and to no other within 6e-3.
  static constexpr double kSeparationTolerance = 0.001;
  /// Clearance where no ray can run into the light: other chains are left out. Two that become one
  /// at the border of a caustic are told apart by the sign of a determinant in any case.
  /// Unit: the same share. Range: [kSeparationTolerance, 1). Source: docs/notebook/mutations.md,
  /// "Seeds of what no connection makes": in waves, 0.3 % of the light are left out; with
  /// kSeparationTolerance it would be 3 %. With ten times as much it is less than can be told, but
  /// single seeds bring a seventh of all.
  static constexpr double kClearOfPoints = 0.01;
  /// Least angle between its guesses and the straight line, or a photon; log-uniform above.
  /// Unit: radians; from outside of the scene, over π, times twice the angle of its radius from
  /// there; from infinity, over π, times its diameter. Range: (0, π). Source:
  /// docs/notebook/mutations.md, "Seeds of what no connection makes": ten times are worse, if one
  /// seed can be trusted; of less, no study.
  static constexpr double kSmallestGuess = 1e-4;
  /// Probability of a guess to follow photons.
  /// Unit: probability. Range: [0, 1). Source: as above: without them the same error takes nine
  /// times as long; half as many make no difference that one seed shows, nearly all are worse.
  static constexpr float kGuessesByPhotons = 0.9F;
  /// Photons that are traced for that, of all lights.
  /// Unit: photons. Range: >= 0. Source: as above: half makes no difference; of double, no study.
  static constexpr std::uint64_t kPhotons = 1 << 17;
  /// Least number of photons in the smallest cell that guesses choose from.
  /// Unit: photons. Range: >= 1. Source: as above: half and double make no difference.
  static constexpr int kFewestPhotons = 8;
  /// Photons do not follow longer chains.
  /// Unit: vertices. Range: >= 1. Source: set by hand, no study.
  static constexpr int kLongestOfPhotons = 16;
  /// Guesses before Russian roulette may end the search for a chain that is to be found again; from
  /// then on it may at each doubling.
  /// Unit: guesses, a power of 2. Range: >= 1. Source: set by hand: a second, which one of 20 000
  /// counts takes in water-caustic.
  static constexpr std::uint64_t kSureGuesses = 1 << 16;
  /// Probability to go on.
  /// Unit: probability. Range: (0, 1/2): at half, chains that are hardly ever found would take
  /// without end. Source: set by hand: a chain that is never found takes half as long again on
  /// average.
  static constexpr double kGuessesGoOn = 0.25;
};

}  // namespace ajar
