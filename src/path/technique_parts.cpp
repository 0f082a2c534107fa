#include "path/technique_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "path/measure.h"

namespace ajar {

namespace {
constexpr double kNever = -std::numeric_limits<double>::infinity();
}  // namespace

std::span<const TechniqueParts::Part> TechniqueParts::of(const Path& path, double log_light) {
  find_densities(path);
  const double power = settings_.heuristic == Heuristic::Power ? 2.0 : 1.0;
  double largest = kNever;
  for (const LogDensity& density : densities_) {
    const ByLane log = density.by_lane();
    largest = std::max({largest, log.x, log.y, log.z});
  }
  parts_.assign(densities_.size(), {});
  if (!std::isfinite(largest)) return parts_;
  double sum = 0.0;
  for (std::size_t s = 0; s < parts_.size(); ++s) {
    const ByLane log = (densities_[s].by_lane() - ByLane(largest)) * power;
    parts_[s].weight = mean(ByLane(std::exp(log.x), std::exp(log.y), std::exp(log.z)));
    sum += parts_[s].weight;
  }
  for (std::size_t s = 0; s < parts_.size(); ++s) {
    Part& part = parts_[s];
    part.weight /= sum;
    if (part.weight > 0.0) {
      part.light = part.weight * std::exp(log_light + spreads_[s] - densities_[s].value());
    }
  }
  return parts_;
}

void TechniqueParts::find_densities(const Path& path) {
  const int k = path.depth();
  const auto at = [](int s) { return static_cast<std::size_t>(s); };
  LogDensity never;
  never *= 0.0;
  densities_.assign(at(k) + 1, never);
  spreads_.assign(at(k) + 1, 0.0);
  const bool inside = inside_image(scene_, path.raster);
  const auto is_specular = [&](int x) {
    return x >= 1 && x < k && path.vertex(x).event.specular();
  };
  const auto makes = [&](int s) {
    if (!settings_.techniques.enabled({s, k + 1 - s})) return false;
    if (s == 0) return !path.light->discrete_position();
    return k > 1 && (s < k || inside) && !is_specular(s - 1) && !is_specular(s);
  };
  // From the camera: k + 1 − s vertices, so fewer as s grows.
  LogDensity camera;
  for (int s = k; s >= 0; --s) {
    camera *= camera_step_pdf(scene_, path, s);
    if (makes(s)) densities_[at(s)] = camera;
  }
  if (makes(1)) densities_[1] *= next_event_pdf(scene_, path);
  if (settings_.techniques.needs_light_subpath()) {
    LogDensity light;
    light *= light_step_pdf(scene_, path, 0);
    double spread = 0.0;
    for (int s = 2; s <= k; ++s) {
      light *= light_step_pdf(scene_, path, s - 1);
      if (is_specular(s - 2)) spread += std::log(specular_spread(scene_, path, s - 2));
      densities_[at(s)] *= light;
      spreads_[at(s)] = spread;
    }
  }
  for (int s = 0; s <= k; ++s) {
    LogDensity& density = densities_[at(s)];
    // A product of 0 and infinity is the density of nothing.
    if (makes(s) && !std::isnan(density.value())) {
      density *= tries(settings_, {s, k + 1 - s});
    } else {
      density = never;
    }
  }
}

}  // namespace ajar
