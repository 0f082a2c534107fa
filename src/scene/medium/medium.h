#pragma once
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "core/spectrum.h"
#include "scene/medium/color_field.h"
#include "scene/medium/density_field.h"

namespace ajar {

/// Medium whose coefficients, in 1/(scene unit), are the same everywhere, or times a density that
/// all lanes share, or those of a field of colours.
class Medium {
 public:
  /// With coefficients where the density is 1.
  Medium(std::string name, const Spectrum& sigma_a, const Spectrum& sigma_s, float g,
         std::unique_ptr<const DensityField> field = nullptr)
      : name_(std::move(name)),
        sigma_t_(sigma_a + sigma_s),
        sigma_s_(sigma_s),
        g_(g),
        field_(std::move(field)) {}
  Medium(std::string name, float g, std::unique_ptr<const ColorField> colors)
      : name_(std::move(name)), g_(g), colors_(std::move(colors)) {}

  /// Along `ray` for `distance`, or until the optical depth of `lane` is `most`. Media without a
  /// box are infinitely deep at an infinite distance, as far as floats go.
  Crossing along(const Ray& ray, float distance, int lane = 0,
                 float most = std::numeric_limits<float>::infinity()) const {
    if (colors_ != nullptr) [[unlikely]]
      return colors_->along(ray, distance, lane, most);
    const Column column = column_along(ray, distance, column_of(lane, most));
    // Infinite distances would make 0 · ∞ of lanes without extinction.
    const float density = std::min(column.density, std::numeric_limits<float>::max());
    return {column.distance, sigma_t_ * density, column.reached};
  }
  /// False if it only absorbs: then rays cross it without any choice to sample.
  bool scatters() const {
    if (colors_ != nullptr) [[unlikely]]
      return colors_->scatters();
    return !sigma_s_.is_black() && (field_ == nullptr || !field_->is_vacuum());
  }
  /// Where light has scattered: positive in lanes in which it may.
  Spectrum sigma_t(const Vec3& p) const {
    if (colors_ != nullptr) [[unlikely]]
      return colors_->sigma_t(p);
    return sigma_t_ * density(p);
  }
  Spectrum sigma_s(const Vec3& p) const {
    if (colors_ != nullptr) [[unlikely]]
      return colors_->sigma_s(p);
    return sigma_s_ * density(p);
  }
  float g() const { return g_; }
  const std::string& name() const { return name_; }

 private:
  float density(const Vec3& p) const { return field_ != nullptr ? field_->at(p) : 1.F; }
  /// Integral of the density of which a lane has the optical depth `depth`.
  float column_of(int lane, float depth) const {
    return sigma_t_[lane] > 0.F ? depth / sigma_t_[lane] : std::numeric_limits<float>::infinity();
  }
  Column column_along(const Ray& ray, float distance, float most) const {
    if (field_ != nullptr) return field_->along(ray, distance, most);
    return most < distance ? Column{most, most, true} : Column{distance, distance, false};
  }

  std::string name_;
  Spectrum sigma_t_;
  Spectrum sigma_s_;
  float g_;
  std::unique_ptr<const DensityField> field_;
  std::unique_ptr<const ColorField> colors_;
};

/// Where light scatters: in `medium`, at a point; on a surface, or beyond the scene, if it is null.
struct MediumPoint {
  const Medium* medium = nullptr;
  Vec3 p{0.F, 0.F, 0.F};

  Spectrum sigma_t() const { return medium->sigma_t(p); }
  Spectrum sigma_s() const { return medium->sigma_s(p); }
};

}  // namespace ajar
