#include "mcmc/path_space/multi_chain_perturbation.h"

#include <cmath>
#include <limits>

#include "mcmc/path_space/heuristics.h"
#include "mcmc/path_space/path_form.h"
#include "mcmc/primary/bootstrap_source.h"
#include "path/measure.h"

namespace ajar {

namespace {

/// The first vertex from the camera that is joined to one that scatters by rough lobes, or to the
/// light; 0 if there is none, or if no other such vertex lies between.
int end_of_chains(const Path& path) {
  const int first = first_rough_from_camera(path);
  if (first == 0 || can_join(path, first)) return 0;
  int x = first - 1;
  while (x > 0 && !can_join(path, x)) --x;
  return x;
}

}  // namespace

MultiChainPerturbation::MultiChainPerturbation(const Scene& scene, const RasterArea& area)
    : scene_(scene),
      area_(area),
      raster_(raster_law(scene.camera().resolution())),
      direction_{PathSpaceHeuristics::kSmallestTurn, PathSpaceHeuristics::kLargestTurn},
      growing_(scene, area) {}

bool MultiChainPerturbation::suitable(const Path& path) const { return end_of_chains(path) > 0; }

std::optional<Kept> MultiChainPerturbation::propose(const Path& x, std::uint64_t key, Path& y) {
  const int end = end_of_chains(x);
  const Kept kept{end, 1};
  BootstrapSource source(key, 0);
  const Vec2 raster =
      x.raster + raster_.in_plane(source.get_pair({Stream::Camera, 0, kEmissionDirection}));
  if (!area_.contains(raster)) return std::nullopt;
  growing_.begin(x, kept.light, kept.camera);
  GrowingEnd& camera = growing_.camera;
  const bool made = [&] {
    if (!growing_.look(raster) || !camera.arrive(source)) return false;
    for (int vertex = x.depth() - 1; vertex > end; --vertex) {
      if (x.vertex(vertex).event.specular()) {
        if (!camera.follow(x.vertex(vertex).event)) return false;
      } else {
        const SampleAddress address(Stream::Camera, camera.size() - 1, Slot::BsdfDirectionX);
        camera.go(direction_.around(x.toward_light(scene_, vertex), source.get_pair(address)));
      }
      if (!camera.arrive(source)) return false;
    }
    return growing_.finish(y);
  }();
  rays_ = growing_.ray_counts();
  return made ? std::optional(kept) : std::nullopt;
}

double MultiChainPerturbation::log_density(const Path& x, const Path& y, const Kept& kept) const {
  constexpr double kNever = -std::numeric_limits<double>::infinity();
  const int k = y.depth();
  const int end = kept.light;
  if (!can_join(y, end)) return kNever;
  const Vec2i pixels = scene_.camera().resolution();
  double sum = raster_.log_density_in_plane(static_cast<double>((y.raster - x.raster).length())) +
               std::log(static_cast<double>(pixels.x) * static_cast<double>(pixels.y)) +
               std::log(camera_step_pdf(scene_, y, k - 1));
  for (int vertex = k - 1; vertex > end; --vertex) {
    const bool specular = x.vertex(vertex).event.specular();
    if (specular ? x.vertex(vertex).event != y.vertex(vertex).event
                 : y.vertex(vertex).event.specular()) {
      return kNever;
    }
    if (!specular) {
      sum += direction_.log_density_around(
          small_angle(x.toward_light(scene_, vertex), y.toward_light(scene_, vertex)));
    }
    sum += std::log(arrival_pdf(scene_, y, vertex, vertex - 1));
  }
  return sum;
}

}  // namespace ajar
