#include "integrator/montecarlo/scene_features.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

#include "core/parallel_for.h"
#include "core/random_use.h"
#include "integrator/montecarlo/heuristics.h"
#include "transport/sources.h"
#include "transport/subpath.h"

namespace ajar {

namespace {

constexpr WalkSettings kWalk{.mode = TransportMode::Radiance,
                             .stream = Stream::Camera,
                             .heuristic = Heuristic::Balance,
                             .roulette_start = std::numeric_limits<int>::max(),
                             .has_other_end = false};

struct Sight {
  Spectrum albedo{0.F};
  Vec3 normal{0.F, 0.F, 0.F};
};

Spectrum at_most_one(const Spectrum& value) {
  const auto cut = [&](int lane) { return std::clamp(value[lane], 0.F, 1.F); };
  return {cut(0), cut(1), cut(2)};
}

Spectrum sky(const Scene& scene, const Vec3& direction) {
  Spectrum radiance(0.F);
  for (const Light* light : scene.infinite_lights()) {
    radiance += light->emitted(light->at_direction(direction), -direction);
  }
  return radiance;
}

/// Look of a surface: its emission where it has any, else its albedo.
Spectrum look_of(const PathVertex& vertex, const Hit& hit) {
  const Spectrum emitted =
      hit.light == nullptr ? Spectrum(0.F) : hit.light->emitted({hit.point, Vec3(0.F)}, vertex.wo);
  return vertex.bsdf.albedo(vertex.wo) + emitted;
}

Sight look(const Scene& scene, SampleSource& source, const Vec2& raster, int max_depth) {
  const Camera& camera = scene.camera();
  const std::optional<EmissionSample> emission = camera_ray(camera, source, raster);
  if (!emission) return {};
  Flight flight;
  flight.ray = {emission->origin, emission->w};
  flight.ray.passes_lights = scene.hides_lights();
  flight.medium = camera.medium;
  flight.reference = emission->point.surface.p;
  flight.from_infinity = camera.at_infinity();
  RayCounts rays;
  while (true) {
    const DistanceSource numbers(source, Stream::Camera, flight.edges + 1, 0);
    const SegmentEnd end =
        trace_segment(scene, flight.ray, flight.medium, flight.lanes, numbers, rays);
    if (end.lost) return {};
    if (!end.hit && !end.scattered) {
      return {flight.throughput * sky(scene, flight.ray.direction), Vec3(0.F)};
    }
    // Weighted as the visible part of the background: radiance alone is denser in glass.
    flight.throughput *= std::exchange(flight.roulette_scale, 1.F);
    PathVertex vertex;
    arrive(kWalk, flight, end, 0.0, vertex);
    if (vertex.in_medium) return {vertex.throughput, vertex.wo};
    const Sight sight{vertex.throughput * look_of(vertex, *end.hit),
                      face_forward(vertex.bsdf.ns(), vertex.wo)};
    if (end.hit->light != nullptr) return sight;
    if (!scatter(kWalk, vertex, source, flight)) return sight;
    if (!flight.event.specular()) return sight;
    // The picture is black where a path is still among mirrors then.
    if (vertex.edges >= max_depth) return {};
  }
}

}  // namespace

std::optional<Features> trace_features(const Scene& scene, const RenderSettings& settings,
                                       const std::function<bool(double done)>& progress,
                                       bool roughly) {
  const std::uint32_t samples = roughly ? 1 : MonteCarloHeuristics::kFeatureSamples;
  const Vec2i size = settings.crop.size() + Vec2i(1, 1);
  const std::size_t values =
      3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  Features features{std::vector<float>(values), std::vector<float>(values)};
  const std::uint64_t seed = hash_numbers(settings.seed, RandomUse::Features);
  std::atomic<int> rows = 0;
  std::atomic<bool> ended = false;
  parallel_for(size.y, [&](int y) {
    if (ended) return;
    for (int x = 0; x < size.x; ++x) {
      const Vec2i pixel = settings.crop.min + Vec2i(x, y);
      Spectrum albedo(0.F);
      Vec3 normal(0.F);
      for (std::uint32_t i = 0; i < samples; ++i) {
        const std::uint64_t own = hash_numbers(seed, pixel.x, pixel.y);
        SobolSource source({own, i, own, i});
        const Vec2 offset = source.get_pair({Stream::Camera, 0, kEmissionDirection});
        const Sight sight = look(scene, source, Vec2(pixel) + offset, settings.max_depth);
        if (sight.albedo.is_finite()) albedo += sight.albedo;
        normal += sight.normal;
      }
      // After the mean: glints of a few rays are seen in the picture, too.
      albedo = at_most_one(albedo / static_cast<float>(samples));
      const std::size_t first =
          3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
               static_cast<std::size_t>(x));
      for (int c = 0; c < 3; ++c) {
        const std::size_t index = first + static_cast<std::size_t>(c);
        features.albedo[index] = albedo[c];
        features.normal[index] = normal[c] / static_cast<float>(samples);
      }
    }
    const double done = static_cast<double>(++rows) / size.y;
    if (progress && !progress(done)) ended = true;
  });
  if (ended) return std::nullopt;
  return features;
}

}  // namespace ajar
