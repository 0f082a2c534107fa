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

std::optional<BsdfSample> PathVertex::sample(const BsdfUniforms& u, TransportMode mode) const {
  if (!in_medium) return bsdf.sample(wo, u, mode);
  BsdfSample sample;
  sample.wi = phase::sample_henyey_greenstein(medium->g(), wo, u.direction);
  sample.pdf = DirectionPdf(pdf(wo, sample.wi));
  sample.reverse_pdf = sample.pdf;
  sample.weight = Spectrum(1.F);
  return sample;
}

const Medium* PathVertex::medium_toward(const Vec3& w) const {
  if (in_medium || !media->changes) return medium;
  return dot(w, bsdf.ng()) > 0.F ? media->outside : media->inside;
}

Vec3 PathVertex::ray_origin(const Vec3& w) const {
  return in_medium ? p : offset_ray_origin(p, bsdf.ng(), w);
}

}  // namespace ajar
