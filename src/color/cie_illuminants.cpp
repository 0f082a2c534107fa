#include "color/cie_illuminants.h"

#include <algorithm>

namespace ajar {
namespace {

struct Illuminant {
  std::string_view name;
  double x, y;
};
constexpr std::array<Illuminant, 16> kIlluminants = {{{"A", 0.44757, 0.40745},
                                                      {"D50", 0.34567, 0.35850},
                                                      {"D65", 0.31271, 0.32902},
                                                      {"acesD60", 0.32168, 0.33767},
                                                      {"F1", 0.31310, 0.33727},
                                                      {"F2", 0.37208, 0.37529},
                                                      {"F3", 0.40910, 0.39430},
                                                      {"F4", 0.44018, 0.40329},
                                                      {"F5", 0.31379, 0.34531},
                                                      {"F6", 0.37790, 0.38835},
                                                      {"F7", 0.31292, 0.32933},
                                                      {"F8", 0.34588, 0.35875},
                                                      {"F9", 0.37417, 0.37281},
                                                      {"F10", 0.34609, 0.35986},
                                                      {"F11", 0.38052, 0.37713},
                                                      {"F12", 0.43695, 0.40441}}};

}  // namespace

const std::array<double, kD65Samples> kD65 = {
    46.6383, 52.0891, 49.9755, 54.6482, 82.7549, 91.4860, 93.4318, 86.6823, 104.865, 117.008,
    117.812, 114.861, 115.923, 108.811, 109.354, 107.802, 104.790, 107.689, 104.405, 104.046,
    100.000, 96.3342, 95.7880, 88.6856, 90.0062, 89.5991, 87.6987, 83.2886, 83.6992, 80.0268,
    80.2146, 82.2778, 78.2842, 69.7213, 71.6091, 74.3490, 61.6040, 69.8856, 75.0870, 63.5927,
    46.4182, 66.8054, 63.3828, 64.3040, 59.4519, 51.9590, 57.4406, 60.3125};

std::optional<Vec3d> illuminant_xyz(std::string_view name) {
  const auto found =
      std::find_if(kIlluminants.begin(), kIlluminants.end(),
                   [&](const Illuminant& illuminant) { return illuminant.name == name; });
  if (found == kIlluminants.end()) return std::nullopt;
  return chromaticity_to_xyz(found->x, found->y);
}

Vec3d chromaticity_to_xyz(double x, double y) { return {x / y, 1.0, (1.0 - x - y) / y}; }

}  // namespace ajar
