#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/vector.h"

namespace ajar {

/// Number of dimensions of one Sobol' pad.
inline constexpr int kSobolDimensions = 4;

/// Coordinate `dimension` (0 … 3) of point `index` of a randomised Sobol' sequence, in [0, 1).
///
/// Each seed is its own random sequence: the order of the points is shuffled and the coordinates
/// are Owen-scrambled, both by nested hashing. Any aligned block of 2^k indices is a digital net
/// with the sequence's quality (dimensions 0 and 1: a (0, k, 2)-net), and each point alone is
/// uniform, so that estimates are unbiased over seeds. Points for more than four dimensions are
/// *padded*: use another seed for each pair of numbers that belong together. Seeds need not be
/// hashed by the caller. Source: Burley 2020, "Practical hash-based Owen scrambling".
float sobol(std::uint32_t index, int dimension, std::uint64_t seed);

/// Dimension 0 of the sequence of `seed`: a scrambled van der Corput sequence.
float sobol_1d(std::uint32_t index, std::uint64_t seed);
/// Dimensions 0 and 1 of the sequence of `seed`.
Vec2 sobol_2d(std::uint32_t index, std::uint64_t seed);
/// All pads of a path vertex at once: point k is sobol_2d(index, seeds[k]), several times faster.
inline constexpr std::size_t kSobolPads = 4;
using SobolPads = std::array<Vec2, kSobolPads>;
SobolPads sobol_pads(std::uint32_t index, const std::array<std::uint64_t, kSobolPads>& seeds);

/// Point `index` of the plain Sobol' sequence as a 32-bit fraction, neither shuffled nor scrambled
/// (for tests and for building other randomisations). Point 0 is the origin.
std::uint32_t sobol_bits(std::uint32_t index, int dimension);

}  // namespace ajar
