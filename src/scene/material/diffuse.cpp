#include "scene/material/inputs.h"

namespace ajar {
namespace {

/// Diffuse: Lambert, or Oren–Nayar where `sigma` (degrees) is not zero.
class Diffuse final : public Material {
 public:
  explicit Diffuse(const MaterialInputs& in)
      : reflectance_(in.slot("reflectance")),
        sigma_(in.slot("sigma")),
        between_facets_(in.node().flag("between_facets")) {}
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    const Spectrum kd = reflectance(reflectance_, at);
    const float sigma = within(sigma_.eval_float(at), 0.F, 90.F) * (kPi / 180.F);
    if (sigma == 0.F) {
      bsdf.add(Lambert{}, scale * kd);
    } else if (between_facets_) {
      bsdf.add(FullOrenNayar(kd, sigma), scale);
    } else {
      bsdf.add(OrenNayar(sigma), scale * kd);
    }
  }
  int max_lobes() const override { return 1; }
  bool is_diffuse() const override { return true; }

 private:
  TextureSlot reflectance_;
  TextureSlot sigma_;
  bool between_facets_;
};

}  // namespace

MaterialModel diffuse_material() {
  ParameterSpec sigma = declare::textured_number(
      "sigma", "0", "spread of the slopes of the facets; 0 for a smooth surface (Lambert)", 90.0);
  sigma.unit = "degrees";
  return {{.name = "diffuse",
           .summary = "diffuse (Lambert), or rough diffuse (Oren-Nayar)",
           .source = "Oren and Nayar 1994",
           .parameters = {declare::reflectance("reflectance", "0.5", "share of light it reflects"),
                          std::move(sigma),
                          declare::flag("between_facets",
                                        "with the light that facets of a rough surface send to "
                                        "each other")}},
          make<Diffuse>};
}

}  // namespace ajar
