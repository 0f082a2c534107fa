#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/spectrum.h"
#include "core/vector.h"
#include "image/filter.h"

namespace ajar {

/// A layer accumulated by a film: a name ("direct", "indirect", "albedo", …) and how its sums are made.
struct LayerSpec {
  std::string name;
  bool has_replicates = true;  ///< AOVs that need no error bars keep one sum
  /// Typical magnitude of a contribution; sets the fixed-point quantum (rounded to a power of two).
  double magnitude = 1.0;
};

/// An image in the making: layers × replicates × pixels × 3 channels, each a 64-bit fixed-point sum. Integer
/// addition is associative, so the sums are the same bits in whatever order threads, passes or machines add.
/// The quantum of a layer is 2^(floor(log2 magnitude) − 24): rounding is 2^-25 of a typical
/// contribution, and a sum can reach 2^38 times the magnitude before a contribution is refused.
///
/// Pixel values are unbiased estimates of ∫ h_j(x) L(x) dx with ∫ h_j = 1 (METHODS, section 1).
class Film {
 public:
  /// `crop`: the pixels that exist (max exclusive is crop.max; see Box2i use below: min inclusive, max inclusive).
  Film(Vec2i resolution, Box2i crop, const Filter& filter, int replicates, std::vector<LayerSpec> layers);

  Vec2i resolution() const;   ///< full image
  const Box2i& crop() const;  ///< min and max inclusive (Imath convention)
  int width() const;          ///< of the crop
  int height() const;
  int replicates() const;
  std::span<const LayerSpec> layers() const;
  /// Index of the layer with that name; -1 if there is none.
  int layer(std::string_view name) const;
  const Filter& filter() const;

  /// Adds to one pixel (full-image pixel coordinates, inside the crop). For camera samples, whose raster position
  /// was drawn from the pixel's filter (`Filter::sample`). Thread-safe.
  /// Returns false and adds nothing if the value is not finite or too large to represent.
  bool add(int layer, int replicate, Vec2i pixel, const Spectrum& value);
  /// Adds value · h_j(raster) to every pixel j whose filter reaches `raster`. Thread-safe.
  bool splat(int layer, int replicate, const Vec2& raster, const Spectrum& value);

  /// Sum over replicates of a layer, times `scale`, row by row, 3 floats per pixel (crop size).
  std::vector<float> develop(int layer, double scale) const;
  std::vector<float> develop_replicate(int layer, int replicate, double scale) const;

  void clear();
  /// The raw sums, for checkpoints, MPI reduction and tests: layer-major, then replicate, pixel, channel.
  std::span<std::int64_t> raw();
  std::span<const std::int64_t> raw() const;
  std::size_t bytes() const;
};

}  // namespace ajar
