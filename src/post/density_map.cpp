#include "post/density_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace ajar {

namespace {

constexpr int kOctaves = 4;  ///< on either side of 1
constexpr int kGap = 4;
constexpr int kBar = 10;
constexpr int kGlyphWidth = 4;
constexpr int kGlyphHeight = 5;
constexpr int kLabelLength = 4;

struct Glyph {
  char character;
  std::array<std::string_view, kGlyphHeight> rows;
};
constexpr std::array<Glyph, 4> kGlyphs = {{{'1', {".#.", "##.", ".#.", ".#.", "###"}},
                                           {'4', {"#.#", "#.#", "###", "..#", "..#"}},
                                           {'6', {"##.", "#..", "###", "#.#", "###"}},
                                           {'/', {"..#", "..#", ".#.", "#..", "#.."}}}};
struct Tick {
  float octave;
  std::string_view label;
};
constexpr std::array<Tick, 5> kTicks = {
    {{4.F, "16"}, {2.F, "4"}, {0.F, "1"}, {-2.F, "1/4"}, {-4.F, "1/16"}}};

float place_on_scale(float octave) { return (octave + kOctaves) / (2 * kOctaves); }

class Canvas {
 public:
  explicit Canvas(DensityMap& map) : map_(map) {}
  void set(int x, int y, const Spectrum& color) {
    const auto pixel = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(map_.size.x) +
                            static_cast<std::size_t>(x));
    for (std::size_t c = 0; c < 3; ++c) map_.rgb[pixel + c] = color[c];
  }
  void write(int x, int y, std::string_view text) {
    for (const char character : text) {
      for (const Glyph& glyph : kGlyphs) {
        if (glyph.character == character) draw(x, y, glyph);
      }
      x += kGlyphWidth;
    }
  }

 private:
  void draw(int x, int y, const Glyph& glyph) {
    for (int row = 0; row < kGlyphHeight; ++row) {
      const std::string_view line = glyph.rows[static_cast<std::size_t>(row)];
      for (int column = 0; column < static_cast<int>(line.size()); ++column) {
        if (line[static_cast<std::size_t>(column)] == '#') {
          set(x + column, y + row, Spectrum(0.F));
        }
      }
    }
  }

  DensityMap& map_;
};

}  // namespace

Spectrum density_color(float t) {
  const float s = std::clamp(t, 0.F, 1.F);
  const float lightness = 0.25F + 0.68F * s;
  // Chroma that fits into the gamut: 0.1 at the start and in the middle, 0.16 at the end.
  const float chroma =
      0.1F * (1.F - s) * (1.F - 2.F * s) + 0.4F * s * (1.F - s) + 0.16F * s * (2.F * s - 1.F);
  const float hue = (300.F - 190.F * s) * (kPi / 180.F);
  const float a = chroma * std::cos(hue);
  const float b = chroma * std::sin(hue);
  const float l = lightness + 0.3963377774F * a + 0.2158037573F * b;
  const float m = lightness - 0.1055613458F * a - 0.0638541728F * b;
  const float n = lightness - 0.0894841775F * a - 1.2914855480F * b;
  const float long_cone = l * l * l;
  const float middle_cone = m * m * m;
  const float short_cone = n * n * n;
  return {4.0767416621F * long_cone - 3.3077115913F * middle_cone + 0.2309699292F * short_cone,
          -1.2684380046F * long_cone + 2.6097574011F * middle_cone - 0.3413193965F * short_cone,
          -0.0041960863F * long_cone - 0.7034186147F * middle_cone + 1.7076147010F * short_cone};
}

DensityMap draw_density_map(std::span<const float> visits, const Vec2i& size) {
  constexpr int kShortest = 2 * kGlyphHeight * static_cast<int>(kTicks.size());
  const int height = std::max(size.y, kShortest);
  const int legend = size.x + kGap;
  const int width = legend + kBar + kGap + kLabelLength * kGlyphWidth;
  DensityMap map{{width, height},
                 std::vector<float>(
                     3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 1.F)};
  Canvas canvas(map);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const float value = visits[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                                 static_cast<std::size_t>(x)];
      canvas.set(x, y,
                 value > 0.F ? density_color(place_on_scale(std::log2(value))) : Spectrum(0.F));
    }
  }
  for (int y = 0; y < height; ++y) {
    const float t = 1.F - static_cast<float>(y) / static_cast<float>(height - 1);
    for (int x = legend; x < legend + kBar; ++x) canvas.set(x, y, density_color(t));
  }
  for (const Tick& tick : kTicks) {
    const float y = (1.F - place_on_scale(tick.octave)) * static_cast<float>(height - 1);
    const int top = std::clamp(static_cast<int>(y) - kGlyphHeight / 2, 0, height - kGlyphHeight);
    canvas.write(legend + kBar + kGap, top, tick.label);
  }
  return map;
}

}  // namespace ajar
