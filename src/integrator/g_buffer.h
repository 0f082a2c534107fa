#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "image/film.h"
#include "transport/path_vertex.h"

namespace ajar {

/// The layers that describe the first surface a camera ray sees. Which of them a film has is
/// decided by name.
class GBuffer {
 public:
  /// Names of all its layers.
  static std::span<const std::string> names();
  /// Specs of those layers that are asked for; `scene_size` is a typical distance.
  static std::vector<LayerSpec> layers(std::span<const std::string> asked_for, float scene_size);

  explicit GBuffer(const Film& film);
  /// True if the film has none of the layers.
  bool empty() const { return empty_; }
  /// Adds the vertex at the end of a camera ray. Identifiers cannot be averaged: they are those of
  /// the first sample only
  /// (`first_sample`). `weight` is the sample's filter weight.
  void add(Film& film, Vec2i pixel, float weight, bool first_sample, float distance,
           const PathVertex& vertex, const Hit* hit) const;

 private:
  enum Layer {
    kAlbedo,
    kNormal,
    kGeometricNormal,
    kDepth,
    kPosition,
    kObjectId,
    kMaterialId,
    kCount
  };
  std::array<int, kCount> index_;
  bool empty_ = true;
};

}  // namespace ajar
