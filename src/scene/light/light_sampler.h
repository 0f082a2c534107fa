#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/distribution.h"
#include "scene/light/light.h"
#include "scene/light/light_tree.h"

namespace ajar {

struct ChosenLight {
  const Light* light;  ///< never null
  Pdf<Discrete> probability;
  float u;  ///< the uniform number, stretched to [0, 1) again
};

/// Chooses among the lights of a scene. The choice may depend on the point to be lit, the
/// probability of a choice is the same from whichever end of a path it is asked. Every light whose
/// power is not zero can be chosen; if all are zero, all are equally likely.
///
/// For a point to be lit, lights at finite places are chosen by a tree, those at infinity by power,
/// between the two kinds half by the irradiance they may cause and half evenly. A few choices are
/// by power alone: neglected effects (shadows above all) cannot make the variance larger than by a
/// fixed factor.
class LightSampler {
 public:
  /// `lights` must outlive it, and the `index` of each must be its position; `bounds` is the sphere
  /// that lights at infinity shine through.
  LightSampler(std::span<const std::unique_ptr<Light>> lights, const BoundingSphere& bounds);
  bool empty() const;
  /// For next event estimation at `reference`; requires !empty().
  ChosenLight choose(const Vec3& reference, float u) const;
  Pdf<Discrete> probability(const Vec3& reference, const Light& light) const;
  /// A number by which `choose` gives `light`, made of the fresh number `u`
  /// (docs/methods/inverses.md); its density is that of `probability`. Empty if there is none: the
  /// probability is 0, or less than uniform numbers resolve.
  std::optional<float> invert(const Vec3& reference, const Light& light, float u) const;
  /// For the start of a light subpath; requires !empty().
  ChosenLight choose_emitter(float u) const;
  Pdf<Discrete> emitter_probability(const Light& light) const;
  std::optional<float> invert_emitter(const Light& light, float u) const;

 private:
  /// Share of choices that are by power alone: they bound the variance to 1 / kByPower of that by
  /// power, and cost 1 / (1 − kByPower) where the tree is right.
  static constexpr float kByPower = 0.05F;

  /// Share of the lights at infinity in the choices that depend on the reference.
  float distant_share(const Vec3& reference) const;
  /// Given that the choice depends on the reference.
  float placed_probability(const Vec3& reference, std::uint32_t light) const;
  float mixed(float by_power, float placed) const {
    return kByPower * by_power + (1.F - kByPower) * placed;
  }

  std::span<const std::unique_ptr<Light>> lights_;
  Distribution1D by_power_;
  /// False if nothing is known of where the light comes from: then power is all there is.
  bool placed_ = false;
  LightTree tree_;
  std::vector<std::uint32_t> distant_;  ///< lights that have no bounds
  Distribution1D distant_by_power_;
  /// By light: its place among the distant ones, or kPlaced.
  std::vector<std::uint32_t> distant_index_;
  static constexpr std::uint32_t kPlaced = ~0U;
  double distant_irradiance_ = 0.0;  ///< luminance, W/m², on a plane that faces them
};

}  // namespace ajar
