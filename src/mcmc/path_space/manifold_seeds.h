#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "mcmc/path_space/growing_path.h"
#include "mcmc/path_space/manifold_connection.h"
#include "mcmc/path_space/path_bounds.h"

namespace ajar {

/// Seeds of chains for paths that only unidirectional hits sample (`is_hit_only`): the
/// vertices of a subpath from the camera that are not specular, but follow upon one that is, are
/// joined to a light by a manifold connection. Holds the scratch memory of one thread.
class ManifoldSeeds {
 public:
  /// Scene and photons must outlive it. `tries`: how often it is tried for each subpath from the
  /// camera that may run into a light.
  ManifoldSeeds(const Scene& scene, const SpecularPhotons& photons, const PathBounds& bounds,
                double tries)
      : scene_(scene),
        bounds_(bounds),
        tries_(tries),
        growing_(scene, bounds_.area),
        connection_(scene, photons) {}

  /// A path, and ln of a factor of its f, such that the sum over all paths of one try, each times
  /// its `inverse_chance`, has the mean ∫ f · (1 − w) at this place of the film: w is the mean of
  /// `hit_share`. `key` names the random numbers for that.
  struct Seed {
    Path path;
    double log_factor;
    double least_hit_share;
    std::uint64_t key;
  };
  /// All that a try at this place makes; valid until the next one.
  std::span<const Seed> sample(SampleSource& source, const Vec2& raster, std::uint64_t key);
  /// On average 1/(w₀ + (1 − w₀) P), P being the probability with which the chain at the light of a
  /// seed is found between its ends, and w₀ its `least_hit_share`.
  double inverse_chance(const Seed& seed);
  /// The MIS weight w = w₀/(w₀ + (1 − w₀) P) on average, by the balance heuristic, of running into
  /// the light as against this. P is unknown: it is estimated by guesses, whose randomness `key`
  /// names. 1 for paths that are not of the kind.
  double hit_share(const Path& path, std::uint64_t key);

  /// w₀: that weight, as against `tries` of this, if the chain were certain to be found. A function
  /// of the path alone.
  static double least_hit_share(const Scene& scene, const Path& path, double tries);
  /// True if this can find the path.
  static bool finds(const Scene& scene, const Path& path);

  RayCounts ray_counts() const;

 private:
  void join(SampleSource& source, std::uint64_t key);
  double inverse_chance(const Path& path, double least_hit_share, std::uint64_t key);

  const Scene& scene_;
  PathBounds bounds_;
  double tries_;
  GrowingPath growing_;
  ManifoldConnection connection_;
  std::vector<Seed> seeds_;
};

}  // namespace ajar
