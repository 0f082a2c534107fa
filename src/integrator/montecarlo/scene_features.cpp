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

Sight look_at(const Scene& scene, SampleSource& source, const Vec2& raster, int max_depth) {
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

std::uint32_t feature_rays(std::uint64_t samples) {
  return static_cast<std::uint32_t>(std::clamp<std::uint64_t>(
      samples / MonteCarloHeuristics::kSamplesForFeatureRay,
      MonteCarloHeuristics::kFewestFeatureRays, MonteCarloHeuristics::kMostFeatureRays));
}

FeatureTracer::FeatureTracer(const Scene& scene, RenderSettings settings)
    : scene_(scene),
      settings_(std::move(settings)),
      size_(settings_.crop.size() + Vec2i(1, 1)),
      rays_(static_cast<std::size_t>(size_.y)) {
  const std::size_t values = 3 * rays_.size() * static_cast<std::size_t>(size_.x);
  sums_ = {std::vector<float>(values), std::vector<float>(values)};
}

void FeatureTracer::trace_row(int y, std::uint32_t rays) {
  const std::uint64_t seed = hash_numbers(settings_.seed, RandomUse::Features);
  std::uint32_t& done = rays_[static_cast<std::size_t>(y)];
  std::size_t index = 3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x);
  for (int x = 0; x < size_.x; ++x, index += 3) {
    const Vec2i pixel = settings_.crop.min + Vec2i(x, y);
    const std::uint64_t own = hash_numbers(seed, pixel.x, pixel.y);
    for (std::uint32_t i = done; i < rays; ++i) {
      SobolSource source({own, i, own, i});
      const Vec2 offset = source.get_pair({Stream::Camera, 0, kEmissionDirection});
      const Sight sight = look_at(scene_, source, Vec2(pixel) + offset, settings_.max_depth);
      for (int c = 0; c < 3; ++c) {
        const std::size_t value = index + static_cast<std::size_t>(c);
        if (sight.albedo.is_finite()) sums_.albedo[value] += sight.albedo[c];
        sums_.normal[value] += sight.normal[c];
      }
    }
  }
  done = std::max(done, rays);
}

bool FeatureTracer::trace(std::uint32_t rays, const Progress& progress) {
  const std::lock_guard lock(mutex_);
  std::atomic<int> rows = 0;
  std::atomic<bool> ended = false;
  parallel_for(size_.y, [&](int y) {
    if (ended) return;
    trace_row(y, rays);
    const double done = static_cast<double>(++rows) / size_.y;
    if (progress && !progress(done)) ended = true;
  });
  return !ended;
}

Features FeatureTracer::features() const {
  const std::lock_guard lock(mutex_);
  Features features = sums_;
  for (std::size_t value = 0; value < features.albedo.size(); ++value) {
    const std::size_t row = value / (3 * static_cast<std::size_t>(size_.x));
    const auto count = static_cast<float>(std::max(1U, rays_[row]));
    // After the mean: glints of a few rays are seen in the picture, too.
    features.albedo[value] = std::clamp(features.albedo[value] / count, 0.F, 1.F);
    features.normal[value] /= count;
  }
  return features;
}

std::optional<Features> FeatureTracer::look(std::uint32_t rays, const Progress& progress) {
  if (!trace(rays, progress)) return std::nullopt;
  return features();
}

}  // namespace ajar
