#include "path/measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ajar {

namespace {

/// |cos θ| at an endpoint; 1 where there is no surface.
double endpoint_cosine(const EndpointPoint& point, const Vec3& w) {
  return length_squared(point.surface.ng) > 0.F ? double{abs_dot(point.surface.ng, w)} : 1.0;
}

/// Jacobian from a density of the direction from `x` (for endpoints at infinity: of the place where
/// the ray crosses a plane) to one of vertex `y`, in its own measure.
double spread(const Scene& scene, const Path& path, int x, int y) {
  const int k = path.depth();
  const Endpoint* from = nullptr;
  if (x == 0) from = path.light;
  if (x == k) from = &scene.camera();
  const bool to_infinity =
      (y == 0 && path.light->at_infinity()) || (y == k && scene.camera().at_infinity());
  if (to_infinity) return 1.0;
  const Vec3 w = y < x ? path.toward_light(scene, x) : path.toward_camera(scene, x);
  double cosine = 1.0;
  if (y == 0) {
    cosine = endpoint_cosine(path.light_point, w);
  } else if (y == k) {
    cosine = endpoint_cosine(path.camera_point, w);
  } else {
    cosine = double{path.vertex(y).cosine(w)};
  }
  if (from != nullptr && from->at_infinity()) return cosine;
  // Scattering events of a medium can fall on the very coordinates of the vertex before.
  return cosine / std::max(path.squared_distance(x, y), 1e-36);
}

MediumPoint scattered_in(const Path& path, int x) {
  return x == 0 || x == path.depth() ? MediumPoint{} : path.vertex(x).scattered_in();
}

/// Densities with which camera subpaths start as `path` does. Wide filters draw rays from beyond
/// the border of the image, where the camera says that it sees nothing.
EmissionPdf camera_start(const Scene& scene, const Path& path) {
  const Camera& camera = scene.camera();
  const int k = path.depth();
  const Vec3 away = path.toward_light(scene, k);
  const EmissionPdf pdf = camera.emission_pdf(path.camera_point, away);
  if (pdf.departure.value() > 0.F || inside_image(scene, path.raster)) return pdf;
  const Vec3 reference = path.camera_point.surface.p + away;
  const auto lens = camera.invert_connection(reference, path.camera_point, {0.F, Vec2(0.5F, 0.5F)});
  if (!lens) return pdf;
  const auto ray =
      camera.sample_emission({0.F, lens->position, path.raster / Vec2(camera.resolution())});
  return ray ? EmissionPdf{ray->position_pdf, ray->departure_pdf} : pdf;
}

/// Density with which a subpath of `count` ≥ 2 vertices from the light is sampled, by lane.
ByLane light_side(const Scene& scene, const Path& path, int count) {
  ByLane pdf(1.0);
  for (int x = 0; x < count; ++x) pdf *= light_step_pdf(scene, path, x);
  return pdf;
}

/// Density of the camera's side, for `count` ≥ 1.
ByLane camera_side(const Scene& scene, const Path& path, int count) {
  ByLane pdf(1.0);
  for (int x = path.depth(); x > path.depth() - count; --x) {
    pdf *= camera_step_pdf(scene, path, x);
  }
  return pdf;
}

}  // namespace

ScaledSpectrum& ScaledSpectrum::operator*=(const Spectrum& factor) {
  const float size = factor.max();
  if (!(size > 0.F)) {
    scale = 0.0;
    return *this;
  }
  spectrum *= factor / size;
  *this *= static_cast<double>(size);
  const float left = spectrum.max();
  if (left > 0.F && left < 1e-6F) {
    spectrum /= left;
    *this *= static_cast<double>(left);
  }
  return *this;
}

ScaledSpectrum& ScaledSpectrum::operator*=(double factor) {
  int power = 0;
  scale = std::frexp(scale * factor, &power);
  exponent += power;
  return *this;
}

double ScaledSpectrum::whole_scale() const {
  // Far beyond what doubles hold, where ldexp says infinity or 0.
  return std::ldexp(scale, static_cast<int>(std::clamp<std::int64_t>(exponent, -100000, 100000)));
}

double ScaledSpectrum::log_luminance() const {
  return std::log(static_cast<double>(ajar::luminance(spectrum)) * scale) +
         static_cast<double>(exponent) * std::numbers::ln2;
}

bool inside_image(const Scene& scene, const Vec2& raster) {
  const Vec2 size(scene.camera().resolution());
  return raster.x >= 0.F && raster.y >= 0.F && raster.x < size.x && raster.y < size.y;
}

ByLane arrival_pdf(const Scene& scene, const Path& path, int from, int to) {
  const int edge = std::min(from, to);
  return by_lane(path.segment(edge).distance_pdf(scattered_in(path, to))) *
         spread(scene, path, from, to);
}

ByLane light_step_pdf(const Scene& scene, const Path& path, int x) {
  if (x <= 1) {
    const Light& light = *path.light;
    const EmissionPdf emission = light.emission_pdf(path.light_point, path.toward_camera(scene, 0));
    if (x == 1) return arrival_pdf(scene, path, 0, 1) * double{emission.departure.value()};
    return ByLane(double{emission.position.value()} *
                  double{scene.light_sampler().emitter_probability(light).value()});
  }
  return arrival_pdf(scene, path, x - 1, x) *
         path.vertex(x - 1).pdf(path.toward_light(scene, x - 1), path.toward_camera(scene, x - 1));
}

