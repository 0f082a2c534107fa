#include "study/report/pixel_code.h"

#include <gtest/gtest.h>
#include <half.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ajar {
namespace {

/// The inverse, written from the header's description as `decode.js` is.
std::vector<std::uint16_t> unpacked(std::span<const float> pixels, std::size_t channels) {
  const std::vector<std::byte> packed = pack_pixels(pixels, static_cast<int>(channels));
  std::vector<std::uint8_t> planes(2 * pixels.size() + 1);
  uLongf size = planes.size();
  EXPECT_EQ(uncompress(planes.data(), &size, reinterpret_cast<const Bytef*>(packed.data()),
                       packed.size()),
            Z_OK);
  EXPECT_EQ(size, 2 * pixels.size());
  const std::size_t count = pixels.size() / channels;
  std::vector<std::uint16_t> bits(pixels.size());
  for (std::size_t channel = 0; channel < channels; ++channel) {
    std::uint16_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint8_t* plane = planes.data() + 2 * count * channel;
      const int folded = plane[i] | plane[count + i] << 8;
      value = static_cast<std::uint16_t>(value + ((folded >> 1) ^ -(folded & 1)));
      bits[i * channels + channel] = value;
    }
  }
  return bits;
}

float from_bits(std::uint16_t bits) {
  half value;
  value.setBits(bits);
  return value;
}

TEST(PixelCode, KeepsEveryHalf) {
  std::vector<float> all(3 * 65536);
  for (std::size_t i = 0; i < all.size(); ++i) {
    // A stride prime to 2^16, so that all differences of either sign occur.
    all[i] = from_bits(static_cast<std::uint16_t>(i * 40503));
  }
  const auto bits = unpacked(all, 3);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::isnan(all[i])) {
      EXPECT_TRUE(std::isnan(from_bits(bits[i])));
    } else {
      ASSERT_EQ(bits[i], static_cast<std::uint16_t>(i * 40503));
    }
  }
}

TEST(PixelCode, RoundsToWithinHalfAStep) {
  std::vector<float> values;
  for (int i = 0; i <= 1485; ++i)
    values.push_back(1e-4F * std::pow(1.0137F, static_cast<float>(i)));
  const auto bits = unpacked(values, 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(from_bits(bits[i]), values[i], values[i] / 2048);
  }
}

TEST(PixelCode, DistinguishesNanFromOverflow) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const std::vector<float> values{1e30F, -1e30F, kInfinity, -kInfinity, std::nanf(""), -0.F};
  const auto bits = unpacked(values, 1);
  EXPECT_EQ(from_bits(bits[0]), 65504.F);
  EXPECT_EQ(from_bits(bits[1]), -65504.F);
  EXPECT_EQ(from_bits(bits[2]), kInfinity);
  EXPECT_EQ(from_bits(bits[3]), -kInfinity);
  EXPECT_TRUE(std::isnan(from_bits(bits[4])));
  EXPECT_EQ(bits[5], 0x8000);
}

}  // namespace
}  // namespace ajar
