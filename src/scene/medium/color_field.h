#pragma once
#include <array>
#include <cstdint>

#include "core/spectrum.h"
#include "scene/desc/density_grid.h"
#include "scene/medium/column.h"
#include "scene/medium/lattice.h"

namespace ajar {

/// Coefficients of a medium whose colour varies in a grid, 1/(scene unit). As those of
/// `DensityField`, optical depths are known but for rounding: that of each lane is a cubic
/// polynomial per cell along a ray.
class ColorField {
 public:
  /// `colors` must be free of complaints, and have colours: factors of the coefficients.
  ColorField(const desc::Density& colors, const Spectrum& sigma_a, const Spectrum& sigma_s);

  /// At a point of the world. Lanes that are not 0 everywhere are positive, as those of
  /// `DensityField::at`.
  Spectrum sigma_t(const Vec3& p) const;
  Spectrum sigma_s(const Vec3& p) const;
  /// Along `ray` for `distance`, or until the optical depth of `lane` is `most`. Infinite distances
  /// end where the box does, for the depth.
  Crossing along(const Ray& ray, float distance, int lane, float most) const;
  /// True if there is scattering anywhere.
  bool scatters() const { return !most_sigma_s_.is_black(); }

  /// Memory beside the grid, bytes.
  static std::uint64_t memory(const desc::DensityGrid& grid) { return Bricks::memory(grid); }

 private:
  using Bricks = LatticeBricks<Vec3d>;
  /// A coefficient: `factors` times `unit`, or just that.
  struct Coefficient {
    const std::vector<Vec3>* factors;
    Vec3d unit;
    Vec3d at(std::size_t point) const {
      return factors->empty() ? unit : unit * Vec3d((*factors)[point]);
    }
    Vec3d beyond() const { return factors->empty() ? unit : Vec3d(0.0); }
    Spectrum most() const;
  };

  std::array<Vec3d, 8> extinction(const Lattice::Cell& cell) const;

  desc::DensityGridPointer grid_;
  Lattice lattice_;
  Coefficient sigma_a_, sigma_s_;
  Bricks bricks_;
  Spectrum most_sigma_s_, most_sigma_t_;
};

}  // namespace ajar
