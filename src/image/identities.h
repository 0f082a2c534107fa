#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "image/film.h"
#include "image/regions.h"

namespace ajar {

/// Identifiers cannot be averaged over the samples of a pixel. So a film keeps those of its first
/// nine samples, one in each channel of three layers, and the majority is taken when it is shown.
/// Every channel is written by one sample, and once: the result is independent of the order of
/// samples, and later samples change nothing.
class IdentityLayers {
 public:
  static constexpr std::uint64_t kSamples = 9;
  /// The layer called `name` and its two parts.
  static std::vector<LayerSpec> specs(const std::string& name);

  IdentityLayers(const Film& film, const std::string& name);
  bool empty() const { return layers_[0] < 0; }
  /// Records the identity that sample `sample` of a pixel saw: from 1, 0 for nothing; exact up to
  /// 2^24 − 2. Only the first nine samples of a pixel are kept.
  void add(Film& film, Vec2i pixel, std::uint64_t sample, std::uint32_t number) const;

  /// Identities that a pixel's samples saw; only those of samples taken are `known`.
  struct Votes {
    std::array<std::uint32_t, kSamples> numbers{};
    std::array<bool, kSamples> known{};
  };
  /// Votes of all pixels, row by row.
  std::vector<Votes> votes(const Film& film) const;

 private:
  static constexpr std::size_t kLayers = kSamples / 3;
  std::array<int, kLayers> layers_{};  // −1 if the film does not have them
};

/// Most frequent number of a pixel's samples, row by row, of the layer called `name`; of several,
/// that of the earliest sample. 0 where most hit nothing, and before the first sample.
std::vector<float> majority_numbers(const Film& film, const std::string& name);

/// Pair of object and material that most samples of a pixel saw, from the layers "object-id" and
/// "material-id", so that no pixel shows one object with the material of another; of several, that
/// of the earliest sample. Raises std::invalid_argument if the film does not have both.
std::vector<PixelIdentity> majority_identities(const Film& film);

}  // namespace ajar
