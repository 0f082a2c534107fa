#include "scene/texture/noise.h"

#include <array>
#include <cstdint>

#include "scene/texture/mapping.h"

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

int permuted(int i) { return kPermutation[static_cast<std::size_t>(i & 255)]; }

/// Dot product of (x, y, z) with one of the twelve edge directions of a cube, chosen by the cell.
float gradient(int ix, int iy, int iz, float x, float y, float z) {
  // The sums may pass 255 and wrap; Perlin's doubled table says the same.
  const int h = permuted(permuted(permuted(ix) + iy) + iz) & 15;
  const float u = (h < 8 || h == 12 || h == 13) ? x : y;
  const float v = (h < 4 || h == 12 || h == 13) ? y : z;
  return ((h & 1) != 0 ? -u : u) + ((h & 2) != 0 ? -v : v);
}

float fade(float t) { return t * t * t * (t * (t * 6.F - 15.F) + 10.F); }
float mix(float t, float a, float b) { return a + t * (b - a); }

}  // namespace

float noise(const Vec3& p) {
  if (!is_finite(p)) return 0.F;
  const Vec3 cell(std::floor(p.x), std::floor(p.y), std::floor(p.z));
  const float x = p.x - cell.x;
  const float y = p.y - cell.y;
  const float z = p.z - cell.z;
  const int ix = floor_to_int(cell.x) & 255;
  const int iy = floor_to_int(cell.y) & 255;
  const int iz = floor_to_int(cell.z) & 255;
  const float wx = fade(x);
  const auto along_x = [&](int dy, int dz) {
    const float y_offset = y - static_cast<float>(dy);
    const float z_offset = z - static_cast<float>(dz);
    return mix(wx, gradient(ix, iy + dy, iz + dz, x, y_offset, z_offset),
               gradient(ix + 1, iy + dy, iz + dz, x - 1.F, y_offset, z_offset));
  };
  const float wy = fade(y);
  const float near = mix(wy, along_x(0, 0), along_x(1, 0));
  const float far = mix(wy, along_x(0, 1), along_x(1, 1));
  return mix(fade(z), near, far);
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
