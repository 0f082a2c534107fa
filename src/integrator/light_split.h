#pragma once
#include "image/importance_map.h"
#include "transport/path_sampler.h"

namespace ajar {

/// How ordinary Monte Carlo and Markov chains share the light of long paths, path by path.
///
/// What a technique finds along a path, C = f/p · MIS weight, matters to its pixel in proportion to
/// g = luminance(C) · importance. Ordinary Monte Carlo deals well with many paths of small g, and
/// makes fireflies of few with a large one; chains follow large g. So the path's light is divided:
///
///     by ordinary Monte Carlo   C · T / (T + g),   never more than T for its pixel,
///     by chains                 C · g / (T + g).
///
/// Both sides compute g from the path and its technique alone, so the parts add up to C. It is the
/// balance heuristic between independent samples and a chain of density g/b (Kelemen et al. 2002,
/// section 5.2), but over what bidirectional path tracing samples anyway, and put into the chain's
/// target, so that the chain spends no time on what it does not make. The idea to divide in path
/// space is Bitterli & Jarosz 2019's.
class LightSplit {
 public:
  /// Edges of the longest paths that are direct light.
  static constexpr int kDirectDepth = 2;

  /// Divides indirect light at g = `threshold` (T), in the units of radiance · importance.
  /// `importance` must outlive this.
  LightSplit(double threshold, const ImportanceMap& importance)
      : threshold_(static_cast<float>(threshold)), importance_(&importance) {}

  static bool divides(Technique technique) { return technique.depth() > kDirectDepth; }
  /// What chains make of a contribution that lands on `raster`.
  float chain_share(const Contribution& contribution, const Vec2& raster) const {
    if (!divides(contribution.technique)) return 0.F;
    return share_of(strength(contribution, raster));
  }
  float omc_share(const Contribution& contribution, const Vec2& raster) const {
    return 1.F - chain_share(contribution, raster);
  }
  float importance(const Vec2& raster) const { return (*importance_)(raster); }
  /// g.
  float strength(const Contribution& contribution, const Vec2& raster) const {
    return luminance(contribution.value) / contribution.chance * (*importance_)(raster);
  }

 private:
  float share_of(float strength) const {
    // What is infinite or not a number is for whoever adds it up to discard.
    return strength > 0.F ? 1.F / (1.F + threshold_ / strength) : 0.F;
  }

  float threshold_;
  const ImportanceMap* importance_;
};

}  // namespace ajar
