#include "mcmc/path_space/caustic_perturbation.h"

#include <algorithm>
#include <cmath>

#include "mcmc/path_space/heuristics.h"
#include "mcmc/path_space/path_form.h"
#include "mcmc/primary/bootstrap_source.h"
#include "path/log_density.h"
#include "path/measure.h"

namespace ajar {

namespace {

double distance(const Path& path, int x) { return std::sqrt(path.squared_distance(x, x + 1)); }

/// The vertex before the specular chain that leads to the last vertex, or the light.
int start_of_chain(const Path& path) {
  int x = path.depth() - 2;
  while (x > 0 && path.vertex(x).event.specular()) --x;
  return x;
}

bool moves_place(const Path& path, int from) { return from == 0 && path.light->at_infinity(); }

}  // namespace

CausticPerturbation::CausticPerturbation(const Scene& scene, const RasterArea& area)
    : scene_(scene), raster_(raster_law(scene.camera().resolution())), growing_(scene, area) {}

bool CausticPerturbation::suitable(const Path& path) const {
  const int k = path.depth();
  return k >= 2 && !path.vertex(k - 1).event.specular() && inside_image(scene_, path.raster);
}

PerturbationLaw CausticPerturbation::law(const Path& path, int from) const {
  const int k = path.depth();
  const EmissionPdf start =
      scene_.camera().emission_pdf(path.camera_point, path.toward_light(scene_, k));
  // Size of a pixel at the last vertex, perpendicular to the view.
  double size = std::sqrt(1.0 / (static_cast<double>(start.departure.value()) *
                                 image_area(scene_.camera().resolution())));
  if (!scene_.camera().at_infinity()) size *= distance(path, k - 1);
  double unit = size;
  if (!moves_place(path, from)) {
    double length = 0.0;
    for (int x = from; x < k - 1; ++x) length += distance(path, x);
    unit /= length;
  }
  PerturbationLaw law{raster_.smallest * unit, raster_.largest * unit};
  if (!moves_place(path, from)) {
    const double shorter = std::min(1.0, PathSpaceHeuristics::kWidestTurn / law.largest);
    law.smallest *= shorter;
    law.largest *= shorter;
  }
  return law;
}

bool CausticPerturbation::set_off(const Path& x, int from, const Vec2& u) {
  GrowingEnd& light = growing_.light;
  const PerturbationLaw steps = law(x, from);
  if (!(steps.largest > 0.0) || !std::isfinite(steps.largest)) return false;
  const Vec3 w = x.toward_camera(scene_, from);
  if (from > 0) {
    light.go(steps.around(w, u));
    return true;
  }
  const EndpointPoint& point = x.light_point;
  if (!x.light->at_infinity()) {
    const Vec3 turned = steps.around(w, u);
    const Vec3 origin = offset_ray_origin(point.surface.p, point.surface.ng, turned);
    light.start(*x.light, point, {origin, turned}, x.light->medium);
    return true;
  }
  const Vec2 shift = steps.in_plane(u);
  const BoundingSphere& sphere = scene_.bounding_sphere();
  const Vec3 place = x.position(1) + Frame::around(w).to_world({shift.x, shift.y, 0.F});
  // From outside of the scene, however far off its middle the ray passes.
  const float way = dot(sphere.center - place, point.toward) + 1.001F * sphere.radius;
  const Vec3 origin = place + point.toward * std::max(way, 0.F);
  light.start(*x.light, point, {origin, w}, x.light->medium);
  return true;
}

std::optional<Kept> CausticPerturbation::propose(const Path& x, std::uint64_t key, Path& y) {
  const int from = start_of_chain(x);
  const Kept kept{from + 1, 1};
  BootstrapSource source(key, 0);
  growing_.begin(x, kept.light, kept.camera);
  GrowingEnd& light = growing_.light;
  const bool made = [&] {
    const Vec2 u = source.get_pair({Stream::Light, from, Slot::BsdfDirectionX});
    if (!set_off(x, from, u) || !light.arrive(source)) return false;
    for (int vertex = from + 1; vertex < x.depth() - 1; ++vertex) {
      if (!light.follow(x.vertex(vertex).event) || !light.arrive(source)) return false;
    }
    return growing_.finish(y);
  }();
  rays_ = growing_.ray_counts();
  return made ? std::optional(kept) : std::nullopt;
}

double CausticPerturbation::log_density(const Path& x, const Path& y, const Kept& kept) const {
  const int k = y.depth();
  const int from = kept.light - 1;
  if (y.vertex(k - 1).event.specular() || !same_events(x, y, from + 1, k - 2) ||
      (from > 0 && y.vertex(from).event.specular()) || !inside_image(scene_, y.raster)) {
    return kNever;
  }
  const PerturbationLaw steps = law(x, from);
  LogDensity density;
  if (moves_place(x, from)) {
    const Vec3d w(x.light_point.toward);
    const Vec3d shift = Vec3d(y.position(1)) - Vec3d(x.position(1));
    const double size = (shift - w * shift.dot(w)).length();
    if (!steps.reaches(size)) return kNever;
    density += steps.log_density_in_plane(size);
  } else {
    const double size = small_angle(x.toward_camera(scene_, from), y.toward_camera(scene_, from));
    if (!steps.reaches(size)) return kNever;
    density += steps.log_density_around(size);
  }
  for (int vertex = from; vertex < k - 1; ++vertex) {
    density *= arrival_pdf(scene_, y, vertex, vertex + 1);
    if (vertex > from) density /= specular_spread(scene_, y, vertex);
  }
  return density.value();
}

}  // namespace ajar
