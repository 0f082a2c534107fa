#pragma once
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace ajar {

/// Light that came through specular chains, and its first vertices: guesses for manifold
/// connections. Deterministic for a scene. Traced on first use, by rays that are not counted;
/// thread-safe.
class SpecularPhotons {
 public:
  /// `scene` must outlive it.
  explicit SpecularPhotons(const Scene& scene) : scene_(scene) {}

  /// The first vertex of a chain of this light that fell near `p`: of any in the smallest cell
  /// around it, of those that are made by halving the scene, that has some. `u` in [0, 1) is
  /// uniform. Empty if hardly any fell at all.
  std::optional<Vec3> near(const Light& light, const Vec3& p, float u) const;

 private:
  struct Photon {
    std::uint64_t place;  ///< where it fell, as a Morton code
    Vec3 first;
  };
  void trace() const;
  std::uint64_t code(const Vec3& p) const;

  const Scene& scene_;
  mutable std::once_flag traced_;
  mutable std::vector<std::vector<Photon>> by_light_;  ///< in the order of their places
};

}  // namespace ajar
