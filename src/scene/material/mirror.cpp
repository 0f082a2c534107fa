#include "scene/material/inputs.h"

namespace ajar {
namespace {

/// Perfect mirror with a constant reflectance.
class MirrorSurface final : public Material {
 public:
  explicit MirrorSurface(const MaterialInputs& in) : reflectance_(in.slot("reflectance")) {}
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    bsdf.add(Mirror{}, scale * reflectance(reflectance_, at));
  }
  int max_lobes() const override { return 1; }

 private:
  TextureSlot reflectance_;
};

}  // namespace

MaterialModel mirror_material() {
  return {
      {.name = "mirror",
       .summary = "perfect mirror",
       .source = "",
       .parameters = {declare::reflectance("reflectance", "0.9", "share of light it reflects")}},
      make<MirrorSurface>};
}

}  // namespace ajar
