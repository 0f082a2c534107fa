#include "import/pbrt/sky_image.h"

#include <algorithm>
#include <cmath>

#include "color/daylight.h"
#include "core/spectrum.h"
#include "core/sphere_mapping.h"

namespace ajar::pbrt {
namespace {

/// Σ luminance · weight(cos θ) · solid angle.
template <typename Weight>
double weighted_sum(const LinearImage& latitudes, const Weight& weight) {
  constexpr double kTau = 6.283185307179586;
  double sum = 0.0;
  for (int y = 0; y < latitudes.height; ++y) {
    const double theta = 0.5 * kTau * (y + 0.5) / latitudes.height;
    double row = 0.0;
    for (int x = 0; x < latitudes.width; ++x) {
      const Vec3& color = latitudes.at(x, y);
      row += static_cast<double>(luminance(Spectrum(color.x, color.y, color.z)));
    }
    sum += row * std::sin(theta) * weight(std::cos(theta));
  }
  return sum * (kTau / latitudes.width) * (0.5 * kTau / latitudes.height);
}

}  // namespace

LinearImage rows_of_latitude(const LinearImage& equal_area) {
  // Averages of so many places along each side of a texel keep the light of small lamps.
  constexpr int kPlaces = 4;
  const int n = equal_area.width;
  LinearImage result{2 * n, n, equal_area.is_8_bit, {}};
  result.texels.reserve(equal_area.texels.size() * 2);
  const auto seen = [&](float u, float v) {
    const Vec2 place = equal_area::to_uv(lat_long::to_direction({u, v}));
    const auto texel = [&](float x, int size) {
      return std::min(static_cast<int>(x * static_cast<float>(size)), size - 1);
    };
    return equal_area.at(texel(place.x, n), texel(place.y, equal_area.height));
  };
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      Vec3 sum(0.F);
      for (int i = 0; i < kPlaces * kPlaces; ++i) {
        const auto along = [&](int pixel, int place, int size) {
          return (static_cast<float>(pixel) +
                  (static_cast<float>(place) + 0.5F) / static_cast<float>(kPlaces)) /
                 static_cast<float>(size);
        };
        sum += seen(along(x, i % kPlaces, result.width), along(y, i / kPlaces, result.height));
      }
      result.texels.push_back(sum / static_cast<float>(kPlaces * kPlaces));
    }
  }
  return result;
}

LinearImage clear_sky(float turbidity, float elevation, float scale) {
  LinearImage result{512, 256, false, {}};
  const SunnySky sky(turbidity, elevation);
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      const Vec2 place((static_cast<float>(x) + 0.5F) / static_cast<float>(result.width),
                       (static_cast<float>(y) + 0.5F) / static_cast<float>(result.height));
      result.texels.push_back(Vec3(sky.color(Vec3d(lat_long::to_direction(place)))) * scale);
    }
  }
  return result;
}

double luminance_all_around(const LinearImage& latitudes) {
  return weighted_sum(latitudes, [](double) { return 1.0; });
}
double luminance_from_above(const LinearImage& latitudes) {
  return weighted_sum(latitudes, [](double cosine) { return std::max(cosine, 0.0); });
}

}  // namespace ajar::pbrt
