#include "scene/material/metal.h"

namespace ajar {
namespace {

bool is_given(const MaterialInputs& in, std::string_view name) {
  return !std::holds_alternative<std::monostate>(in.node().get(name));
}

}  // namespace

std::vector<ParameterSpec> metal_inputs(std::string eta, std::string k, std::string reflectance) {
  return {declare::textured_color(std::move(eta), "0.200982586 0.923764288 1.10221601",
                                  "index of refraction; copper's, unless given"),
          declare::textured_color(std::move(k), "3.91325855 2.45303726 2.14209414",
                                  "extinction coefficient; copper's, unless given"),
          declare::reflectance(std::move(reflectance), "",
                               "at normal incidence; if given, in place of index and extinction")};
}

MetalSlots::MetalSlots(const MaterialInputs& in, std::string_view eta, std::string_view k,
                       std::string_view reflectance)
    : by_reflectance_(is_given(in, reflectance)),
      eta_(in.slot(eta)),
      k_(in.slot(k)),
      reflectance_(by_reflectance_ ? in.slot(reflectance) : TextureSlot(Spectrum(1.F))) {}

Spectrum MetalSlots::k(const SurfacePoint& at) const {
  if (!by_reflectance_) return k_.eval(at);
  return map_lanes(reflectance_.eval(at), [](float r) {
    const float below_one = within(r, 0.F, 0.9999F);
    return 2.F * std::sqrt(below_one / (1.F - below_one));
  });
}

}  // namespace ajar
