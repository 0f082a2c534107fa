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
        depth_(in.slot("coat_depth")),
        facets_(facet_model(in.node())),
        coat_facets_(facet_model(in.node(), "coat_distribution")),
        pass_(coat_pass(in.node())),
        bounces_(in.node().integer("bounces")) {
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
      const Coat coat(eta, 0.F, coat_facets_, pass_, bounces_);
      bsdf.add(SmoothCoatedConductor{{metal, coat, PackedSpectrum(depth)}}, scale);
      return;
    }
    if (smooth_coat) {
      bsdf.add(SmoothCoat{{eta}}, scale);
    } else {
      bsdf.add(RoughCoat{{coat_facets_, coat_u, coat_v}, {eta}}, scale);
    }
    const float coat_alpha = smooth_coat ? 0.F : std::sqrt(coat_u * coat_v);
    const bool blurs = !smooth_coat && pass_ != CoatPass::Smooth && pass_ != CoatPass::Single;
    const float blurred_u = blurred(u, blurs ? coat_u : 0.F, eta);
    const float blurred_v = blurred(v, blurs ? coat_v : 0.F, eta);
    const CoatedConductor once{{facets_, blurred_u, blurred_v},
                               metal,
                               Coat(eta, coat_alpha, coat_facets_, pass_, bounces_)};
    const Spectrum left =
        scale * map_lanes(depth, [&](float x) { return std::exp(-2.F * x * mean_way(eta)); });
    bsdf.add(once, left);
    if (smooth_coat && bounces_ != 1) bsdf.add(CoatedConductorEcho(once), left);
  }
  int max_lobes() const override { return bounces_ == 1 ? 2 : 3; }

 private:
  /// 1 / cos θ' on average over the cosine-weighted directions outside, θ' being the angle inside:
  /// how much longer than along the normal the ways through the coat are.
  static float mean_way(float eta) {
    // 2η² (1 − √(1 − 1/η²)), written so that nothing cancels.
    return 2.F / (1.F + std::sqrt(1.F - 1.F / (eta * eta)));
  }
  /// α of facets that blur as much as those of the metal, seen through a coat with facets of its
  /// own: a facet tilted by δ turns refracted light by (1 − 1/η) δ, on the way in and out, and
  /// reflected light by 2δ; variances add up.
  static float blurred(float alpha, float coat_alpha, float eta) {
    const float refracted = (1.F - 1.F / eta) * coat_alpha;
    return std::sqrt(alpha * alpha + 0.5F * refracted * refracted);
  }

  MetalSlots metal_;
  RoughnessSlot roughness_;
  TextureSlot coat_eta_;
  RoughnessSlot coat_roughness_;
  TextureSlot depth_;
  FacetModel facets_;
  FacetModel coat_facets_;
  CoatPass pass_;
  int bounces_;
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
                                         "along v; without it, the same in all directions", 1.0),
                choice_parameter("coat_distribution", {"ggx", "beckmann"},
                                 "distribution of the normals of the coat's facets"),
                coat_transmission_input(),
                declare::integer("bounces", "0",
                                 "how often light may meet the metal; 0: any number of times", 0,
                                 1000)}),
           declare::joined(facet_inputs(), roughness_inputs("0")))},
      make<CoatedConductorSurface>};
}

}  // namespace ajar
