#include "path/path.h"

#include "scene/medium/phase.h"

namespace ajar {

Spectrum InnerVertex::eval(const Vec3& wo, const Vec3& wi, TransportMode mode) const {
  if (!in_medium) return bsdf.eval(wo, wi, mode);
  return Spectrum(phase::henyey_greenstein(medium->g(), wo, wi));
}

double InnerVertex::pdf(const Vec3& from, const Vec3& to) const {
  if (in_medium) return double{phase::henyey_greenstein(medium->g(), from, to)};
  if (!event.specular()) return double{bsdf.pdf(from, to).value()};
  const auto sample = bsdf.specular(from, event, TransportMode::Radiance);
  return sample ? double{sample->pdf.value()} : 0.0;
}

const Medium* InnerVertex::medium_toward(const Vec3& w) const {
  if (in_medium || !hit.media->changes) return medium;
  return dot(w, hit.point.ng) > 0.F ? hit.media->outside : hit.media->inside;
}

int Path::counted_depth() const {
  int depth = this->depth();
  for (const InnerVertex& vertex : vertices) depth -= vertex.is_uncounted() ? 1 : 0;
  for (const Segment& segment : segments) depth += segment.counted_interfaces;
  return depth;
}

const Vec3& Path::position(int x) const {
  if (x == 0) return light_point.surface.p;
  return x == depth() ? camera_point.surface.p : vertex(x).p();
}

Vec3 Path::toward_light(const Scene& scene, int x) const {
  if (x == 1 && light->at_infinity()) return light_point.toward;
  if (x == depth() && scene.camera().at_infinity()) return -camera_point.toward;
  return normalize(position(x - 1) - position(x));
}

Vec3 Path::toward_camera(const Scene& scene, int x) const {
  return x == 0 && light->at_infinity() ? -light_point.toward : -toward_light(scene, x + 1);
}

bool is_seen_past_lights(const Scene& scene, const Path& path, int edge) {
  if (!scene.hides_lights()) return false;
  for (int x = path.depth() - 1; x > edge; --x) {
    if (!path.vertex(x).is_uncounted() || path.segment(x).counted_interfaces > 0) return false;
  }
  return true;
}

bool is_hidden(const Scene& scene, const Path& path) {
  // The light itself, or a surface on the way that shines.
  for (int edge = path.depth() - 1; edge >= 0 && is_seen_past_lights(scene, path, edge); --edge) {
    const bool shines = edge == 0 || path.vertex(edge).hit.light != nullptr;
    if (shines && path.segment(edge).counted_interfaces == 0) return true;
  }
  return false;
}

void mark_sides(const Scene& scene, Path& path) {
  for (int x = 1; x < path.depth(); ++x) {
    InnerVertex& vertex = path.vertices[static_cast<std::size_t>(x - 1)];
    if (vertex.event.specular()) continue;
    const float sides = dot(path.toward_light(scene, x), vertex.hit.point.ng) *
                        dot(path.toward_camera(scene, x), vertex.hit.point.ng);
    vertex.event.transmission = !vertex.in_medium && sides < 0.F;
  }
}

}  // namespace ajar
