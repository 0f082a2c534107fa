#pragma once
#include "post/denoise/denoiser.h"

namespace ajar {

/// A filter for where no library is: local regressions (local_regression.h) at several scales.
///
/// 1. Demodulates albedo, so that texture is not filtered.
/// 2. Of two independent halves of a picture, each is filtered with the weights of the other. A
///    picture without halves is divided as a chessboard is, and the other squares filled from
///    around.
/// 3. Scales beyond a window are left to the filtered picture of half the size: its light replaces
///    that of the finer one, as far as the halves show, crossed, that it is nearer to the truth.
/// 4. Pixels much brighter than those around are cut for the finest scales, and keep their light
///    for the coarser ones.
///
/// docs/notebook/denoising.md measures it against Open Image Denoise. The same pixels on any
/// threads.
class BuiltinDenoiser final : public Denoiser {
 public:
  std::string name() const override { return "builtin 1"; }
  std::uint64_t memory_bytes(std::uint64_t pixels) const override;
  Features prepare(Vec2i size, Features features) const override;
  std::optional<std::vector<float>> filter(const NoisyPicture& picture, const Features& features,
                                           const Progress& progress) const override;
};

}  // namespace ajar
