#include "scene/bsdf/coat.h"

#include <cmath>

namespace ajar {
namespace {

/// ∫ F 2μ dμ of a smooth boundary seen from its thinner side, eta > 1. Source: Walsh 1926, "The
/// reflection factor of a polished glass surface for diffused light".
double diffuse_reflectance(double eta) {
  if (!(eta > 1.0 + 1e-4)) return 0.0;
  const double n2 = eta * eta;
  const double n4 = n2 * n2;
  return 0.5 + (eta - 1.0) * (3.0 * eta + 1.0) / (6.0 * (eta + 1.0) * (eta + 1.0)) +
         n2 * (n2 - 1.0) * (n2 - 1.0) / ((n2 + 1.0) * (n2 + 1.0) * (n2 + 1.0)) *
             std::log((eta - 1.0) / (eta + 1.0)) -
         2.0 * n2 * eta * (n2 + 2.0 * eta - 1.0) / ((n2 + 1.0) * (n4 - 1.0)) +
         8.0 * n4 * (n4 + 1.0) / ((n2 + 1.0) * (n4 - 1.0) * (n4 - 1.0)) * std::log(eta);
}

/// Transmittance of diffuse light through a layer of this optical thickness x: ∫ exp(−x/μ) 2μ dμ =
/// (1 − x) exp(−x) + x² E₁(x).
float mean_left(float thickness) {
  if (!(thickness > 0.F)) return 1.F;
  const auto x = static_cast<double>(std::min(thickness, 80.F));
  return static_cast<float>((1.0 - x) * std::exp(-x) - x * x * std::expint(-x));
}

}  // namespace

float Coat::reflectance(float cosine) const {
  if (alpha_ > 0) return coat_table::reflected(boundary(), cosine);
  return fresnel_dielectric(std::min(cosine, 1.F), eta_).reflectance;
}

float Coat::transmittance(float cosine) const {
  const float smooth = fresnel_dielectric(std::min(cosine, 1.F), eta_).reflectance;
  if (alpha_ == 0) return 1.F - smooth;
  if (pass_ == CoatPass::Whole) return 1.F - reflectance(cosine);
  if (pass_ == CoatPass::Smooth) return 1.F - std::max(smooth, reflectance(cosine));
  return coat_table::refracted(boundary(), cosine);
}

float Coat::mean_transmittance() const {
  if (alpha_ == 0 || pass_ == CoatPass::Smooth) {
    return static_cast<float>(1.0 - diffuse_reflectance(static_cast<double>(eta_)));
  }
  if (pass_ == CoatPass::Whole) return 1.F - coat_table::mean_reflected(boundary());
  return coat_table::mean_refracted(boundary());
}

float Coat::turned_back() const {
  if (alpha_ > 0 && pass_ == CoatPass::Lossy) return coat_table::mean_reflected_inside(boundary());
  if (alpha_ > 0 && pass_ == CoatPass::LossySum) {
    return coat_table::sum_reflected_inside(boundary());
  }
  // By reciprocity the mean transmittance / η² of diffuse light inside comes out.
  return 1.F - mean_transmittance() / (eta_ * eta_);
}

CoatedDiffuse::CoatedDiffuse(const Spectrum& reflectance, const Coat& above,
                             const CoatInside& inside)
    : coat(above), depth(inside.depth), straight(inside.straight) {
  const float squared = above.eta() * above.eta();
  const float turned_back = above.turned_back();
  const auto lane = [&](float r, float thickness) {
    const float left = straight ? 1.F : mean_left(thickness);
    return r * above.series(r * turned_back * left * left) / squared;
  };
  const Spectrum& d = inside.depth;
  base = PackedSpectrum(
      {lane(reflectance[0], d[0]), lane(reflectance[1], d[1]), lane(reflectance[2], d[2])});
}

CoatedConductorEcho::CoatedConductorEcho(const CoatedConductor& first)
    : below{first.facets.model(), first.coat.eta(),
            std::sqrt(first.facets.alpha_x() * first.facets.alpha_y())} {
  const float mean = coat_table::mean_returned(below);
  if (!(mean > 1e-4F)) return;
  const coat_table::DiffuseBelow diffuse = coat_table::diffuse_below(below);
  // Two thirds are the mean cosine of diffuse light.
  const Spectrum metal = first.fresnel(2.F / 3.F, true);
  share = PackedSpectrum(map_lanes(metal, [&](float r) {
    return r * r * diffuse.leaves * first.coat.series(r * diffuse.returns) / mean;
  }));
}

}  // namespace ajar
