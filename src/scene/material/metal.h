#pragma once
#include "scene/material/inputs.h"

namespace ajar {

/// Index of refraction and extinction coefficient, copper's unless given, and in their place the
/// reflectance at normal incidence.
std::vector<ParameterSpec> metal_inputs(std::string eta, std::string k, std::string reflectance);

/// Reads `metal_inputs`. A metal that is given by its reflectance r has the index 1 and k = 2 √r /
/// √(1 − r), which reflect r at normal incidence. Source: Pharr et al. 2023, section 10.5.2.
class MetalSlots {
 public:
  MetalSlots(const MaterialInputs& in, std::string_view eta, std::string_view k,
             std::string_view reflectance);
  Spectrum eta(const SurfacePoint& at) const {
    return by_reflectance_ ? Spectrum(1.F) : eta_.eval(at);
  }
  Spectrum k(const SurfacePoint& at) const;

 private:
  bool by_reflectance_;
  TextureSlot eta_;
  TextureSlot k_;
  TextureSlot reflectance_;
};

}  // namespace ajar
