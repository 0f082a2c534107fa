#include "mcmc/path_space/path_form.h"

#include <cmath>

namespace ajar {

int first_rough_from_camera(const Path& path) {
  int x = path.depth() - 1;
  while (x > 0 && path.vertex(x).event.specular()) --x;
  return x;
}

int first_rough_from_light(const Path& path) {
  int x = 1;
  while (x < path.depth() && path.vertex(x).event.specular()) ++x;
  return x;
}

std::span<const InnerVertex> chain_from_light(const Path& path, int light_end, int camera_end) {
  return std::span(path.vertices)
      .subspan(static_cast<std::size_t>(light_end),
               static_cast<std::size_t>(camera_end - light_end - 1));
}

bool can_join(const Path& path, int x) {
  const auto is_rough = [&](int vertex) {
    return vertex == 0 || vertex == path.depth() || !path.vertex(vertex).event.specular();
  };
  return is_rough(x - 1) && is_rough(x);
}

bool is_hit_only(const Path& path) {
  for (int x = 1; x <= path.depth(); ++x) {
    if (can_join(path, x)) return false;
  }
  return true;
}

bool no_technique_makes(const Path& path) {
  return path.light->discrete_position() && is_hit_only(path);
}

double log_choice_of_hit_light(const Scene& scene, const Path& path) {
  const auto lights = static_cast<double>(scene.infinite_lights().size());
  return path.light->at_infinity() ? -std::log(lights) : 0.0;
}

bool same_events(const Path& a, const Path& b, int first, int last) {
  for (int x = first; x <= last; ++x) {
    if (!a.vertex(x).event.specular() || a.vertex(x).event != b.vertex(x).event) return false;
  }
  return true;
}

}  // namespace ajar
