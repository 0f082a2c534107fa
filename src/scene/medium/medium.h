#pragma once
#include <string>

#include "core/spectrum.h"

namespace ajar {

/// Homogeneous medium. Coefficients in 1/(scene unit).
class Medium {
 public:
  Medium(std::string name, const Spectrum& sigma_a, const Spectrum& sigma_s, float g)
      : name_(std::move(name)), sigma_a_(sigma_a), sigma_s_(sigma_s), g_(g) {}
  /// Fraction of light that crosses `distance` unabsorbed and unscattered (Beer–Lambert).
  Spectrum transmittance(float distance) const { return exp(sigma_t() * -distance); }
  /// False if it only absorbs: then rays cross it without any choice to sample.
  bool scatters() const { return !sigma_s_.is_black(); }
  Spectrum sigma_t() const { return sigma_a_ + sigma_s_; }
  const Spectrum& sigma_a() const { return sigma_a_; }
  const Spectrum& sigma_s() const { return sigma_s_; }
  float g() const { return g_; }
  const std::string& name() const { return name_; }

 private:
  std::string name_;
  Spectrum sigma_a_;
  Spectrum sigma_s_;
  float g_;
};

}  // namespace ajar
