#include "scene/material/inputs.h"

namespace ajar {
namespace {

/// Diffuse base under a glossy coat that follows Schlick's formula.
class SchlickCoatedDiffuse final : public Material {
 public:
  explicit SchlickCoatedDiffuse(const MaterialInputs& in)
      : diffuse_(in.slot("diffuse_reflectance")),
        glossy_(in.slot("glossy_reflectance")),
        roughness_(in),
        facets_(facet_model(in.node())) {
    needs_tangent = !roughness_.isotropic();
  }
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    const Spectrum kd = reflectance(diffuse_, at);
    const Spectrum ks = reflectance(glossy_, at);
    if (kd.is_black() && ks.is_black()) return;
    bsdf.add(FresnelBlend{roughness_.facets(facets_, at), PackedSpectrum(kd), PackedSpectrum(ks)},
             scale);
  }
  int max_lobes() const override { return 1; }

 private:
  TextureSlot diffuse_;
  TextureSlot glossy_;
  RoughnessSlot roughness_;
  FacetModel facets_;
};

/// Diffuse base under a smooth or rough coat of a dielectric.
class DielectricCoatedDiffuse final : public Material {
 public:
  explicit DielectricCoatedDiffuse(const MaterialInputs& in)
      : diffuse_(in.slot("diffuse_reflectance")),
        gloss_(in.slot("coat_reflectance")),
        eta_(in.slot("eta")),
        roughness_(in),
        depth_(in.slot("coat_depth")),
        facets_(facet_model(in.node())),
        pass_(coat_pass(in.node())),
        bounces_(in.node().integer("bounces")),
        is_straight_(in.node().text("coat_ways") == "straight"),
        inside_(in.node().text("inner_reflections")) {
    needs_tangent = !roughness_.isotropic();
  }
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    const float eta = std::max(index_of_refraction(eta_, at), 1.F);
    const float u = roughness_.alpha_u(at);
    const float v = roughness_.alpha_v(at);
    // Source of the limit: Pharr et al. 2023, section 9.6.2.
    const bool smooth = std::max(u, v) < 1e-3F;
    const Spectrum gloss = scale * reflectance(gloss_, at);
    if (smooth) {
      bsdf.add(SmoothCoat{{eta}}, gloss);
    } else {
      bsdf.add(RoughCoat{{facets_, u, v}, {eta}}, gloss);
    }
    const Coat coat(eta, smooth ? 0.F : std::sqrt(u * v), facets_, pass_, bounces_);
    const Spectrum base = reflectance(diffuse_, at);
    const CoatInside inside{coat_depth(depth_, at), is_straight_};
    if (inside_ == "base") {
      bsdf.add(CoatedDiffuse(base, coat, inside), scale);
      return;
    }
    // Two windows are two ways through the coat; light through one fills the hemisphere again.
    const float windows = inside_ == "windows" ? coat.mean_transmittance() : 1.F;
    bsdf.add(CoatedDiffuse(Spectrum(1.F), coat, inside), scale * base * windows);
  }
  int max_lobes() const override { return 2; }

 private:
  TextureSlot diffuse_;
  TextureSlot gloss_;
  TextureSlot eta_;
  RoughnessSlot roughness_;
  TextureSlot depth_;
  FacetModel facets_;
  CoatPass pass_;
  int bounces_;
  bool is_straight_;
  std::string inside_;
};

std::unique_ptr<Material> make_coated_diffuse(const MaterialInputs& in) {
  if (in.node().text("coat") == "dielectric") return make<DielectricCoatedDiffuse>(in);
  return make<SchlickCoatedDiffuse>(in);
}

}  // namespace

MaterialModel coated_diffuse_material() {
  return {
      {.name = "coated_diffuse",
       .summary = "diffuse base under a glossy coat",
       .source = "Ashikhmin and Shirley 2000; layers as in Pharr et al. 2023, section 14.3, "
                 "in closed form",
       .parameters = declare::joined(
           {declare::reflectance("diffuse_reflectance", "0.5", "of the base"),
            choice_parameter("coat", {"schlick", "dielectric"},
                             "a coat that reflects by Schlick's formula, or one of an index "
                             "of refraction, with all reflections between coat and base"),
            declare::only_for(
                "coat", {"schlick"},
                declare::reflectance("glossy_reflectance", "0.5", "of the coat, seen from above")),
            declare::only_for(
                "coat", {"dielectric"},
                declare::textured_number("eta", "1.5", "index of refraction of the coat", 20.0)),
            declare::only_for(
                "coat", {"dielectric"},
                declare::reflectance("coat_reflectance", "1", "tint of what the coat reflects")),
            declare::only_for("coat", {"dielectric"}, coat_depth_input()),
            declare::only_for(
                "coat", {"dielectric"},
                choice_parameter("coat_ways", {"refracted", "straight"},
                                 "ways of light through what absorbs: those of refracted light, "
                                 "between bounces as well; or straight on, in and out only")),
            declare::only_for("coat", {"dielectric"}, coat_transmission_input()),
            declare::only_for(
                "coat", {"dielectric"},
                declare::integer("bounces", "0",
                                 "how often light may meet the base; 0: any number of times", 0,
                                 1000)),
            declare::only_for(
                "coat", {"dielectric"},
                choice_parameter("inner_reflections", {"base", "white", "windows"},
                                 "what light meets that the coat turns back: the base; a white "
                                 "one, so that its colour does not deepen; or nothing, but it "
                                 "comes through as often as it goes in: two windows"))},
           declare::joined(facet_inputs(), roughness_inputs("0.1")))},
      make_coated_diffuse};
}

}  // namespace ajar
