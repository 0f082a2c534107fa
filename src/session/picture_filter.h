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

  /// Adds the layers "denoised", "denoising-albedo" and "denoising-normal" to a picture, whose
  /// independent parts `replicates` are (less than two: nothing is known of its noise). False, and
  /// no layers, if `progress` ended it.
  bool add_layers(Picture& picture, const Replicates& replicates,
                  const Denoiser::Progress& progress);

 private:
  std::shared_ptr<const Denoiser> denoiser_;
  std::function<Features()> look_;
  std::mutex mutex_;
  std::optional<Features> features_;
  std::optional<Features> prepared_;  ///< for the filter
};

/// The layers of features that the file of a picture has.
inline constexpr const char* kFeatureAlbedo = "denoising-albedo";
inline constexpr const char* kFeatureNormal = "denoising-normal";

}  // namespace ajar
