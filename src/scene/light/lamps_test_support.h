#pragma once
#include "scene/light/light_test_support.h"

namespace ajar::testing {

/// Lights and the surfaces they are on.
struct Lamps {
  std::vector<std::unique_ptr<SurfaceSampler>> surfaces;
  LightList lights;

  void add(std::unique_ptr<Light> light) {
    light->index = static_cast<std::uint32_t>(lights.size());
    lights.push_back(std::move(light));
  }
  void add(std::unique_ptr<SurfaceSampler> surface, const desc::Emission& emission) {
    surfaces.push_back(std::move(surface));
    add(make_surface_light(emission, *surfaces.back(), {}));
  }
};

inline Vec3 random_point(Rng& rng, float half_side) {
  const float x = rng.next();
  const float y = rng.next();
  const float z = rng.next();
  return (Vec3(x, y, z) * 2.F - Vec3(1.F)) * half_side;
}
inline Vec3 random_axis(Rng& rng) { return warp::uniform_sphere(next_pair(rng)); }

/// `count` lights at finite places in a cube of the given half side: point lights, spots of any
/// angle in stretched spaces, projectors, quads with one or two sides, balls. Sizes and powers
/// differ by orders of magnitude.
inline Lamps random_lamps(Rng& rng, int count, float half_side) {
  Lamps lamps;
  for (int i = 0; i < count; ++i) {
    const Vec3 p = random_point(rng, half_side);
    const float strength = std::exp(4.F * rng.next());
    const desc::Rgb rgb{strength, strength * rng.next(), strength * rng.next()};
    const float size = half_side * 0.2F * std::exp(-6.F * rng.next());
    const float fov = 10.F + 150.F * rng.next();
    const float edge = 1.F + 179.F * rng.next();
    const float inner = edge * rng.next();
    const Vec3 edge_u = random_axis(rng) * size;
    const Vec3 edge_v = random_axis(rng) * size;
    Mat4 place;
    place.rotate(Vec3d(random_axis(rng) * 3.F));
    place.scale(Vec3d(1.0, 0.4 + rng.next(), 0.4 + rng.next()));
    place[3][0] = static_cast<double>(p.x);
    place[3][1] = static_cast<double>(p.y);
    place[3][2] = static_cast<double>(p.z);
    switch (i % 6) {
      case 0:
        lamps.add(light_of(point_node(rgb), place));
        break;
      case 1:
        lamps.add(light_of(spot_node(rgb, edge, inner), place));
        break;
      case 2:
        lamps.add(light_of(projection_node(rgb, fov), place));
        break;
      case 3:
      case 4:
        lamps.add(std::make_unique<Quad>(p, edge_u, edge_v), area_light(rgb, i % 6 == 4));
        break;
      default:
        lamps.add(std::make_unique<Ball>(p, size), area_light(rgb));
    }
  }
  return lamps;
}

}  // namespace ajar::testing
