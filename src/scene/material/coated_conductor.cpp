#include "scene/material/inputs.h"
#include "scene/material/metal.h"

namespace ajar {
namespace {

/// Both α below this look smooth, and are treated so. Source: Pharr et al. 2023, section 9.6.2.
constexpr float kEffectivelySmooth = 1e-3F;

bool is_smooth(float alpha_u, float alpha_v) {
  return std::max(alpha_u, alpha_v) < kEffectivelySmooth;
}

/// Metal under a transparent coat.
class CoatedConductorSurface final : public Material {
 public:
  explicit CoatedConductorSurface(const MaterialInputs& in)
      : metal_(in, "eta", "k", "reflectance"),
        roughness_(in),
        coat_eta_(in.slot("coat_eta")),
        coat_roughness_(in, "coat_roughness", "coat_roughness_v"),
        depth_(in.slot("coat_depth")) {
    needs_tangent = !roughness_.isotropic() || !coat_roughness_.isotropic();
  }
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    const float eta = std::max(index_of_refraction(coat_eta_, at), 1.F);
    const ConductorFresnel metal(metal_.eta(at) / eta, metal_.k(at) / eta);
    const float u = roughness_.alpha_u(at);
    const float v = roughness_.alpha_v(at);
    const float coat_u = coat_roughness_.alpha_u(at);
    const float coat_v = coat_roughness_.alpha_v(at);
    const bool smooth_coat = is_smooth(coat_u, coat_v);
    const Spectrum depth = coat_depth(depth_, at);
    if (smooth_coat && is_smooth(u, v)) {
      bsdf.add(SmoothCoatedConductor{{metal, eta, PackedSpectrum(depth)}}, scale);
      return;
    }
    Coat coat{eta, 0.F};
    if (smooth_coat) {
      bsdf.add(SmoothCoat{{eta}}, scale);
    } else {
      bsdf.add(RoughCoat{{FacetModel::Ggx, coat_u, coat_v}, {eta}}, scale);
      coat.alpha = std::sqrt(coat_u * coat_v);
    }
    const float blurred_u = blurred(u, smooth_coat ? 0.F : coat_u, eta);
    const float blurred_v = blurred(v, smooth_coat ? 0.F : coat_v, eta);
    bsdf.add(CoatedConductor{{FacetModel::Ggx, blurred_u, blurred_v}, metal, coat},
             scale * map_lanes(depth, [&](float x) { return std::exp(-2.F * x * mean_way(eta)); }));
  }
  int max_lobes() const override { return 2; }

 private:
  /// 1 / cos θ' on average over the cosine-weighted directions outside, θ' being the angle inside:
  /// how much longer than along the normal the ways through the coat are.
  static float mean_way(float eta) {
    // 2η² (1 − √(1 − 1/η²)), written so that nothing cancels.
    return 2.F / (1.F + std::sqrt(1.F - 1.F / (eta * eta)));
  }
  /// α of facets that blur as much as those of the metal, seen through a coat with facets of its
  /// own: a facet tilted by δ turns what it refracts by (1 − 1/η) δ, on the way in and out, and
  /// what a mirror does by 2δ; variances add up.
  static float blurred(float alpha, float coat_alpha, float eta) {
    const float refracted = (1.F - 1.F / eta) * coat_alpha;
    return std::sqrt(alpha * alpha + 0.5F * refracted * refracted);
  }

  MetalSlots metal_;
  RoughnessSlot roughness_;
  TextureSlot coat_eta_;
  RoughnessSlot coat_roughness_;
  TextureSlot depth_;
};

}  // namespace

MaterialModel coated_conductor_material() {
  return {
      {.name = "coated_conductor",
       .summary = "metal under a transparent coat, smooth or rough",
       .source = "layers as in Pharr et al. 2023, section 14.3, in closed form",
       .parameters = declare::joined(
           declare::joined(
               metal_inputs("eta", "k", "reflectance"),
               {declare::textured_number("coat_eta", "1.5", "index of refraction of the coat",
                                         20.0),
                declare::textured_number("coat_roughness", "0",
                                         "roughness of the coat, or that along u", 1.0),
                coat_depth_input(),
                declare::textured_number("coat_roughness_v", "",
                                         "along v; without it, the same in all directions", 1.0)}),
           roughness_inputs("0"))},
      make<CoatedConductorSurface>};
}

}  // namespace ajar
