#include "transport/path_vertex.h"

#include <type_traits>

#include "scene/medium/phase.h"

namespace ajar {

static_assert(std::is_trivially_destructible_v<PathVertex>, "no heap in the sampling loop");

Spectrum PathVertex::eval(const Vec3& wi, TransportMode mode) const {
  if (!in_medium) return bsdf.eval(wo, wi, mode);
  return Spectrum(phase::henyey_greenstein(medium->g(), wo, wi));
}

Pdf<SolidAngle> PathVertex::pdf(const Vec3& from, const Vec3& to) const {
  if (!in_medium) return bsdf.pdf(from, to);
  return Pdf<SolidAngle>(phase::henyey_greenstein(medium->g(), from, to));
}

BsdfValue PathVertex::evaluate(const Vec3& wi, TransportMode mode) const {
  if (!in_medium) return bsdf.evaluate(wo, wi, mode);
  const float density = phase::henyey_greenstein(medium->g(), wo, wi);
  return {Spectrum(density), Pdf<SolidAngle>(density)};
}

std::optional<BsdfSample> PathVertex::sample(const BsdfUniforms& u, TransportMode mode,
                                             Reverse reverse) const {
  if (!in_medium) return bsdf.sample(wo, u, mode, reverse);
  BsdfSample sample;
  sample.wi = phase::sample_henyey_greenstein(medium->g(), wo, u.direction);
  sample.pdf = DirectionPdf(pdf(wo, sample.wi));
  sample.reverse_pdf = sample.pdf;
  sample.weight = Spectrum(1.F);
  return sample;
}

}  // namespace ajar
