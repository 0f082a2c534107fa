#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "scene/bsdf/coat.h"
#include "scene/bsdf/microfacet.h"
#include "scene/material/registry.h"

/// Inputs of materials; textures are clamped to values that lobes accept.
namespace ajar {

/// The description of one material, with its references.
class MaterialInputs {
 public:
  /// `made` are the materials before this one.
  MaterialInputs(const desc::Material& description, const TextureList& textures,
                 const MaterialList& made, Warnings& warnings)
      : description_(description), textures_(textures), made_(made), warnings_(warnings) {}

  const desc::Node& node() const { return description_.node; }
  /// The parameter of this name, a float or a colour.
  TextureSlot slot(std::string_view name) const { return slot_of(node().get(name)); }
  TextureSlot slot_of(const desc::Value& value) const { return texture_slot(value, textures_); }
  /// The material that the parameter refers to, which outlives this one. A gray one, after a
  /// warning, if it does not come before this one.
  const Material& material(std::string_view name) const;
  void warn(const WarningKind& kind, const std::string& message) const {
    warnings_.add(kind, description_.where, message);
  }

 private:
  const desc::Material& description_;
  const TextureList& textures_;
  const MaterialList& made_;
  Warnings& warnings_;
};

/// An index of refraction, or a texture.
ParameterSpec index_input();
/// "coat_depth", for `coat_depth`.
ParameterSpec coat_depth_input();
/// "coat_transmission", for `coat_pass`.
ParameterSpec coat_transmission_input();
CoatPass coat_pass(const desc::Node& node);
/// "roughness" and "roughness_scale".
std::vector<ParameterSpec> isotropic_roughness_inputs(std::string value);
/// "roughness", "roughness_v" and "roughness_scale".
std::vector<ParameterSpec> roughness_inputs(std::string value);

/// "distribution", with `others` beside those of facets, and "masking", for `facet_model`.
std::vector<ParameterSpec> facet_inputs(std::vector<std::string> others = {});
/// Facets of a layer whose distribution has a name of its own; "masking" is common to all.
FacetModel facet_model(const desc::Node& node, std::string_view distribution = "distribution");

/// `x` in [low, high]; NaN becomes `low`.
inline float within(float x, float low, float high) { return x > low ? std::min(x, high) : low; }
/// A reflectance or a weight: lanes in [0, 1].
inline Spectrum reflectance(const TextureSlot& slot, const SurfacePoint& at) {
  return map_lanes(slot.eval(at), [](float x) { return within(x, 0.F, 1.F); });
}
inline float weight(const TextureSlot& slot, const SurfacePoint& at) {
  return within(slot.eval_float(at), 0.F, 1.F);
}
/// Index of refraction in [0.05, 20]; nonsense (zero, negative, NaN) counts as 1.
inline float index_of_refraction(const TextureSlot& slot, const SurfacePoint& at) {
  const float eta = slot.eval_float(at);
  return eta > 0.F ? std::clamp(eta, 0.05F, 20.F) : 1.F;
}
/// Optical thickness of a coat; beyond 80 it is black.
inline Spectrum coat_depth(const TextureSlot& slot, const SurfacePoint& at) {
  return map_lanes(slot.eval(at), [](float x) { return within(x, 0.F, 80.F); });
}
/// True if a boundary with this index bends light so little that rough refraction, whose lobe then
/// narrows to nothing, must be treated as smooth.
inline bool index_matched(float eta) { return std::abs(eta - 1.F) < 1e-3F; }

/// Convention of a roughness parameter: the microfacets' α, pbrt-v3's artist-friendly number, or α²
/// as pbrt-v4 has it.
enum class RoughnessScale { Alpha, Log, Square };
float microfacet_alpha(RoughnessScale scale, float roughness);

/// Roughness along u and v, as microfacet α. Constant textures are converted only once.
class RoughnessSlot {
 public:
  /// Reads the parameters of `roughness_inputs`, or of `isotropic_roughness_inputs` if the material
  /// has those.
  explicit RoughnessSlot(const MaterialInputs& inputs);
  /// Roughness of a layer with parameters of its own names; "roughness_scale" is common to all.
  RoughnessSlot(const MaterialInputs& inputs, std::string_view name_u, std::string_view name_v);
  bool isotropic() const { return isotropic_; }
  /// True if it is the constant zero.
  bool is_smooth() const { return smooth_; }
  Microfacets facets(FacetModel model, const SurfacePoint& at) const {
    const float u = alpha_u(at);
    return {model, u, isotropic_ ? u : alpha_v(at)};
  }
  float alpha_u(const SurfacePoint& at) const { return evaluate(u_, at); }
  float alpha_v(const SurfacePoint& at) const { return evaluate(v_, at); }

 private:
  float alpha(float roughness) const { return microfacet_alpha(scale_, roughness); }
  float evaluate(const TextureSlot& slot, const SurfacePoint& at) const {
    return slot.is_constant() ? slot.eval_float(at) : alpha(slot.eval_float(at));
  }

  TextureSlot u_;
  TextureSlot v_;
  RoughnessScale scale_;
  bool smooth_;
  bool isotropic_;
};

}  // namespace ajar
