#include <fmt/format.h>

#include "core/random.h"
#include "measuring/job.h"
#include "scene/desc/models.h"
#include "scene/scene.h"

/// Time per sample with 10 000 emitters over that with 10, and the variance of the light tree over
/// that of choosing lights by power.
namespace ajar::bench {
namespace {

constexpr int kQuads = 10'000;
constexpr int kPairs = 5;

std::shared_ptr<const desc::Mesh> quad(const Vec3& p, const Vec3& u, const Vec3& v) {
  auto mesh = std::make_shared<desc::Mesh>();
  mesh->positions = {p, p + u, p + u + v, p + v};
  mesh->indices.emplace_back(0, 1, 2);
  mesh->indices.emplace_back(0, 2, 3);
  return mesh;
}

/// A room with 10 000 small quads that hang in it at random, every one or every thousandth of which
/// emits. The geometry and the emitted power are the same for any number.
desc::SceneDesc room(int emitters) {
  desc::SceneDesc scene;
  scene.materials.emplace_back().node = desc::material_node("diffuse");
  const auto add = [&](std::shared_ptr<const desc::Mesh> mesh) -> desc::Shape& {
    desc::Shape shape;
    shape.node = desc::mesh_node(std::move(mesh));
    shape.material = 0;
    scene.shapes.push_back(std::move(shape));
    return scene.shapes.back();
  };
  const Vec3 x(8.F, 0.F, 0.F);
  const Vec3 y(0.F, 8.F, 0.F);
  const Vec3 z(0.F, 0.F, 8.F);
  const Vec3 low(-4.F, -4.F, -4.F);
  for (const auto& [u, v] : {std::pair{x, y}, std::pair{y, z}, std::pair{z, x}}) {
    add(quad(low, u, v));
    add(quad(low + x + y + z, -u, -v));
  }
  Rng rng(1);
  const auto random = [&] {
    const float a = rng.next() - 0.5F;
    const float b = rng.next() - 0.5F;
    return Vec3(a, b, rng.next() - 0.5F);
  };
  for (int i = 0; i < kQuads; ++i) {
    const Vec3 p = random() * 7.8F;
    const Vec3 u = random() * 0.05F;
    const Vec3 v = random() * 0.05F;
    desc::Shape& shape = add(quad(p, u, v));
    if (i % (kQuads / emitters) != 0) continue;
    const float radiance = 1e5F / static_cast<float>(emitters);
    shape.emission = desc::Emission{
        {}, desc::emission_node("area", {{"radiance", Vec3(radiance)}, {"two_sided", true}})};
  }
  scene.film.resolution = Vec2i(128, 128);
  desc::PerspectiveCamera lens;
  lens.fov = 80.F;
  scene.camera.node = lens;
  return scene;
}

/// Σ value² / probability over the lights at random places, by tree over by power, both less the
/// square of the mean: the remaining part of the variance of choosing a light.
double variance_left(const Scene& scene) {
  Rng rng(2);
  double by_tree = 0.0;
  double by_power = 0.0;
  for (int i = 0; i < 50; ++i) {
    const float x = rng.next();
    const float y = rng.next();
    const Vec3 at = (Vec3(x, y, rng.next()) - Vec3(0.5F)) * 8.F;
    double mean = 0.0;
    double tree = 0.0;
    double power = 0.0;
    for (const auto& light : scene.lights()) {
      const auto sample = light->sample_connection(at, {0.5F, {0.5F, 0.5F}});
      if (!sample) continue;
      const auto value = static_cast<double>(luminance(sample->weight));
      const LightSampler& sampler = scene.light_sampler();
      mean += value;
      tree += value * value / static_cast<double>(sampler.probability(at, *light).value());
      power += value * value / static_cast<double>(sampler.emitter_probability(*light).value());
    }
    if (!(mean > 0.0)) continue;
    by_tree += tree / (mean * mean) - 1.0;
    by_power += power / (mean * mean) - 1.0;
  }
  return by_tree / by_power;
}

void measure_many_lights() {
  Warnings warnings;
  const Scene few(room(10), {}, warnings);
  const Scene many(room(kQuads), {}, warnings);
  const Job few_job = make_job(few, parse_variant("pt"), 8);
  const Job many_job = make_job(many, parse_variant("pt"), 8);
  std::vector<double> ratios;
  double rays_few = 0.0;
  double rays_many = 0.0;
  for (int i = 0; i < kPairs; ++i) {
    const double few_seconds =
        seconds([&] { rays_few = static_cast<double>(few_job.run(0, few_job.items).rays); });
    const double many_seconds =
        seconds([&] { rays_many = static_cast<double>(many_job.run(0, many_job.items).rays); });
    ratios.push_back(many_seconds / few_seconds);
  }
  fmt::print(
      "10 000 emitters over 10: time per sample {:.2f} ({:.2f}–{:.2f}), rays per sample {:.2f}\n"
      "variance of the choice by tree over by power: {:.4f} with 10, {:.4f} with 10 000\n",
      median(ratios), *std::min_element(ratios.begin(), ratios.end()),
      *std::max_element(ratios.begin(), ratios.end()), rays_many / rays_few, variance_left(few),
      variance_left(many));
}

}  // namespace
}  // namespace ajar::bench

int main() {
  ajar::bench::measure_many_lights();
  return 0;
}
