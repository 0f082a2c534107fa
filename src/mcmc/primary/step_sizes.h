#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>

#include "transport/sample_source.h"

namespace ajar {

/// Primary numbers per vertex: the slots, filled up to whole pairs.
inline constexpr std::size_t kBlockSize = (static_cast<std::size_t>(Slot::kCount) + 1) / 2 * 2;

/// Length of small steps in each kind of primary number, relative to the mutation's own step.
/// Numbers that choose (a lobe, a light) may need longer steps than those that place; with 0 a
/// number keeps its value until the next large step.
struct StepSizes {
  using Scales = std::array<float, kBlockSize>;
  /// Largest argument of `add_on_unit_circle`. Steps around the whole circle are no use anyway.
  static constexpr float kLargest = 64.F;
  static constexpr Scales ones() {
    Scales scales{};
    for (float& scale : scales) scale = 1.F;
    return scales;
  }

  Scales camera_endpoint = ones();  ///< vertex 0 of the camera subpath: raster, lens
  Scales light_endpoint = ones();   ///< vertex 0 of the light subpath: emission
  Scales inner_vertex = ones();     ///< every other vertex of both
  Scales connection = ones();

  /// Raises std::invalid_argument unless all scales are in [0, kLargest].
  void check() const {
    for (const Scales* kind : {&camera_endpoint, &light_endpoint, &inner_vertex, &connection}) {
      for (const float scale : *kind) {
        if (!(scale >= 0.F && scale <= kLargest)) {
          throw std::invalid_argument("step sizes must be in [0, 64]");
        }
      }
    }
  }
  /// All of them times `factor`, as far as they may go.
  StepSizes times(float factor) const {
    StepSizes result = *this;
    for (Scales* kind : {&result.camera_endpoint, &result.light_endpoint, &result.inner_vertex,
                         &result.connection}) {
      for (float& scale : *kind) scale = std::min(scale * factor, kLargest);
    }
    return result;
  }
  const Scales& scales(Stream stream, int vertex) const {
    if (stream == Stream::Connection) return connection;
    if (vertex > 0) return inner_vertex;
    return stream == Stream::Light ? light_endpoint : camera_endpoint;
  }
};

}  // namespace ajar
