#include "mcmc/path_space/lens_perturbation.h"

#include <cmath>
#include <limits>

#include "mcmc/path_space/path_form.h"
#include "mcmc/primary/bootstrap_source.h"
#include "path/measure.h"

namespace ajar {

LensPerturbation::LensPerturbation(const Scene& scene, const RasterArea& area)
    : scene_(scene),
      area_(area),
      law_(raster_law(scene.camera().resolution())),
      growing_(scene, area) {}

bool LensPerturbation::suitable(const Path& path) const {
  const int rough = first_rough_from_camera(path);
  return rough > 0 && can_join(path, rough);
}

std::optional<Kept> LensPerturbation::propose(const Path& x, std::uint64_t key, Path& y) {
  const int rough = first_rough_from_camera(x);
  const Kept kept{rough, 1};
  BootstrapSource source(key, 0);
  const Vec2 raster =
      x.raster + law_.in_plane(source.get_pair({Stream::Camera, 0, kEmissionDirection}));
  if (!area_.contains(raster)) return std::nullopt;
  growing_.begin(x, kept.light, kept.camera);
  GrowingEnd& camera = growing_.camera;
  const bool made = [&] {
    if (!growing_.look(raster) || !camera.arrive(source)) return false;
    for (int vertex = x.depth() - 1; vertex > rough; --vertex) {
      if (!camera.follow(x.vertex(vertex).event) || !camera.arrive(source)) return false;
    }
    return growing_.finish(y);
  }();
  rays_ = growing_.ray_counts();
  return made ? std::optional(kept) : std::nullopt;
}

double LensPerturbation::log_density(const Path& x, const Path& y, const Kept& kept) const {
  constexpr double kNever = -std::numeric_limits<double>::infinity();
  const int k = y.depth();
  const int rough = kept.light;
  if (!same_events(x, y, rough + 1, k - 1) || !can_join(y, rough)) return kNever;
  const Vec2i pixels = scene_.camera().resolution();
  double sum = law_.log_density_in_plane(static_cast<double>((y.raster - x.raster).length())) +
               std::log(static_cast<double>(pixels.x) * static_cast<double>(pixels.y)) +
               std::log(camera_step_pdf(scene_, y, k - 1));
  for (int vertex = k - 1; vertex > rough; --vertex) {
    sum += std::log(arrival_pdf(scene_, y, vertex, vertex - 1));
  }
  return sum;
}

}  // namespace ajar
