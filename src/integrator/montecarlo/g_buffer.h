#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/film.h"
#include "image/identities.h"
#include "transport/path_vertex.h"

namespace ajar {

/// Layers of the first surface that a camera ray meets, selected by the names that a film has.
class GBuffer {
 public:
  /// Names of all its layers.
  static std::span<const std::string> names();
  /// Specs of the requested layers, and of their divisor if requested; `scene_size` is a typical
  /// distance.
  static std::vector<LayerSpec> layers(std::span<const std::string> asked_for, float scene_size);

  explicit GBuffer(const Film& film);
  /// True if the film has none of the layers.
  bool empty() const { return empty_; }
  /// Adds the vertex at the end of the camera ray of sample `sample`; `hit` is null inside a
  /// medium. `weight` is the sample's filter weight.
  void add(Film& film, Vec2i pixel, float weight, std::uint64_t sample, float distance,
           const PathVertex& vertex, const Hit* hit) const;
  /// Adds a camera ray that meets nothing.
  void add_nothing(Film& film, Vec2i pixel, std::uint64_t sample) const;

 private:
  enum Layer { kAlbedo, kNormal, kGeometricNormal, kDepth, kPosition, kCoverage, kAlpha, kCount };
  std::array<int, kCount> index_;
  IdentityLayers object_ids_;
  IdentityLayers instance_ids_;
  IdentityLayers material_ids_;
  bool empty_ = true;
};

}  // namespace ajar
