#include "core/perlin_noise.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "core/floor_to_int.h"

namespace ajar {

namespace {

// Perlin's own permutation of 0 … 255 (2002).
constexpr std::array<std::uint8_t, 256> kPermutation = {
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103,
    30,  69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,
    197, 62,  94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174,
    20,  125, 136, 171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231,
    83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143,
    54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196,
    135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124,
    123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,
    182, 189, 28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101,
    155, 167, 43,  172, 9,   129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185,
    112, 104, 218, 246, 97,  228, 251, 34,  242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,
    51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,  181, 199, 106, 157, 184, 84,  204, 176,
    115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114, 67,  29,  24,  72,  243,
    141, 128, 195, 78,  66,  215, 61,  156, 180};

constexpr float kLacunarity = 1.99F;

struct Gradient {
  float x, y, z, unused;
};
// The twelve directions to the edges of a cube, four of them twice.
constexpr std::array<Gradient, 16> kGradients = {{{1, 1, 0, 0},
                                                  {-1, 1, 0, 0},
                                                  {1, -1, 0, 0},
                                                  {-1, -1, 0, 0},
                                                  {1, 0, 1, 0},
                                                  {-1, 0, 1, 0},
                                                  {1, 0, -1, 0},
                                                  {-1, 0, -1, 0},
                                                  {0, 1, 1, 0},
                                                  {0, -1, 1, 0},
                                                  {0, 1, -1, 0},
                                                  {0, -1, -1, 0},
                                                  {1, 1, 0, 0},
                                                  {-1, 1, 0, 0},
                                                  {0, 1, -1, 0},
                                                  {0, -1, -1, 0}}};

int permuted(int i) { return kPermutation[static_cast<std::size_t>(i & 255)]; }

/// Dot product of an offset with the direction of a cell's corner.
float slope(int corner, float x, float y, float z) {
  const Gradient& g = kGradients[static_cast<std::size_t>(corner & 15)];
  return g.x * x + g.y * y + g.z * z;
}

float fade(float t) { return t * t * t * (t * (t * 6.F - 15.F) + 10.F); }
float mix(float t, float a, float b) { return a + t * (b - a); }

/// The cell that holds a number, modulo 256, and the place in it. Without calls where that is
/// possible: noise dominates the time of scenes with it.
struct Cell {
  explicit Cell(float v) {
    constexpr float kExact = 0x1p30F;
    if (std::abs(v) < kExact) {
      const auto truncated = static_cast<int>(v);
      index = truncated - (v < static_cast<float>(truncated) ? 1 : 0);
      offset = v - static_cast<float>(index);
    } else {
      index = floor_to_int(v);
      offset = 0.F;
    }
    index &= 255;
  }
  int index;
  float offset;
};

}  // namespace

float noise(const Vec3& p) {
  if (!is_finite(p)) return 0.F;
  const Cell cx(p.x);
  const Cell cy(p.y);
  const Cell cz(p.z);
  const float x = cx.offset;
  const float y = cy.offset;
  const float z = cz.offset;
  const float wx = fade(x);
  const float wy = fade(y);
  // The sums may pass 255 and wrap; Perlin's doubled table says the same.
  const int low = permuted(cx.index) + cy.index;
  const int high = permuted(cx.index + 1) + cy.index;
  const std::array<int, 4> columns = {permuted(low) + cz.index, permuted(high) + cz.index,
                                      permuted(low + 1) + cz.index, permuted(high + 1) + cz.index};
  const auto layer = [&](int dz) {
    const float depth = z - static_cast<float>(dz);
    const auto along_x = [&](std::size_t row, float height) {
      return mix(wx, slope(permuted(columns[row] + dz), x, height, depth),
                 slope(permuted(columns[row + 1] + dz), x - 1.F, height, depth));
    };
    return mix(wy, along_x(0, y), along_x(2, y - 1.F));
  };
  return mix(fade(z), layer(0), layer(1));
}

float fbm(const Vec3& p, float roughness, int octaves) {
  float sum = 0.F;
  float scale = 1.F;
  float amplitude = 1.F;
  for (int i = 0; i < octaves; ++i) {
    sum += amplitude * noise(p * scale);
    scale *= kLacunarity;
    amplitude *= roughness;
  }
  return sum;
}

float turbulence(const Vec3& p, float roughness, int octaves) {
  float sum = 0.F;
  float scale = 1.F;
  float amplitude = 1.F;
  for (int i = 0; i < octaves; ++i) {
    sum += amplitude * std::abs(noise(p * scale));
    scale *= kLacunarity;
    amplitude *= roughness;
  }
  // The first octave left out is replaced by its mean, about 0.2.
  return sum + amplitude * 0.2F;
}

}  // namespace ajar
