#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.h"

namespace ajar::pbrt {

/// pbrt-v4's colour spaces: three primaries and a white.
class ColorSpace {
 public:
  /// "srgb", "dci-p3", "rec2020" or "aces2065-1"; null for others. Lives as long as the program.
  static const ColorSpace* find(std::string_view name);
  static std::vector<std::string> names();
  static const ColorSpace& srgb();

  /// Linear Rec. 709 of light of this colour: (1, 1, 1) has the colour of the white.
  Vec3d light_to_rec709(const Vec3d& rgb) const;
  /// Converts reflectances and absorption: (1, 1, 1) is white whatever the white is, by Bradford's
  /// adaptation.
  Vec3d reflectance_to_rec709(const Vec3d& rgb) const;
  /// XYZ of the white, Y = 1.
  const Vec3d& white() const { return white_; }

 private:
  struct Primaries;
  explicit ColorSpace(const Primaries& primaries);
  static const std::vector<ColorSpace>& all();

  std::string_view name_;
  Vec3d columns_[3];  ///< XYZ of red, green and blue
  Vec3d white_;
};

}  // namespace ajar::pbrt
