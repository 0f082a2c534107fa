#include "mcmc/path_space/manifold_perturbation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mcmc/path_space/heuristics.h"
#include "mcmc/path_space/path_form.h"
#include "mcmc/primary/bootstrap_source.h"
#include "path/measure.h"

namespace ajar {

namespace {

/// The vertices between two of a path, in the order from the camera.
void chain_from_camera(const Path& path, int light_end, int camera_end,
                       std::vector<InnerVertex>& chain) {
  chain.clear();
  for (int x = camera_end - 1; x > light_end; --x) chain.push_back(path.vertex(x));
}

std::span<const InnerVertex> chain_from_light(const Path& path, int light_end, int camera_end) {
  return std::span(path.vertices)
      .subspan(static_cast<std::size_t>(light_end),
               static_cast<std::size_t>(camera_end - light_end - 1));
}

double squared_distance(const Path& path, int x, int y) {
  const Vec3d d = Vec3d(path.position(y)) - Vec3d(path.position(x));
  return d.dot(d);
}

/// ln of the density with which the chain between two vertices, which are given, is what it is:
/// Π |cos θ| / d² of its edges over the chain's generalised geometric term (docs/methods/mlt.md).
double log_chain_density(const Scene& scene, const Path& path, int fixed, int moved) {
  std::vector<InnerVertex> chain;
  chain_from_camera(path, fixed, moved, chain);
  SpecularChain linear(scene);
  if (!linear.set(chain_end(scene, path, moved), chain, chain_end(scene, path, fixed))) {
    return kNever;
  }
  const double spread = linear.spread();
  if (!(spread > 0.0) || !std::isfinite(spread)) return kNever;
  double sum = -std::log(spread);
  for (int x = moved; x > fixed + 1; --x) {
    const Vec3 w = path.toward_light(scene, x);
    sum += std::log(double{path.vertex(x - 1).cosine(w)} / squared_distance(path, x, x - 1));
  }
  // The cosine there is in both, or in none.
  if (!chain_end(scene, path, fixed).at_infinity) {
    sum -= std::log(squared_distance(path, fixed + 1, fixed));
  }
  return sum;
}

}  // namespace

std::optional<ManifoldPerturbation::Span> ManifoldPerturbation::span_of(const Path& path) {
  const int moved = first_rough_from_camera(path);
  int fixed = moved - 1;
  while (fixed > 0 && path.vertex(fixed).event.specular()) --fixed;
  if (fixed < 0 || fixed == moved - 1) return std::nullopt;
  return Span{fixed, moved};
}

ManifoldPerturbation::ManifoldPerturbation(const Scene& scene, const RasterArea& area)
    : scene_(scene),
      area_(area),
      raster_(raster_law(scene.camera().resolution())),
      growing_(scene, area),
      walk_(scene) {}

bool ManifoldPerturbation::look(const Path& x, int moved, const Vec2& raster,
                                SampleSource& source) {
  GrowingEnd& camera = growing_.camera;
  if (!growing_.look(raster)) return false;
  for (int vertex = x.depth() - 1; vertex > moved; --vertex) {
    if (!camera.arrive(source) || !camera.follow(x.vertex(vertex).event)) return false;
  }
  return camera.arrive(source) && camera.vertices.back().connectible();
}

bool ManifoldPerturbation::leads_back(const Path& x, const Span& span, double uncertainty) {
  const auto old = chain_from_light(x, span.fixed, span.moved);
  const auto back = walk_.vertices();
  double step = 0.0;
  double shortest = std::numeric_limits<double>::infinity();
  double missed = 0.0;
  for (std::size_t i = 0; i < old.size(); ++i) {
    const Vec3d p(old[i].p());
    step = std::max(step, (Vec3d(chain_[i].p()) - p).length());
    missed = std::max(missed, (Vec3d(back[i].p()) - p).length());
    shortest =
        std::min(shortest, std::sqrt(squared_distance(x, span.fixed + static_cast<int>(i) + 1,
                                                      span.fixed + static_cast<int>(i) + 2)));
  }
  return missed <= PathSpaceHeuristics::kWayBack * std::min(step, shortest) + 2.0 * uncertainty;
}

bool ManifoldPerturbation::walk(const Path& x, const Span& span, const InnerVertex& target) {
  const ChainStart start = chain_start(scene_, x, span.fixed);
  walk_end_ = WalkEnd::Lost;
  if (!walk_.walk(start, chain_from_light(x, span.fixed, span.moved), target.p())) return false;
  chain_.assign(walk_.vertices().begin(), walk_.vertices().end());
  const bool back =
      walk_.walk(start, chain_, x.position(span.moved)) && leads_back(x, span, walk_.uncertainty());
  walk_end_ = back ? WalkEnd::None : WalkEnd::OneWay;
  return back;
}

std::optional<Kept> ManifoldPerturbation::propose(const Path& x, std::uint64_t key, Path& y) {
  const Span span = *span_of(x);
  const Kept kept{span.fixed + 1, 1};
  walk_end_ = WalkEnd::None;
  BootstrapSource source(key, 0);
  const Vec2 raster =
      x.raster + raster_.in_plane(source.get_pair({Stream::Camera, 0, kEmissionDirection}));
  if (!area_.contains(raster)) return std::nullopt;
  growing_.begin(x, kept.light, kept.camera);
  const bool made = look(x, span.moved, raster, source) &&
                    walk(x, span, growing_.camera.vertices.back()) &&
                    growing_.finish_through(chain_, y);
  rays_ = growing_.ray_counts();
  rays_.add_rays(walk_.ray_counts());
  return made ? std::optional(kept) : std::nullopt;
}

double ManifoldPerturbation::log_density(const Path& x, const Path& y, const Kept& kept) const {
  const int k = y.depth();
  const auto span = span_of(y);
  const auto other = span_of(x);
  if (!span || !other || x.depth() != k || span->fixed != kept.light - 1 ||
      other->fixed != span->fixed || other->moved != span->moved ||
      !same_events(x, y, span->moved + 1, k - 1) ||
      !same_events(x, y, span->fixed + 1, span->moved - 1)) {
    return kNever;
  }
  const Vec2i pixels = scene_.camera().resolution();
  double sum = raster_.log_density_in_plane(static_cast<double>((y.raster - x.raster).length())) +
               std::log(static_cast<double>(pixels.x) * static_cast<double>(pixels.y)) +
               std::log(camera_step_pdf(scene_, y, k - 1));
  for (int vertex = k - 1; vertex > span->moved; --vertex) {
    sum += std::log(arrival_pdf(scene_, y, vertex, vertex - 1));
  }
  return sum + log_chain_density(scene_, y, span->fixed, span->moved);
}

}  // namespace ajar
