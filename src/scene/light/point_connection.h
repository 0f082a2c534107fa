#pragma once
#include <optional>

#include "scene/endpoint.h"

namespace ajar {

/// Connection from `reference` to an endpoint at one point; `intensity(w)` is its emission in unit
/// direction w. Empty if that is black or `reference` is too near for a finite weight.
template <typename Intensity>
std::optional<ConnectionSample> connect_to_point(const Vec3& position, const Vec3& reference,
                                                 const Intensity& intensity) {
  const Vec3 d = position - reference;
  const float squared = length_squared(d);
  if (!(squared > 0.F)) return std::nullopt;
  const float distance = std::sqrt(squared);
  const Vec3 w = d / distance;
  const Spectrum weight = intensity(-w) / squared;
  if (weight.is_black() || !weight.is_finite()) return std::nullopt;
  return ConnectionSample{EndpointPoint::at(position), w, distance, weight,
                          Pdf<VertexMeasure>(1.F)};
}

}  // namespace ajar
