#include "integrator/selective/surface_pilot.h"

#include "core/random.h"
#include "core/random_use.h"
#include "image/identities.h"
#include "integrator/make_filter.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/regions/surface_edges.h"
#include "integrator/selective/heuristics.h"

namespace ajar {

namespace {
constexpr std::uint64_t kSamples = IdentityLayers::kSamples;
}  // namespace

double SurfacePilot::effort() const {
  return static_cast<double>(kSamples) / SelectiveHeuristics::kCameraRaysOfSample;
}

std::uint64_t SurfacePilot::begin() {
  RenderSettings settings = plan_.omc_settings();
  settings.seed = hash_numbers(settings.seed, RandomUse::SurfacePilot);
  settings.replicates = 1;
  settings.min_depth = 1;
  settings.max_depth = 1;
  settings.aovs = {"object-id", "material-id", "depth", "normal"};
  rays_ = make_path_integrator(plan_.scene, settings,
                               Parameters(path_family_parameters({.techniques = "implicit"}), {}));
  film_ = std::make_unique<Film>(settings.resolution, settings.crop,
                                 make_filter(plan_.scene.film().filter), 1, rays_->layers());
  return rays_->items_in_round();
}

void SurfacePilot::run(std::uint64_t item, Counters& counters) {
  Counters own;
  rays_->run_item(item, 0, kSamples, *film_, own);
  counters.add_rays(own);
}

void SurfacePilot::end() {
  const auto layer = [&](const char* name) {
    return film_->develop(film_->layer(name), 1.0 / static_cast<double>(kSamples));
  };
  const std::vector<float> triples = layer("depth");
  std::vector<float> depths;
  depths.reserve(triples.size() / 3);
  for (std::size_t i = 0; i < triples.size(); i += 3) depths.push_back(triples[i]);
  identities_ = majority_identities(*film_);
  edges_ = surface_edges({.size = Vec2i(film_->width(), film_->height()),
                          .identities = identities_,
                          .depths = depths,
                          .normals = layer("normal")});
  film_.reset();
  rays_.reset();
}

}  // namespace ajar
