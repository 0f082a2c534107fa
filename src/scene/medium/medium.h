#pragma once
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "core/spectrum.h"
#include "scene/medium/density_field.h"

namespace ajar {

/// Medium whose coefficients, in 1/(scene unit), are those given times a density: 1 everywhere, or
/// that of a field. All lanes share the density.
class Medium {
 public:
  Medium(std::string name, const Spectrum& sigma_a, const Spectrum& sigma_s, float g,
         std::unique_ptr<const DensityField> field = nullptr)
      : name_(std::move(name)),
        sigma_a_(sigma_a),
        sigma_s_(sigma_s),
        g_(g),
        field_(std::move(field)) {}
  /// Along `ray` for `distance`, or until the integral of the density is `most`.
  Column along(const Ray& ray, float distance,
               float most = std::numeric_limits<float>::infinity()) const {
    if (field_ != nullptr) return field_->along(ray, distance, most);
    return most < distance ? Column{most, most, true} : Column{distance, distance, false};
  }
  /// Fraction of light that crosses `column`, an integral of the density, unabsorbed and
  /// unscattered (Beer–Lambert).
  Spectrum transmittance(float column) const { return exp(sigma_t() * -column); }
  /// Positive, where light has scattered.
  float density(const Vec3& p) const { return field_ != nullptr ? field_->at(p) : 1.F; }
  /// False if it only absorbs: then rays cross it without any choice to sample.
  bool scatters() const {
    return !sigma_s_.is_black() && (field_ == nullptr || !field_->is_vacuum());
  }
  /// Coefficients where the density is 1.
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
  std::unique_ptr<const DensityField> field_;
};

/// Where light scatters: in `medium`, at a point; on a surface, or beyond the scene, if it is null.
struct MediumPoint {
  const Medium* medium = nullptr;
  Vec3 p{0.F, 0.F, 0.F};

  Spectrum sigma_t() const { return medium->sigma_t() * medium->density(p); }
  Spectrum sigma_s() const { return medium->sigma_s() * medium->density(p); }
};

}  // namespace ajar
