#include "mcmc/path_space/bidirectional_mutation.h"

#include <algorithm>
#include <cmath>

#include "core/random_use.h"
#include "mcmc/counter_random.h"
#include "mcmc/path_space/heuristics.h"
#include "mcmc/path_space/path_form.h"
#include "mcmc/primary/bootstrap_source.h"
#include "path/log_density.h"
#include "path/measure.h"

namespace ajar {

namespace {

/// Weight of removing so many vertices from a path that has more; not normalised.
double removal_weight(int vertices) {
  if (vertices == 0) return PathSpaceHeuristics::kNoVertex;
  if (vertices == 1) return PathSpaceHeuristics::kOneVertex;
  return std::ldexp(1.0, -vertices - 1);
}

/// Σ of these weights for up to `depth` vertices.
double removal_total(int depth) {
  double total = 0.0;
  for (int r = 0; r <= depth; ++r) total += removal_weight(r);
  return total;
}

/// Where so many vertices can be taken of a path of `depth` edges: the numbers that are kept at the
/// light, from `first` to `last`. At least one vertex is kept at each end that no vertex is taken
/// of.
struct Places {
  int first;
  int last;
  int count() const { return last - first + 1; }
};
Places places(int depth, int removed) {
  return {std::max(0, 1 - removed), std::min(depth, depth + 1 - removed)};
}

}  // namespace

BidirectionalMutation::BidirectionalMutation(const Scene& scene, const RasterArea& area,
                                             const Depths& depths)
    : scene_(scene), area_(area), depths_(depths), growing_(scene, area) {}

// ---------------------------------------------------------------- choices

std::optional<Kept> BidirectionalMutation::choose_kept(int depth, double u, double place) const {
  if (u < PathSpaceHeuristics::kWholePath) return Kept{0, 0};
  double left = (u - PathSpaceHeuristics::kWholePath) / (1.0 - PathSpaceHeuristics::kWholePath) *
                removal_total(depth);
  for (int r = 0; r <= depth; ++r) {
    left -= removal_weight(r);
    if (left > 0.0 && r < depth) continue;
    const Places all = places(depth, r);
    const int light = all.first + std::min(static_cast<int>(place * all.count()), all.count() - 1);
    return Kept{light, depth + 1 - r - light};
  }
  return std::nullopt;
}

double BidirectionalMutation::kept_probability(int depth, const Kept& kept) const {
  if (kept.light == 0 && kept.camera == 0) return PathSpaceHeuristics::kWholePath;
  const int removed = depth + 1 - kept.light - kept.camera;
  const Places all = places(depth, removed);
  if (removed < 0 || kept.light < all.first || kept.light > all.last) return 0.0;
  return (1.0 - PathSpaceHeuristics::kWholePath) * removal_weight(removed) / removal_total(depth) /
         all.count();
}

BidirectionalMutation::Joints BidirectionalMutation::joints(int depth, const Kept& kept) {
  // Paths of one edge are made by running into the light only.
  if (depth == 1) return kept.light == 0 ? Joints{0, 0} : Joints{1, 0};
  // The direction in which a given point of a light emits cannot be sampled by itself.
  if (kept.light == 1) return {1, 1};
  // Nothing runs into the lens.
  return {kept.light, std::min(depth, depth + 1 - kept.camera)};
}

double BidirectionalMutation::depth_weight(int from, int to, const Kept& kept) const {
  const int added = to + 1 - kept.light - kept.camera;
  const int change = std::abs(to - from);
  // Without its light a path lacks a vertex at least.
  if (to < depths_.min || to > depths_.max || added < (kept.light == 0 ? 1 : 0) ||
      change > PathSpaceHeuristics::kMostEdgesAtOnce || joints(to, kept).count() == 0) {
    return 0.0;
  }
  // No vertex for none is the same path.
  if (change == 0) return added == 0 ? 0.0 : PathSpaceHeuristics::kSameDepth;
  return change == 1 ? PathSpaceHeuristics::kNextDepth
                     : PathSpaceHeuristics::kOtherDepth * std::ldexp(1.0, -change);
}

double BidirectionalMutation::depth_probability(int from, int to, const Kept& kept) const {
  const double own = depth_weight(from, to, kept);
  if (own == 0.0) return 0.0;
  constexpr int kFar = PathSpaceHeuristics::kMostEdgesAtOnce;
  double total = 0.0;
  for (int depth = from - kFar; depth <= from + kFar; ++depth) {
    total += depth_weight(from, depth, kept);
  }
  return own / total;
}

std::optional<int> BidirectionalMutation::choose_depth(int from, const Kept& kept, double u) const {
  constexpr int kFar = PathSpaceHeuristics::kMostEdgesAtOnce;
  double total = 0.0;
  for (int depth = from - kFar; depth <= from + kFar; ++depth) {
    total += depth_weight(from, depth, kept);
  }
  double left = u * total;
  std::optional<int> chosen;
  for (int depth = from - kFar; depth <= from + kFar; ++depth) {
    const double own = depth_weight(from, depth, kept);
    if (own == 0.0) continue;
    chosen = depth;
    if (left < own) break;
    left -= own;
  }
  return chosen;
}

// ---------------------------------------------------------------- proposals

bool BidirectionalMutation::grow(const Path& x, const Kept& kept, int depth, int s,
                                 SampleSource& source) {
  growing_.begin(x, kept.light, kept.camera);
  GrowingEnd& light = growing_.light;
  GrowingEnd& camera = growing_.camera;
  const int t = depth + 1 - s;
  if (kept.light == 0 && s >= 2) {
    if (!growing_.emit(source) || !light.arrive(source)) return false;
  }
  while (light.size() > 1 && light.size() < s) {
    if (!light.scatter(source) || !light.arrive(source)) return false;
  }
  if (kept.camera == 0) growing_.choose_lens(source);
  while (camera.size() < t) {
    const bool is_last = camera.size() + 1 == t && s == 0;
    const bool left =
        camera.size() == 1
            ? growing_.look(area_.raster(source.get_pair({Stream::Camera, 0, kEmissionDirection})))
            : camera.scatter(source);
    if (!left) return false;
    if (is_last) return growing_.run_into_light(source);
    if (!camera.arrive(source)) return false;
  }
  return kept.light > 0 || s != 1 || growing_.choose_light(source);
}

std::optional<Kept> BidirectionalMutation::propose(const Path& x, std::uint64_t key, Path& y) {
  const auto number = [key](std::uint64_t index) {
    return to_unit_double(counter_bits(key, index));
  };
  const auto kept = choose_kept(x.depth(), number(0), number(1));
  if (!kept) return std::nullopt;
  const auto depth = choose_depth(x.depth(), *kept, number(2));
  if (!depth) return std::nullopt;
  const Joints all = joints(*depth, *kept);
  const int s = all.first + std::min(static_cast<int>(number(3) * all.count()), all.count() - 1);
  BootstrapSource source(key, 0);
  const bool made = grow(x, *kept, *depth, s, source) && growing_.finish(y);
  growing_ray_counts_ = growing_.ray_counts();
  return made ? kept : std::nullopt;
}

// ---------------------------------------------------------------- densities

double BidirectionalMutation::log_joint(const Path& y, const Kept& kept, int s) const {
  const int k = y.depth();
  for (const int x : {s - 1, s}) {
    if (s > 0 && x >= 1 && x < k && y.vertex(x).event.specular()) return kNever;
  }
  if (s == 0 && y.light->discrete_position()) return kNever;
  // Seen from a place on the lens.
  if (s == k && kept.camera <= 1 && !inside_image(scene_, y.raster)) return kNever;
  LogDensity density;
  for (int x = kept.light; x < s; ++x) {
    if (s == 1) {
      density *= next_event_pdf(scene_, y);
      break;
    }
    density *= light_step_pdf(scene_, y, x);
    // Where there is no such event, there is no spread either.
    if (density.value() == kNever) return kNever;
    if (x >= 2 && y.vertex(x - 1).event.specular()) {
      density /= specular_spread(scene_, y, x - 1);
    }
  }
  for (int x = k - kept.camera; x >= s; --x) {
    density *= camera_step_pdf(scene_, y, x);
    if (x == k - 1) {
      density *= image_area(scene_.camera().resolution()) / area_.area();
    }
  }
  return s == 0 ? density.value() + log_choice_of_hit_light(scene_, y) : density.value();
}

double BidirectionalMutation::log_density(const Path& x, const Path& y, const Kept& kept) const {
  const Joints all = joints(y.depth(), kept);
  const double choice = kept_probability(x.depth(), kept) *
                        depth_probability(x.depth(), y.depth(), kept) / all.count();
  if (!(choice > 0.0)) return kNever;
  double largest = kNever;
  std::vector<double> ways;
  for (int s = all.first; s <= all.last; ++s) {
    ways.push_back(log_joint(y, kept, s));
    // The sum is unknown if one term is.
    if (std::isnan(ways.back())) return ways.back();
    largest = std::max(largest, ways.back());
  }
  if (!std::isfinite(largest)) return largest;
  double sum = 0.0;
  for (const double way : ways) sum += std::exp(way - largest);
  return std::log(choice) + largest + std::log(sum);
}

}  // namespace ajar
