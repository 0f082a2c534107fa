#include "scene/material/inputs.h"

namespace ajar {
namespace {

constexpr WarningKind kSmoothThinGlass{
    Effect::Surface,
    "materials are thin glass, which is always smooth: their roughness is ignored"};

/// Indices that are quotients of equal ones are 1 but for roundings.
bool is_no_boundary(float eta) { return std::abs(eta - 1.F) <= 0x1p-21F; }

/// Dielectric boundary: smooth, rough (if either roughness is not zero), or a thin smooth pane.
class Dielectric final : public Material {
 public:
  explicit Dielectric(const MaterialInputs& in)
      : reflectance_(in.slot("reflectance")),
        transmittance_(in.slot("transmittance")),
        eta_(in.slot("eta")),
        roughness_(in),
        model_(facet_model(in.node())),
        rough_(!roughness_.is_smooth()),
        thin_(in.node().flag("thin")),
        polarised_(in.node().flag("polarised")),
        along_normal_(in.node().flag("along_normal")),
        uncounted_(in.node().flag("uncounted")) {
    passes_uncounted = thin_ && uncounted_;
    index_varies = !eta_.is_constant();
    const SurfacePoint anywhere{};
    is_nothing_ = eta_.is_constant() && is_no_boundary(index_of_refraction(eta_, anywhere)) &&
                  transmittance_.is_constant() &&
                  reflectance(transmittance_, anywhere) == Spectrum(1.F);
    needs_tangent = rough_ && !thin_ && !roughness_.isotropic();
    if (thin_ && rough_) {
      in.warn(kSmoothThinGlass, "thin glass is always smooth: its roughness is ignored");
    }
  }
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    const PackedSpectrum kr(reflectance(reflectance_, at));
    const PackedSpectrum kt(reflectance(transmittance_, at));
    if (kr.average() == 0.F && kt.average() == 0.F) return;
    const float eta = index_of_refraction(eta_, at);
    if (thin_) {
      bsdf.add(ThinDielectric{kr, kt, eta, polarised_, along_normal_, uncounted_}, scale);
    } else if (rough_ && !index_matched(eta)) {
      bsdf.add(RoughDielectric{roughness_.facets(model_, at), kr, kt, eta}, scale);
    } else {
      bsdf.add(SmoothDielectric{kr, kt, eta}, scale);
    }
  }
  int max_lobes() const override { return 1; }
  bool is_interface() const override { return is_nothing_; }

 private:
  TextureSlot reflectance_;
  TextureSlot transmittance_;
  TextureSlot eta_;
  RoughnessSlot roughness_;
  FacetModel model_;
  bool rough_;
  bool thin_;
  bool polarised_;
  bool along_normal_;
  /// Nothing is reflected or bent; without a tint it is an interface.
  bool is_nothing_ = false;
  bool uncounted_;
};

}  // namespace

MaterialModel dielectric_material() {
  return {{.name = "dielectric",
           .summary = "smooth or rough dielectric boundary, such as glass or water",
           .source = "Walter et al. 2007",
           .parameters = declare::joined(
               declare::joined(
                   {declare::reflectance("reflectance", "1", "tint of what is reflected"),
                    declare::reflectance("transmittance", "1", "tint of what is refracted"),
                    declare::textured_number(
                        "eta", "1.5",
                        "index of refraction inside, relative to outside; 1 without a tint: no "
                        "surface at all",
                        20.0),
                    declare::flag("thin", "a pane without thickness: transmits straight on"),
                    declare::flag(
                        "polarised",
                        "of thin ones: between its sides both polarisations go to and fro apart, "
                        "not their mean"),
                    declare::flag(
                        "along_normal",
                        "of thin ones: transmittance is that along the normal, and less on longer "
                        "ways"),
                    declare::flag("uncounted",
                                  "of thin ones: what they transmit adds nothing to the depth of a "
                                  "path")},
                   facet_inputs()),
               roughness_inputs("0"))},
          make<Dielectric>};
}

}  // namespace ajar
