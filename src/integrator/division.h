#pragma once
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "image/importance_map.h"
#include "image/pixel_at.h"
#include "integrator/chain_weight.h"
#include "transport/path_sampler.h"

namespace ajar {

/// The film's layer of ordinary Monte Carlo's part of divided light.
inline const std::string kWeakLayer = "indirect-weak";
/// The film's layer of its samples of the chains' part: another estimate of their layer.
inline const std::string kStrongLayer = "indirect-strong";

/// Division of the long paths of a pixel.
struct PixelDivision {
  /// T: of what a technique brings, chains make the part above, in the units of radiance ·
  /// importance. 0: all of it.
  float threshold = 0.F;
  /// σ, by which the chains' target is multiplied. 0 leaves everything to ordinary Monte Carlo.
  float target_scale = 1.F;
  /// Scale of the chains' deposits in the picture, in place of σ: equal to it, unless one method
  /// alone makes a pixel.
  float deposit_scale = 1.F;
};

/// Division of the light of long paths between ordinary Monte Carlo and Markov chains, path by
/// path: the estimator of `selective`, in five lines. x₁ … x_n are the paths of camera samples, y₁
/// … y_N the states of chains:
///
///     g(x) = luminance(F(x)) · importance         of F = f/p · MIS weight, as a technique finds it
///     w(x) = σ · g / (T + g)                      the chains' part
///     I    = 1/n Σ F(xᵢ) (1 − w(xᵢ)) + b/N Σ F(yₖ) w(yₖ) / t(yₖ)      chains with target t = g·w
///     b    = 1/n Σ g(xᵢ) w(xᵢ)                    of the same samples, which also start the chains
///     T    : least X(T)/n + C·b(T)²/N             for n·c_s + N·c_m rays (optimal_thresholds.h)
///
/// X is the variance of a sample with its remaining part, C the variance of a mutation over that of
/// an independent sample of the chains' light. Where σ is 1, the remaining part of a sample, F·T/(T
/// + g), is never more than T.
///
/// Both sides compute g from the path and its technique alone, and σ and T from its place on the
/// film, so the parts add up to F. With σ = 1 it is the balance heuristic between independent
/// samples and a chain of density g/b (Kelemen et al. 2002, section 5.2), but over what
/// bidirectional path tracing samples anyway, and put into the chain's target, so that the chain
/// spends no time on what it does not make. The idea to divide in path space is Bitterli & Jarosz
/// 2019's. With T = 0 it is the division by an image σ of Frolov (docs/methods/selective.md),
/// and both sides may have different techniques.
class Division final : public ChainWeight {
 public:
  /// Edges of the longest paths that are direct light.
  static constexpr int kDirectDepth = 2;

  /// Divides indirect light at g = `threshold` everywhere. `importance` must outlive this.
  Division(double threshold, const ImportanceMap& importance)
      : pixels_(1),
        highest_(static_cast<float>(threshold)),
        takes_nothing_(false),
        importance_(&importance) {
    pixels_.front().threshold = highest_;
  }
  /// `pixels`: one per pixel of `crop`, row by row.
  Division(const Box2i& crop, std::vector<PixelDivision> pixels, const ImportanceMap& importance)
      : crop_(crop), pixels_(std::move(pixels)), importance_(&importance) {
    for (const PixelDivision& pixel : pixels_) {
      highest_ = std::max(highest_, pixel.threshold);
      takes_nothing_ = takes_nothing_ && pixel.deposit_scale == 0.F;
    }
  }

  static bool divides(Technique technique) { return technique.depth() > kDirectDepth; }
  const PixelDivision& at(const Vec2& raster) const {
    return pixels_.size() == 1 ? pixels_.front() : pixels_[pixel_at(crop_, raster)];
  }
  /// g / (T + g).
  static float chain_fraction(float strength, float threshold) {
    // Infinity and NaN are discarded by the caller.
    return strength > 0.F ? 1.F / (1.F + threshold / strength) : 0.F;
  }
  /// Part of a contribution that lands on `raster` in the chains' target.
  float chain_fraction(const Contribution& contribution, const Vec2& raster) const {
    return divides(contribution.technique) ? chain_fraction(strength(contribution, raster), raster)
                                           : 0.F;
  }
  float chain_fraction(float strength, const Vec2& raster) const {
    const PixelDivision& pixel = at(raster);
    return pixel.target_scale * chain_fraction(strength, pixel.threshold);
  }
  float omc_fraction(const Contribution& contribution, const Vec2& raster) const {
    return divides(contribution.technique) ? omc_fraction(strength(contribution, raster), raster)
                                           : 1.F;
  }
  float omc_fraction(float strength, const Vec2& raster) const {
    const PixelDivision& pixel = at(raster);
    return 1.F - pixel.deposit_scale * chain_fraction(strength, pixel.threshold);
  }
  /// Both at once, of a contribution whose technique is divided.
  struct Parts {
    float light;  ///< luminance · importance
    float strength;
    float chains;
    float omc;
  };
  Parts parts(const Contribution& contribution, const Vec2& raster) const {
    const float light = luminance(contribution.value) * (*importance_)(raster);
    const float strength = light / contribution.roulette_weight;
    const PixelDivision& pixel = at(raster);
    const float over = chain_fraction(strength, pixel.threshold);
    return {light, strength, pixel.target_scale * over, 1.F - pixel.deposit_scale * over};
  }
  float weight(const Contribution& contribution, const Vec2& raster) const override {
    return divides(contribution.technique) ? chain_fraction(contribution, raster) : 1.F;
  }
  float weight(Technique technique, float light, const Vec2& raster) const override {
    return divides(technique) ? chain_fraction(light * (*importance_)(raster), raster) : 1.F;
  }
  float deposit_scale(const Vec2& raster) const override {
    const PixelDivision& pixel = at(raster);
    return pixel.target_scale > 0.F ? pixel.deposit_scale / pixel.target_scale : 0.F;
  }
  /// True if the picture takes nothing from chains anywhere.
  bool takes_nothing() const { return takes_nothing_; }
  /// T of the pixel where it is highest.
  float highest_threshold() const { return highest_; }
  float importance(const Vec2& raster) const { return (*importance_)(raster); }
  /// g.
  float strength(const Contribution& contribution, const Vec2& raster) const {
    return luminance(contribution.value) * (*importance_)(raster) / contribution.roulette_weight;
  }

 private:
  Box2i crop_{Vec2i(0, 0), Vec2i(0, 0)};
  std::vector<PixelDivision> pixels_;
  float highest_ = 0.F;
  bool takes_nothing_ = true;
  const ImportanceMap* importance_;
};

/// The division of each replicate: one for all, or one for the even and one for the odd ones, each
/// found out from the samples of the others.
class Divisions {
 public:
  explicit Divisions(Division all) : divisions_{std::move(all)} {}
  Divisions(Division even, Division odd) : divisions_{std::move(even), std::move(odd)} {}
  const Division& of(int replicate) const {
    return divisions_[static_cast<std::size_t>(replicate) % divisions_.size()];
  }
  std::size_t count() const { return divisions_.size(); }
  bool take_nothing() const {
    return std::all_of(divisions_.begin(), divisions_.end(),
                       [](const Division& division) { return division.takes_nothing(); });
  }

 private:
  std::vector<Division> divisions_;
};

}  // namespace ajar