ByLane camera_step_pdf(const Scene& scene, const Path& path, int x) {
  const int k = path.depth();
  if (x >= k - 1) {
    const EmissionPdf emission = camera_start(scene, path);
    if (x == k) return ByLane(double{emission.position.value()});
    return arrival_pdf(scene, path, k, x) * double{emission.departure.value()};
  }
  return arrival_pdf(scene, path, x + 1, x) *
         path.vertex(x + 1).pdf(path.toward_camera(scene, x + 1), path.toward_light(scene, x + 1));
}

double next_event_pdf(const Scene& scene, const Path& path) {
  const Vec3& reference = path.vertex(1).p();
  return double{path.light->connection_pdf(reference, path.light_point).value()} *
         double{scene.light_sampler().probability(reference, *path.light).value()};
}

ScaledSpectrum contribution(const Scene& scene, const Path& path) {
  const int k = path.depth();
  const Vec3 away = path.toward_light(scene, k);
  ScaledSpectrum f;
  if (inside_image(scene, path.raster)) {
    f *= scene.camera().emitted(path.camera_point, away);
    f *= endpoint_cosine(path.camera_point, away);
  } else {  // rays that the camera samples weigh one
    const EmissionPdf start = camera_start(scene, path);
    f *= double{start.position.value()} * double{start.departure.value()};
  }
  for (int x = k - 1; x >= 0; --x) {  // from x + 1 to x, and what happens there
    f *= path.segment(x).transmittance;
    f *= spread(scene, path, x + 1, x);
    if (x == 0) break;
    const InnerVertex& vertex = path.vertex(x);
    const Vec3 wo = path.toward_camera(scene, x);
    if (vertex.in_medium) f *= vertex.scattered_in().sigma_s();
    if (vertex.event.specular()) {
      const auto sample = vertex.bsdf.specular(wo, vertex.event, TransportMode::Radiance);
      f *= sample ? sample->weight * sample->pdf.value() : Spectrum();
    } else {
      f *= vertex.eval(wo, path.toward_light(scene, x), TransportMode::Radiance);
    }
  }
  f *= path.light->emitted(path.light_point, path.toward_camera(scene, 0));
  return f;
}

ByLane technique_pdf_by_lane(const Scene& scene, const Path& path, Technique technique) {
  const auto [s, t] = technique;
  const int k = path.depth();
  if (s + t != k + 1 || t < 1) return ByLane(0.0);
  if (s == 0) return path.light->discrete_position() ? ByLane(0.0) : camera_side(scene, path, t);
  if (k == 1) return ByLane(0.0);
  // Ends of the connection must scatter into more than single directions.
  for (const int x : {s - 1, s}) {
    if (x >= 1 && x < k && path.vertex(x).event.specular()) return ByLane(0.0);
  }
  if (s > 1) return light_side(scene, path, s) * camera_side(scene, path, t);
  return camera_side(scene, path, t) * next_event_pdf(scene, path);
}

double technique_pdf(const Scene& scene, const Path& path, Technique technique) {
  return mean(technique_pdf_by_lane(scene, path, technique));
}

double specular_spread(const Scene& scene, const Path& path, int x) {
  const InnerVertex& vertex = path.vertex(x);
  const Vec3 wo = path.toward_camera(scene, x);
  const auto sample = vertex.bsdf.specular(wo, vertex.event, TransportMode::Radiance);
  if (!sample) return 0.0;
  const Vec3 ns = vertex.bsdf.ns();
  const double eta = sample->eta;
  return eta * eta * double{abs_dot(ns, sample->wi)} / double{abs_dot(ns, wo)};
}

Spectrum throughput(const Scene& scene, const Path& path, Technique technique) {
  const double pdf = technique_pdf(scene, path, technique);
  if (!(pdf > 0.0)) return {};
  ScaledSpectrum f = contribution(scene, path);
  for (int x = 1; x + 1 < technique.s; ++x) {
    if (path.vertex(x).event.specular()) f *= specular_spread(scene, path, x);
  }
  f *= 1.0 / pdf;
  return f.value();
}

double mis_weight(const Scene& scene, const PathSamplerSettings& settings, const Path& path,
                  Technique technique) {
  const bool inside = inside_image(scene, path.raster);
  const auto share = [&](Technique other) {
    if (!settings.techniques.enabled(other) || (other.t == 1 && !inside)) return 0.0;
    return mean(
        h(settings.heuristic, technique_pdf_by_lane(scene, path, other) * tries(settings, other)));
  };
  double sum = 0.0;
  for (int s = 0; s <= path.depth(); ++s) sum += share({s, path.depth() + 1 - s});
  return share(technique) / sum;
}

double tries(const PathSamplerSettings& settings, Technique technique) {
  const double subpaths = technique.t == 1   ? settings.light_paths_per_pixel
                          : technique.s >= 2 ? settings.light_subpaths
                                             : 1.0;
  return settings.techniques.count(technique) * subpaths;
}

}  // namespace ajar
