#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/vector.h"
#include "image/features.h"

namespace ajar {

/// A picture with noise: scene-linear, row by row, RGB interleaved.
struct NoisyPicture {
  Vec2i size{0, 0};
  std::span<const float> colour;
  /// Two pictures of independent samples whose mean it is, if they are known: their difference
  /// shows the noise.
  std::array<std::span<const float>, 2> halves = {};
  /// For previews: a nearly equal, faster filter will do.
  bool roughly = false;
};

/// A filter that takes the noise of rendering out of a picture.
class Denoiser {
 public:
  /// Receives the finished part, in [0, 1], from any thread; false cancels the work.
  using Progress = std::function<bool(double done)>;

  virtual ~Denoiser() = default;
  /// Name and version, which decide the pixels: "oidn 2.5.1".
  virtual std::string name() const = 0;
  /// Memory that a picture of so many pixels takes, bytes; an estimate.
  virtual std::uint64_t memory_bytes(std::uint64_t pixels) const = 0;
  /// Features without noise of their own, as `filter` takes them.
  virtual Features prepare(Vec2i size, Features features) const = 0;
  /// The picture without noise, row by row; empty if `progress` ended it. Values that are not
  /// finite count as 0. Raises std::invalid_argument if sizes do not fit.
  virtual std::optional<std::vector<float>> filter(const NoisyPicture& picture,
                                                   const Features& features,
                                                   const Progress& progress) const = 0;
};

/// Values that are no numbers, or infinite, as 0.
std::vector<float> finite_values(std::span<const float> values);

/// Values of `--denoise`.
std::span<const std::string> denoiser_names();

/// Denoiser by name: null for "none"; "auto" is "oidn" where that is found, else "builtin". Raises
/// UsageError for other names, and for "oidn" where it is not found, saying how to get it. `note`:
/// a remark if "auto" does not find it.
std::shared_ptr<const Denoiser> find_denoiser(const std::string& name, std::string* note = nullptr);

}  // namespace ajar
