#include "integrator/regions/surface_pilot.h"

#include <utility>

#include "core/random.h"
#include "core/random_use.h"
#include "image/identities.h"
#include "integrator/make_filter.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/regions/heuristics.h"
#include "integrator/regions/surface_edges.h"

namespace ajar {

namespace {
constexpr std::uint64_t kSamples = IdentityLayers::kSamples;
}  // namespace

SurfacePilot::SurfacePilot(const Scene& scene, RenderSettings settings)
    : scene_(scene), settings_(std::move(settings)) {
  settings_.seed = hash_numbers(settings_.seed, RandomUse::SurfacePilot);
  settings_.replicates = 1;
  settings_.min_depth = 1;
  settings_.max_depth = 1;
  settings_.aovs = {"object-id", "material-id", "depth", "normal"};
}

double SurfacePilot::effort() const {
  return static_cast<double>(kSamples) / RegionHeuristics::kCameraRaysOfSample;
}

std::uint64_t SurfacePilot::begin() {
  rays_ = make_path_integrator(scene_, settings_,
                               Parameters(path_family_parameters({.techniques = "implicit"}), {}));
  film_ = std::make_unique<Film>(settings_.resolution, settings_.crop,
                                 make_filter(scene_.film().filter), 1, rays_->layers());
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
  const Vec2i size(film_->width(), film_->height());
  const std::vector<PixelIdentity> identities = majority_identities(*film_);
  surfaces_ = {
      connected_regions(size, identities),
      surface_edges(
          {.size = size, .identities = identities, .depths = depths, .normals = layer("normal")})};
  film_.reset();
  rays_.reset();
}

}  // namespace ajar
