#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "image/statistics.h"
#include "imageio/picture.h"
#include "post/denoise/denoiser.h"

namespace ajar {

/// Independent parts of a picture.
struct PictureEstimates {
  Replicates replicates;  ///< replicates of the picture; less than two: its noise is unknown
  Replicates others;      ///< replicates of its other estimate (`LayerSpec::instead_of`); may be
                          ///< empty
  Replicates boxes{};     ///< replicates of `Picture::for_filters`; may be empty
  std::uint64_t samples = 0;  ///< per pixel
};

/// Takes the noise out of the pictures of one render. Several threads may use it.
class PictureFilter {
 public:
  /// Looks at the scene of the pictures by at least so many rays per pixel (`feature_rays`); empty
  /// if `progress` ended it.
  using Look = std::function<std::optional<Features>(std::uint32_t rays,
                                                     const Denoiser::Progress& progress)>;

  /// `look` is called when features of so many rays are needed and not known, and again if it was
  /// ended.
  PictureFilter(std::shared_ptr<const Denoiser> denoiser, Look look);

  /// Name of the filter, with its version.
  std::string name() const { return denoiser_->name(); }
  /// Memory that a picture of so many pixels takes, bytes; an estimate, of `add_best_layers`.
  std::uint64_t memory_bytes(std::uint64_t pixels) const {
    return memory_bytes(*denoiser_, pixels);
  }
  static std::uint64_t memory_bytes(const Denoiser& denoiser, std::uint64_t pixels);
  /// True if so many are enough for `add_best_layers` to differ from `add_layers`.
  static bool mixes(std::size_t replicates) { return replicates >= 4; }
  /// Finds the features of pictures of that size out now, by the fewest rays. False if `progress`
  /// ended it.
  bool know_features(Vec2i size, const Denoiser::Progress& progress);
  /// Auxiliary buffers of the scene, by the most rays so far; empty if not traced yet.
  Features features();

  /// Adds the layers "denoised", "denoising-albedo" and "denoising-normal" to a picture, such as
  /// one that is still being rendered: what the filter makes of it. False, and no layers, if
  /// `progress` ended it. Filtered is what the picture has `for_filters`.
  bool add_layers(Picture& picture, const Denoiser::Progress& progress = {});
  /// For a finished picture, at up to three times the time: the unfiltered picture and the filtered
  /// pictures of its estimates are mixed by the errors of their halves (`mix_estimates`), and
  /// "denoised-error" is the estimated error of the result. With too few replicates (`mixes`) as
  /// above.
  bool add_best_layers(Picture& picture, const PictureEstimates& estimates,
                       const Denoiser::Progress& progress = {});
  /// Time that `add_best_layers` will take for a picture of that size once its features are traced,
  /// wall clock, seconds: measured, by filtering a small corner of one. `has_others`: as for a
  /// picture with another estimate.
  double expected_seconds(Vec2i size, bool has_others) const;

 private:
  /// Auxiliary buffers by so many rays.
  struct Known {
    std::uint32_t rays = 0;
    Features features;
    Features prepared;  ///< for the filter
  };
  /// Null if `progress` ended it.
  std::shared_ptr<const Known> know(Vec2i size, std::uint32_t rays,
                                    const Denoiser::Progress& progress);
  void add(Picture& picture, const Known& known, std::vector<float> pixels) const;

  std::shared_ptr<const Denoiser> denoiser_;
  Look look_;
  std::mutex mutex_;
  std::shared_ptr<const Known> known_;  ///< latest; null: none
};

/// Error of "denoised", as far as it is known.
inline constexpr const char* kDenoisedError = "denoised-error";
/// `kDenoisedError` as one number, defined as for the unfiltered picture (`RelativeError`):
/// relative, root of the mean square. Empty without that layer.
std::optional<double> denoised_error(const Picture& picture);

/// The layers of features that the file of a picture has.
inline constexpr const char* kFeatureAlbedo = "denoising-albedo";
inline constexpr const char* kFeatureNormal = "denoising-normal";

}  // namespace ajar
