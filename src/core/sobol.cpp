#include "core/sobol.h"

#include <array>
#include <bit>
#include <boost/random/sobol.hpp>

#include "core/random.h"

namespace ajar {

namespace {
/// Sums of products instead of shifts and ors: one instruction each on x86.
constexpr std::uint32_t reverse_bits(std::uint32_t v) {
  v = __builtin_bswap32(v);
  v = ((v >> 4U) & 0x0f0f0f0fU) + ((v & 0x0f0f0f0fU) << 4U);
  v = ((v >> 2U) & 0x33333333U) + 4U * (v & 0x33333333U);
  return ((v >> 1U) & 0x55555555U) + 2U * (v & 0x55555555U);
}

/// Owen scrambling of a number whose bits are in reverse order: each bit is flipped depending on
/// the bits below it only. Source: Laine & Karras 2011, in the form and with the constants of N.
/// Vegdahl 2021, "Building a better LK hash".
template <typename Bits>
constexpr Bits scramble_reversed(Bits v, Bits seed) {
  v ^= v * 0x3d20adeaU;
  v += seed;
  v *= (seed >> 16U) | 1U;
  v ^= v * 0x05526c56U;
  v ^= v * 0x53a22864U;
  return v;
}

/// Dimension 1 with its bits reversed. Its generator matrix is Pascal's triangle modulo 2, which is
/// a Kronecker power of a 2 × 2 matrix: one exchange per bit of the bit's position.
constexpr std::uint32_t dimension_1_reversed(std::uint32_t index) {
  index ^= (index & 0xaaaaaaaaU) >> 1U;
  index ^= (index & 0xccccccccU) >> 2U;
  index ^= (index & 0xf0f0f0f0U) >> 4U;
  index ^= (index & 0xff00ff00U) >> 8U;
  index ^= (index & 0xffff0000U) >> 16U;
  return index;
}

/// Contribution of each byte of the index to dimensions 2 and 3, bits reversed.
struct ByteTables {
  std::array<std::array<std::array<std::uint32_t, 256>, 4>, 2> of;
};

/// Reads the direction numbers out of Boost's engine, which walks the points in Gray-code order:
/// the points before and after step 2^k differ by direction number k.
ByteTables make_byte_tables() {
  using Engine = boost::random::sobol_engine<std::uint32_t, 32>;
  ByteTables tables{};
  std::array<std::array<std::uint32_t, 32>, 2> directions{};
  for (unsigned bit = 0; bit < 32; ++bit) {
    std::array<std::array<std::uint32_t, kSobolDimensions>, 2> points{};
    Engine engine(kSobolDimensions);
    // Boost leaves out the origin, so that its first point is the one after step 2^0.
    const std::uint64_t before = (std::uint64_t{1} << bit) - 1;
    if (bit > 0) {
      engine.discard((before - 1) * kSobolDimensions);
      for (std::uint32_t& x : points[0]) x = engine();
    }
    for (std::uint32_t& x : points[1]) x = engine();
    for (int d = 0; d < 2; ++d)
      directions[d][bit] = reverse_bits(points[0][d + 2] ^ points[1][d + 2]);
  }
  for (int d = 0; d < 2; ++d) {
    for (unsigned byte = 0; byte < 4; ++byte) {
      for (unsigned value = 0; value < 256; ++value) {
        for (unsigned bit = 0; bit < 8; ++bit) {
          if (((value >> bit) & 1U) != 0)
            tables.of[d][byte][value] ^= directions[d][8 * byte + bit];
        }
      }
    }
  }
  return tables;
}

std::uint32_t table_dimension_reversed(std::uint32_t index, int dimension) {
  static const ByteTables tables = make_byte_tables();
  const auto& table = tables.of[static_cast<std::size_t>(dimension - 2)];
  return table[0][index & 255U] ^ table[1][(index >> 8U) & 255U] ^ table[2][(index >> 16U) & 255U] ^
         table[3][index >> 24U];
}

std::uint32_t point_reversed(std::uint32_t index, int dimension) {
  if (dimension == 0) return index;
  if (dimension == 1) return dimension_1_reversed(index);
  return table_dimension_reversed(index, dimension);
}

/// Independent 32-bit seeds of one sequence: the shuffle and two coordinates; and two more.
struct Seeds {
  explicit Seeds(std::uint64_t seed) : base(mix_bits(seed + 0x9e3779b97f4a7c15ULL)) {}
  std::uint32_t shuffle() const {
    // A third multiplication instead of a full second hash: the high bits are all this needs.
    return static_cast<std::uint32_t>((base * 0xd6e8feb86659fd93ULL) >> 32U);
  }
  std::uint32_t coordinate(int dimension) const {
    const std::uint64_t bits = dimension < 2 ? base : mix_bits(base);
    return static_cast<std::uint32_t>((dimension & 1) != 0 ? bits >> 32U : bits);
  }
  std::uint64_t base;
};

/// Eight numbers, and four of twice their length, for one vector instruction each: compilers do not
/// see by themselves that the coordinates of four points are eight numbers.
using Lanes [[gnu::vector_size(32)]] = std::uint32_t;
using SignedLanes [[gnu::vector_size(32)]] = std::int32_t;
using FloatLanes [[gnu::vector_size(32)]] = float;
using Bytes [[gnu::vector_size(32)]] = std::uint8_t;
using Hashes [[gnu::vector_size(32)]] = std::uint64_t;

/// Vector form of mix_bits.
Hashes mix_lanes(Hashes v) {
  v ^= v >> 30U;
  v *= 0xbf58476d1ce4e5b9ULL;
  v ^= v >> 27U;
  v *= 0x94d049bb133111ebULL;
  return v ^ v >> 31U;
}

/// Vector form of reverse_bits.
Lanes reverse_lanes(Lanes v) {
  const auto mixed = std::bit_cast<Bytes>(v);
  const Bytes bytes =
      __builtin_shufflevector(mixed, mixed, 3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12,
                              19, 18, 17, 16, 23, 22, 21, 20, 27, 26, 25, 24, 31, 30, 29, 28);
  v = std::bit_cast<Lanes>(bytes);
  v = ((v >> 4U) & 0x0f0f0f0fU) + ((v & 0x0f0f0f0fU) << 4U);
  v = ((v >> 2U) & 0x33333333U) + ((v & 0x33333333U) << 2U);
  return ((v >> 1U) & 0x55555555U) + ((v & 0x55555555U) << 1U);
}

std::uint32_t shuffled(std::uint32_t index, std::uint32_t seed) {
  return reverse_bits(scramble_reversed(reverse_bits(index), seed));
}
}  // namespace

std::uint32_t sobol_bits(std::uint32_t index, int dimension) {
  return reverse_bits(point_reversed(index, dimension));
}

float sobol(std::uint32_t index, int dimension, std::uint64_t seed) {
  const Seeds seeds(seed);
  const std::uint32_t point = point_reversed(shuffled(index, seeds.shuffle()), dimension);
  return to_unit_float(reverse_bits(scramble_reversed(point, seeds.coordinate(dimension))));
}

float sobol_1d(std::uint32_t index, std::uint64_t seed) { return sobol(index, 0, seed); }

Vec2 sobol_2d(std::uint32_t index, std::uint64_t seed) {
  const Seeds seeds(seed);
  const std::uint32_t i = shuffled(index, seeds.shuffle());
  const std::uint32_t x = scramble_reversed(i, seeds.coordinate(0));
  const std::uint32_t y = scramble_reversed(dimension_1_reversed(i), seeds.coordinate(1));
  return {to_unit_float(reverse_bits(x)), to_unit_float(reverse_bits(y))};
}

SobolPads sobol_pads(std::uint32_t index, const std::array<std::uint64_t, kSobolPads>& seeds) {
  // The x of all points, then the y of all, in one vector.
  static_assert(kSobolPads == 4);
  constexpr Lanes kOfY = {0, 0, 0, 0, ~0U, ~0U, ~0U, ~0U};
  Hashes base;
  for (std::size_t k = 0; k < kSobolPads; ++k) base[k] = seeds[k];
  base = mix_lanes(base + 0x9e3779b97f4a7c15ULL);
  const auto halves = std::bit_cast<Lanes>(base);
  const Hashes product = base * 0xd6e8feb86659fd93ULL;
  const auto product_halves = std::bit_cast<Lanes>(product);
  const Lanes scramble = __builtin_shufflevector(halves, halves, 0, 2, 4, 6, 1, 3, 5, 7);
  const Lanes shuffle =
      __builtin_shufflevector(product_halves, product_halves, 1, 3, 5, 7, 1, 3, 5, 7);

  const Lanes reversed = Lanes{} + reverse_bits(index);
  Lanes point = reverse_lanes(scramble_reversed(reversed, shuffle));
  point ^= (point & kOfY & 0xaaaaaaaaU) >> 1U;
  point ^= (point & kOfY & 0xccccccccU) >> 2U;
  point ^= (point & kOfY & 0xf0f0f0f0U) >> 4U;
  point ^= (point & kOfY & 0xff00ff00U) >> 8U;
  point ^= (point & kOfY & 0xffff0000U) >> 16U;
  const Lanes bits = reverse_lanes(scramble_reversed(point, scramble));
  // Vector form of to_unit_float, but signed: there is no vector instruction for unsigned numbers.
  const SignedLanes fractions = std::bit_cast<SignedLanes>(bits) >> 8 & 0xffffff;
  const FloatLanes values = __builtin_convertvector(fractions, FloatLanes) * 0x1p-24F;
  SobolPads pads;
  for (std::size_t k = 0; k < kSobolPads; ++k) pads[k] = {values[k], values[kSobolPads + k]};
  return pads;
}

}  // namespace ajar
