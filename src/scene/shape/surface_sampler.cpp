#include "scene/shape/surface_sampler.h"

namespace ajar {

std::optional<SurfaceSample> SurfaceSampler::sample_toward(const Vec3& /*reference*/,
                                                           const SurfaceUniforms& u) const {
  return sample(u);
}

Pdf<Area> SurfaceSampler::pdf_toward(const Vec3& /*reference*/, const SurfacePoint& point) const {
  return pdf(point);
}

std::optional<SurfaceUniforms> SurfaceSampler::invert_toward(const Vec3& /*reference*/,
                                                             const SurfacePoint& point,
                                                             const SurfaceUniforms& fresh) const {
  return invert(point, fresh);
}

}  // namespace ajar
