#include "mcmc/path_space/manifold_seeds.h"

#include <cmath>

#include "core/random.h"
#include "mcmc/path_space/chain_density.h"
#include "mcmc/path_space/path_form.h"
#include "mcmc/path_space/path_mutation.h"
#include "path/log_density.h"
#include "path/measure.h"

namespace ajar {

namespace {

/// ln of the density with which the vertices from `seen` to the light are joined, were the chain
/// certain to be found.
double log_join_pdf(const Scene& scene, const Path& path, int seen) {
  const Light& light = *path.light;
  const Vec3& place = path.vertex(seen).p();
  // A side of a lamp that is turned away is never sampled from there, even with a positive density.
  const bool turns_away =
      !light.discrete_position() && !light.at_infinity() &&
      light.emitted(path.light_point, normalize(place - path.light_point.surface.p)).is_black();
  if (turns_away || !ManifoldConnection::is_clear(scene, path, seen)) return kNever;
  return std::log(double{light.connection_pdf(place, path.light_point).value()}) +
         std::log(double{scene.light_sampler().probability(place, light).value()}) +
         log_chain_density(scene, path, 0, seen);
}

/// ln of the density of a camera subpath as far as vertex `last`.
double log_camera_pdf(const Scene& scene, const Path& path, int last) {
  LogDensity density;
  for (int x = path.depth(); x >= last; --x) density *= camera_step_pdf(scene, path, x);
  return density.value();
}

/// Counterpart of `log_join_pdf` for a subpath that runs into the light.
double log_hit_pdf(const Scene& scene, const Path& path, int seen) {
  if (path.light->discrete_position()) return kNever;
  return log_camera_pdf(scene, path, 0) - log_camera_pdf(scene, path, seen);
}

/// The balance heuristic's weight of the first of two.
double balance(double log_first, double log_other) {
  return 1.0 / (1.0 + std::exp(log_other - log_first));
}

}  // namespace

double ManifoldSeeds::least_hit_share(const Scene& scene, const Path& path, double tries) {
  const int seen = first_rough_from_light(path);
  if (seen == path.depth() || seen == 1) return 1.0;
  const double join = log_join_pdf(scene, path, seen);
  return join > kNever ? balance(log_hit_pdf(scene, path, seen), join + std::log(tries)) : 1.0;
}

bool ManifoldSeeds::finds(const Scene& scene, const Path& path) {
  return is_hit_only(path) && least_hit_share(scene, path, 1.0) < 1.0;
}

std::span<const ManifoldSeeds::Seed> ManifoldSeeds::sample(SampleSource& source, const Vec2& raster,
                                                           std::uint64_t key) {
  seeds_.clear();
  if (scene_.light_sampler().empty()) return seeds_;
  GrowingEnd& camera = growing_.camera;
  growing_.choose_lens(source);
  if (!growing_.look(raster)) return seeds_;
  bool after_specular = false;
  // With a vertex of the chain, and the light.
  while (camera.size() + 2 <= bounds_.max_depth && camera.arrive(source)) {
    if (after_specular && camera.vertices.back().connectible()) {
      join(source, hash_numbers(key, static_cast<std::uint64_t>(camera.size())));
    }
    if (!camera.scatter(source)) break;
    const bool specular = camera.vertices.back().event.specular();
    // Such an edge a connection could make.
    if (!specular && !after_specular) break;
    after_specular = specular;
  }
  return seeds_;
}

void ManifoldSeeds::join(SampleSource& source, std::uint64_t key) {
  if (!growing_.choose_light(source)) return;
  const auto& light = static_cast<const Light&>(*growing_.light.endpoint);
  if (!connection_.find({light, growing_.light.point, growing_.camera.vertices.back(),
                         bounds_.max_depth - growing_.camera.size()},
                        key)) {
    return;
  }
  Path path;
  if (!growing_.finish_through(connection_.chain(), path) || path.depth() < bounds_.min_depth)
    return;
  const int vertex = first_rough_from_light(path);
  const double joined = log_join_pdf(scene_, path, vertex);
  if (!std::isfinite(joined)) return;
  const double hit = log_hit_pdf(scene_, path, vertex);
  const double tried = joined + std::log(tries_);
  const double log_factor =
      std::log(balance(tried, hit)) - joined - log_camera_pdf(scene_, path, vertex);
  seeds_.push_back({std::move(path), log_factor, balance(hit, tried), key});
}

double ManifoldSeeds::inverse_chance(const Seed& seed) {
  return inverse_chance(seed.path, seed.least_hit_share, seed.key);
}

double ManifoldSeeds::hit_share(const Path& path, std::uint64_t key) {
  const double least = least_hit_share(scene_, path, tries_);
  return least < 1.0 ? least * inverse_chance(path, least, key) : 1.0;
}

double ManifoldSeeds::inverse_chance(const Path& path, double least_hit_share, std::uint64_t key) {
  const int vertex = first_rough_from_light(path);
  const int camera_vertices = path.depth() + 1 - vertex;
  return connection_.inverse_chance(
      {*path.light, path.light_point, path.vertex(vertex), bounds_.max_depth - camera_vertices},
      chain_from_light(path, 0, vertex), 1.0 - least_hit_share, key);
}

RayCounts ManifoldSeeds::ray_counts() const {
  RayCounts rays = growing_.ray_counts();
  rays.add_rays(connection_.ray_counts());
  return rays;
}

}  // namespace ajar
