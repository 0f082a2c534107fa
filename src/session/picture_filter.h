#pragma once
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "image/picture.h"
#include "image/statistics.h"
#include "post/denoise/denoiser.h"

namespace ajar {

/// Independent parts of a picture.
struct PictureEstimates {
  Replicates replicates;  ///< of the picture; less than two: nothing is known of its noise
  Replicates others;      ///< of its other estimate (`LayerSpec::instead_of`); may be empty
};

/// Takes the noise out of the pictures of one render. Several threads may use it.
class PictureFilter {
 public:
  /// `features`: of the pictures' pixels; called once, when they are needed.
  PictureFilter(std::shared_ptr<const Denoiser> denoiser, std::function<Features()> features);

  /// Of the filter, with its version.
  std::string name() const { return denoiser_->name(); }
  std::uint64_t memory_bytes(std::uint64_t pixels) const { return denoiser_->memory_bytes(pixels); }
  /// As the scene was looked at.
  const Features& features();

  /// Adds the layers "denoised", "denoising-albedo" and "denoising-normal" to a picture while it is
  /// rendered: the filter of the picture. `estimates`: its own replicates. False, and no layers, if
  /// `progress` ended it.
  bool add_layers(Picture& picture, const PictureEstimates& estimates,
                  const Denoiser::Progress& progress);
  /// The same of a picture that is finished, for three to six times the time: the unfiltered
  /// picture and the filtered pictures of its estimates are mixed as their replicates tell
  /// (`mix_estimates`), and "denoised-error" says how wrong that still is. With less than four
  /// replicates as above.
  bool add_best_layers(Picture& picture, const PictureEstimates& estimates,
                       const Denoiser::Progress& progress);

 private:
  /// For the filter.
  const Features& prepared(Vec2i size);
  void add(Picture& picture, std::vector<float> pixels);

  std::shared_ptr<const Denoiser> denoiser_;
  std::function<Features()> look_;
  std::mutex mutex_;
  std::optional<Features> features_;
  std::optional<Features> prepared_;  ///< for the filter
};

/// Error of "denoised", as far as it is known.
inline constexpr const char* kDenoisedError = "denoised-error";
/// That error as one number, defined as the estimated error of the unfiltered picture is
/// (`RelativeError`): relative, root of the mean square. Empty without that layer.
std::optional<double> denoised_error(const Picture& picture);

/// The layers of features that the file of a picture has.
inline constexpr const char* kFeatureAlbedo = "denoising-albedo";
inline constexpr const char* kFeatureNormal = "denoising-normal";

}  // namespace ajar
