#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/spectrum.h"
#include "core/vector.h"
#include "image/develop_scale.h"
#include "image/filter.h"

namespace ajar {

/// A layer accumulated by a film: a name ("direct", "indirect", "albedo", …) and how its sums are
/// made.
struct LayerSpec {
  std::string name;
  bool has_replicates = true;  ///< AOVs that need no error bars keep one sum
  /// Typical magnitude of a contribution; sets the fixed-point quantum (rounded to a power of two).
  double magnitude = 1.0;
  /// True if the channels keep the identities that single samples saw (identities.h) instead of
  /// sums of them.
  bool holds_identities = false;
  /// Name of the layer that this one is a part of: shown as part of it, not by itself.
  std::string part_of{};
  /// Name of the layer that this one is another estimate of: it is no part of the picture, and not
  /// shown.
  std::string instead_of{};
  /// Name of the layer that this one is to be added to so that its splats are as a filter of one
  /// pixel's box would have them, which is what filters of noise want (`add_box_layers`). It is no
  /// part of the picture, and not shown.
  std::string box_of{};

  /// True for layers that add up to the picture.
  bool is_light() const {
    const std::string& whole = part_of.empty() ? name : part_of;
    return instead_of.empty() && box_of.empty() && (whole == "direct" || whole == "indirect");
  }
};

/// The two that every picture is the sum of: light of up to two edges and of longer paths.
std::vector<LayerSpec> light_layers(double magnitude);

/// Appends a layer `box_of` each layer of light, and of those instead of one; none where `filter`
/// is a box of one pixel itself. Camera samples are drawn from the filter, so that pixels have
/// noise of their own; a splat of a wide filter is seen in several, and a filter of noise would
/// take it for light.
void add_box_layers(std::vector<LayerSpec>& layers, const Filter& filter);

/// An image in the making: layers × replicates × pixels × 3 channels, each a 64-bit fixed-point
/// sum. Integer addition is associative, so the sums are the same bits in whatever order threads,
/// passes or machines add. The quantum of a layer is 2^(floor(log2 magnitude) − 24): rounding is
/// 2^-25 of a typical contribution. A single contribution may be 2^30 times the magnitude, and a
/// sum can reach 2^38 times the magnitude before contributions to its pixel are refused.
///
/// Pixel values are unbiased estimates of ∫ h_j(x) L(x) dx with ∫ h_j = 1
/// (docs/methods/notation.md).
class Film {
 public:
  /// `crop`: the pixels that exist, min and max inclusive, within the resolution; `replicates` ≥ 1.
  /// Raises std::invalid_argument for others, and for a layer that is `box_of` none before it.
  Film(Vec2i resolution, const Box2i& crop, const Filter& filter, int replicates,
       std::vector<LayerSpec> layers);

  Vec2i resolution() const { return resolution_; }  ///< full image
  const Box2i& crop() const { return crop_; }       ///< min and max inclusive (Imath convention)
  int width() const { return width_; }              ///< width of the crop
  int height() const { return height_; }
  int replicates() const { return replicates_; }
  std::span<const LayerSpec> layers() const { return layers_; }
  /// Index of the layer with that name; -1 if there is none.
  int layer(std::string_view name) const;
  const Filter& filter() const { return filter_; }

  /// Adds to one pixel (full-image pixel coordinates, inside the crop). For camera samples, whose
  /// raster position was drawn from the pixel's filter (`Filter::sample`); the sample's weight
  /// belongs into `value`. Layers without replicates ignore `replicate`. Thread-safe. Returns false
  /// and adds nothing if the value is not finite or too large to represent.
  bool add(int layer, int replicate, Vec2i pixel, const Spectrum& value);
  /// Adds value · h_j(raster) to every pixel j of the crop whose filter reaches `raster`.
  /// Thread-safe. Returns false if the value or the position is not finite, or a share is too large
  /// for its pixel, which then does not get it. The layer's `box_of`, if there is one, gets what
  /// that is less than value in the pixel at `raster`.
  bool splat(int layer, int replicate, const Vec2& raster, const Spectrum& value);

  /// Σ_j h_j(raster) over the pixels of the crop: how densely camera samples, drawn from the
  /// pixels' filters, lie there; 1 well inside for most filters.
  float coverage(const Vec2& raster) const;

  /// Adds the sums of another film of the same size and number of replicates to the layers that
  /// both have, those named in `except` left out. Raises std::invalid_argument if films or layers
  /// of one name do not fit.
  void add_layers(const Film& other, std::span<const std::string> except);

  /// Sum over replicates of a layer, times `scale`, row by row, 3 floats per pixel (crop size).
  std::vector<float> develop(int layer, const DevelopScale& scale) const;
  /// One replicate; the layer must have replicates.
  std::vector<float> develop_replicate(int layer, int replicate, const DevelopScale& scale) const;

  /// Adds the sums of a film of the same size, replicates and layers, whose magnitudes may differ.
  /// Exact if they do not, or if the other's are larger; else rounded to a quantum of this film.
  /// Sums saturate. Identities are added where this film has none. Raises std::invalid_argument if
  /// the films do not fit.
  void add(const Film& other);

  void clear();
  /// The raw sums, for checkpoints, MPI reduction and tests: layer-major, then replicate, pixel,
  /// channel.
  std::span<std::int64_t> raw() { return sums_; }
  std::span<const std::int64_t> raw() const { return sums_; }
  /// Puts these in the place of all sums; there must be as many.
  void take_raw(std::vector<std::int64_t> sums);
  std::size_t bytes() const { return sums_.size() * sizeof(std::int64_t); }

 private:
  struct Storage {
    std::size_t first;   ///< index of the layer's first sum
    std::size_t stride;  ///< sums from one replicate to the next; 0 without replicates
    double per_quantum;  ///< 1 / quantum
    double quantum;
    int box;  ///< layer that is `box_of` this one; -1 if there is none
  };
  std::size_t index(const Storage& storage, int replicate, int x, int y) const;
  bool add_at(std::size_t first_channel, double per_quantum, const Spectrum& value);
  bool splat_filtered(const Storage& storage, int replicate, const Vec2& raster,
                      const Spectrum& value);
  bool splat_to_pixel(const Storage& storage, int replicate, const Vec2& raster,
                      const Spectrum& value);
  std::vector<float> develop_range(const Storage& storage, int first, int count,
                                   const DevelopScale& scale) const;

  Vec2i resolution_;
  Box2i crop_;
  int width_;
  int height_;
  int replicates_;
  Filter filter_;
  std::vector<LayerSpec> layers_;
  std::vector<Storage> storage_;
  std::vector<std::int64_t> sums_;
};

}  // namespace ajar
