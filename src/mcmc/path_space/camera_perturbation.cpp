#include "mcmc/path_space/camera_perturbation.h"

#include <cmath>

#include "mcmc/path_space/heuristics.h"
#include "mcmc/path_space/path_form.h"
#include "mcmc/primary/bootstrap_source.h"
#include "path/log_density.h"
#include "path/measure.h"

namespace ajar {

std::optional<int> CameraPerturbation::end_at_light(const Path& path) {
  return path.light->discrete_position() ? std::nullopt : std::optional(0);
}

CameraPerturbation::CameraPerturbation(const Scene& scene, const RasterArea& area)
    : scene_(scene),
      area_(area),
      raster_(raster_law(scene.camera().resolution())),
      direction_{PathSpaceHeuristics::kSmallestTurn, PathSpaceHeuristics::kLargestTurn},
      growing_(scene, area) {}

bool CameraPerturbation::grow(const Path& x, int end, const Vec2& raster, SampleSource& source) {
  GrowingEnd& camera = growing_.camera;
  if (!growing_.look(raster)) return false;
  for (int vertex = x.depth() - 1; vertex >= end; --vertex) {
    if (vertex == 0) return growing_.run_into_light(source);
    if (!camera.arrive(source)) return false;
    if (vertex == end) return true;
    const ScatterEvent& event = x.vertex(vertex).event;
    if (!event.specular()) {
      const SampleAddress address(Stream::Camera, camera.size() - 1, Slot::BsdfDirectionX);
      camera.go(direction_.around(x.toward_light(scene_, vertex), source.get_pair(address)));
    } else if (!camera.follow(event)) {
      return false;
    }
  }
  return false;
}

std::optional<Kept> CameraPerturbation::propose(const Path& x, std::uint64_t key, Path& y) {
  const Kept kept{*end_of(x), 1};
  BootstrapSource source(key, 0);
  const Vec2 raster =
      x.raster + raster_.in_plane(source.get_pair({Stream::Camera, 0, kEmissionDirection}));
  if (!area_.contains(raster)) return std::nullopt;
  growing_.begin(x, kept.light, kept.camera);
  const bool made = grow(x, kept.light, raster, source) && growing_.finish(y);
  rays_ = growing_.ray_counts();
  return made ? std::optional(kept) : std::nullopt;
}

double CameraPerturbation::log_density(const Path& x, const Path& y, const Kept& kept) const {
  const int k = y.depth();
  const int end = kept.light;
  if (end > 0 && !can_join(y, end)) return kNever;
  LogDensity density;
  density += raster_.log_density_in_plane(static_cast<double>((y.raster - x.raster).length()));
  density *= image_area(scene_.camera().resolution());
  density *= camera_step_pdf(scene_, y, k - 1);
  for (int vertex = k - 1; vertex > end; --vertex) {
    const ScatterEvent& event = x.vertex(vertex).event;
    const ScatterEvent& other = y.vertex(vertex).event;
    if (event.specular() ? event != other : other.specular()) return kNever;
    if (!event.specular()) {
      density += direction_.log_density_around(
          small_angle(x.toward_light(scene_, vertex), y.toward_light(scene_, vertex)));
    }
    density *= arrival_pdf(scene_, y, vertex, vertex - 1);
  }
  return end == 0 ? density.value() + log_choice_of_hit_light(scene_, y) : density.value();
}

}  // namespace ajar
