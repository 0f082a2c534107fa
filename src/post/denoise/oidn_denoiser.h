#pragma once
#include "post/denoise/denoiser.h"
#include "post/denoise/oidn_library.h"

namespace ajar {

/// Open Image Denoise on the processor: its filter for ray-traced pictures of high dynamic range,
/// with features that it has filtered before (https://www.openimagedenoise.org/documentation.html).
/// The pixels are the same for the same version and processor.
class OidnDenoiser final : public Denoiser {
 public:
  /// Raises std::runtime_error if the library cannot work here.
  explicit OidnDenoiser(std::shared_ptr<const OidnLibrary> library);

  std::string name() const override { return name_; }
  std::uint64_t memory_bytes(std::uint64_t pixels) const override;
  Features prepare(Vec2i size, Features features) const override;
  std::optional<std::vector<float>> filter(const NoisyPicture& picture, const Features& features,
                                           const Progress& progress) const override;

 private:
  std::shared_ptr<const OidnLibrary> library_;
  std::string name_;
};

}  // namespace ajar
