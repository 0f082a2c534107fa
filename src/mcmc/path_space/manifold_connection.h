#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "mcmc/path_space/specular_photons.h"
#include "path/manifold_walk.h"

namespace ajar {

/// Joins a point of a light to a vertex by a specular chain. A guess of it, a ray from the light
/// that follows events as they come, walks to the vertex. The chain that it finds is random, with
/// unknown probability; the number of guesses until it is found again is the inverse of that on
/// average. Holds the scratch memory of one thread. Source: Zeltner, Georgiev & Jakob 2020,
/// "Specular manifold sampling for rendering high-frequency caustics and glints", section 4.2; that
/// guesses are rays from the light is ours.
class ManifoldConnection {
 public:
  /// Both must outlive it.
  ManifoldConnection(const Scene& scene, const SpecularPhotons& photons)
      : scene_(scene), photons_(photons), walk_(scene) {}

  /// Ends to be joined, by `most` specular vertices at most.
  struct Ends {
    const Light& light;
    const EndpointPoint& point;  ///< point on the light
    const InnerVertex& seen;
    int most;
  };

  /// Guesses once, by the randomness that `key` names: false if no chain came of it. Neither
  /// visibility of its edges nor emission along them is tested.
  bool find(const Ends& ends, std::uint64_t key);
  /// Chain that was found, in the order from the light, until the next call.
  std::span<const InnerVertex> chain() const { return walk_.vertices(); }
  /// Estimates 1/p of finding `chain`, which must be clear, each guess counting `discount` times
  /// the one before (`inverse_probability`). By other randomness of `key` than `find`. Long counts
  /// are subject to Russian roulette: 0 if it ends one, and more than the guesses if it does not.
  double inverse_chance(const Ends& ends, std::span<const InnerVertex> chain, double discount,
                        std::uint64_t key);

  /// True if the chain from the light of a path to vertex `seen` is clear of others: walks can tell
  /// it from its neighbours. At the borders of caustics, where two chains merge, it is not. The
  /// clearance is smaller for point lights, as no other technique finds their light.
  static bool is_clear(const Scene& scene, const Path& path, int seen);

  const RayCounts& ray_counts() const { return walk_.ray_counts(); }

 private:
  /// A place for the ray of a guess to pass through.
  Vec3d choose_place(const Ends& ends, SampleSource& source) const;

  const Scene& scene_;
  const SpecularPhotons& photons_;
  ManifoldWalk walk_;
  std::vector<InnerVertex> guessed_;
};

}  // namespace ajar
