#include "import/pbrt/color_space.h"

#include <ImathMatrix.h>

#include "color/cie_illuminants.h"
#include "color/color.h"

namespace ajar::pbrt {
namespace {

/// Bradford's cone responses, row vectors times this. Source: Lam 1985; ICC.1:2010, annex E.
const Imath::M33d kBradford(0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367,
                            1.0296);

Vec3d adapted(const Vec3d& xyz, const Vec3d& from, const Vec3d& to) {
  const Vec3d cones = xyz * kBradford;
  const Vec3d before = from * kBradford;
  const Vec3d after = to * kBradford;
  return Vec3d(cones.x * after.x / before.x, cones.y * after.y / before.y,
               cones.z * after.z / before.z) *
         kBradford.inverse();
}

}  // namespace

/// Chromaticities x, y. Sources: ITU-R BT.709 and BT.2020, SMPTE EG 432-1 (with D65, as pbrt-v4 has
/// it) and SMPTE ST 2065-1.
struct ColorSpace::Primaries {
  std::string_view name;
  double red[2], green[2], blue[2];
  std::string_view white;
};

const std::vector<ColorSpace>& ColorSpace::all() {
  static const std::vector<ColorSpace> kSpaces = [] {
    constexpr Primaries kPrimaries[] = {
        {"srgb", {0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, "D65"},
        {"dci-p3", {0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, "D65"},
        {"rec2020", {0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, "D65"},
        {"aces2065-1", {0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.077}, "acesD60"}};
    std::vector<ColorSpace> spaces;
    for (const Primaries& primaries : kPrimaries) spaces.push_back(ColorSpace(primaries));
    return spaces;
  }();
  return kSpaces;
}

ColorSpace::ColorSpace(const Primaries& primaries)
    : name_(primaries.name), white_(*illuminant_xyz(primaries.white)) {
  // Each primary, scaled to sum to the white. ACES' green has no Z, its blue a negative Y.
  const auto xyz = [](const double(&xy)[2]) { return Vec3d(xy[0], xy[1], 1.0 - xy[0] - xy[1]); };
  const Vec3d r = xyz(primaries.red);
  const Vec3d g = xyz(primaries.green);
  const Vec3d b = xyz(primaries.blue);
  const Imath::M33d rows(r.x, r.y, r.z, g.x, g.y, g.z, b.x, b.y, b.z);
  const Vec3d amounts = white_ * rows.inverse();
  columns_[0] = r * amounts.x;
  columns_[1] = g * amounts.y;
  columns_[2] = b * amounts.z;
}

const ColorSpace* ColorSpace::find(std::string_view name) {
  for (const ColorSpace& space : all()) {
    if (space.name_ == name) return &space;
  }
  return nullptr;
}

std::vector<std::string> ColorSpace::names() {
  std::vector<std::string> result;
  for (const ColorSpace& space : all()) result.emplace_back(space.name_);
  return result;
}

const ColorSpace& ColorSpace::srgb() { return all().front(); }

Vec3d ColorSpace::light_to_rec709(const Vec3d& rgb) const {
  if (this == &srgb()) return rgb;
  return xyz_to_rgb(columns_[0] * rgb.x + columns_[1] * rgb.y + columns_[2] * rgb.z);
}

Vec3d ColorSpace::reflectance_to_rec709(const Vec3d& rgb) const {
  if (this == &srgb()) return rgb;
  const Vec3d xyz = columns_[0] * rgb.x + columns_[1] * rgb.y + columns_[2] * rgb.z;
  return xyz_to_rgb(adapted(xyz, white_, srgb().white_));
}

}  // namespace ajar::pbrt
