#include "import/tungsten/coat_optics.h"

#include <algorithm>
#include <cmath>

namespace ajar::tungsten {
namespace {

/// Cosine within the layer; negative under total reflection.
double refracted_cosine(double ior, double cosine) {
  const double squared = 1.0 - (1.0 - cosine * cosine) / (ior * ior);
  return squared > 0.0 ? std::sqrt(squared) : -1.0;
}

double fresnel(double ior, double cosine) {
  const double inside = refracted_cosine(ior, cosine);
  if (inside < 0.0) return 1.0;
  const double s = (cosine - ior * inside) / (cosine + ior * inside);
  const double p = (ior * cosine - inside) / (ior * cosine + inside);
  return 0.5 * (s * s + p * p);
}

/// Mean of a function of the cosine over directions, weighted by it.
template <typename Function>
double mean_over_directions(Function function) {
  constexpr int kSteps = 512;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) sum += function(std::sqrt((i + 0.5) / kSteps));
  return sum / kSteps;
}

double left_after(double tau, double cosine) {
  return cosine > 0.0 ? std::exp(-tau / cosine) : tau > 0.0 ? 0.0 : 1.0;
}

}  // namespace

double mean_reflectance(double ior) {
  return mean_over_directions([&](double cosine) { return fresnel(ior, cosine); });
}

double mean_internal_reflectance(double ior) {
  // Equal light comes through either way, if it fills all directions (reciprocity).
  return std::clamp(1.0 - (1.0 - mean_reflectance(ior)) / (ior * ior), 0.0, 1.0);
}

double mean_transmittance(double ior, double tau) {
  return mean_over_directions(
      [&](double cosine) { return left_after(tau, refracted_cosine(ior, cosine)); });
}

double mean_round_trip(double ior, double tau) {
  return mean_over_directions([&](double cosine) {
    const double entering = 1.0 - fresnel(ior, cosine);
    return entering * entering * left_after(2.0 * tau, refracted_cosine(ior, cosine));
  });
}

double ior_of_mean_reflectance(double reflectance) {
  double low = 1.0;
  double high = 100.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (mean_reflectance(middle) < reflectance ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace ajar::tungsten
