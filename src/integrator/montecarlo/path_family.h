#pragma once
#include <optional>

#include "integrator/division.h"
#include "integrator/integrator.h"
#include "integrator/montecarlo/efficient_roulette.h"
#include "integrator/montecarlo/path_parameters.h"
#include "integrator/outlier_paths.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Defaults of a family member's parameters.
struct PathFamilyDefaults {
  std::string techniques;
  double light_paths_per_pixel = 1.0;
  int roulette_start = 5;
};
/// Defaults of the member with these techniques, or suitable ones if none has them.
PathFamilyDefaults path_family_defaults(const std::string& techniques);
std::vector<ParameterSpec> path_family_parameters(const PathFamilyDefaults& defaults);

/// Approximate brightness of a picture.
struct PictureScale {
  double mean;             ///< largest lane, to within a small factor; above 0
  double median_of_means;  ///< mean without fireflies; may be 0
};
/// From a few thousand samples of the integrator that the same arguments make.
PictureScale measure_scale(const Scene& scene, const RenderSettings& settings,
                           const Parameters& parameters);

/// Settings of its path sampler. Raises UsageError if the parameter `techniques` cannot be read.
PathSamplerSettings sampler_settings(const RenderSettings& settings, const Parameters& parameters);
/// True if light subpaths are connected to the lens only, and so belong to no camera sample.
bool light_alone(const TechniqueSet& techniques);

/// Inputs of ordinary Monte Carlo from others that render the same picture; pointers must outlive
/// it.
struct PathIntegratorContext {
  /// With these, it leaves Markov chains their share of long paths and puts its own into the layer
  /// `kWeakLayer`.
  const Divisions* divisions = nullptr;
  const OutlierSinkFactory* strong = nullptr;  ///< see what it leaves to chains
  /// Saves rays, and learns; its rounds are ended by whoever gives it. Without, the parameter
  /// `roulette` decides.
  EfficientRoulette* roulette = nullptr;
  std::optional<PictureScale> scale{};  ///< measured unless it is known
  bool joins_by_manifolds = false;      ///< see `blind_spots`
  /// Chains may make what is left to them, or nothing: roulette learns from all light.
  bool is_undecided = false;
};

/// Ordinary Monte Carlo with one set of techniques (docs/methods/bidirectional.md): `pt`, `lt`,
/// `ibpt`, `bdpt` are four names of it. Raises UsageError if the parameter `techniques` cannot be
/// read.
std::unique_ptr<Integrator> make_path_integrator(const Scene& scene, const RenderSettings& settings,
                                                 const Parameters& parameters,
                                                 const PathIntegratorContext& context = {});

}  // namespace ajar
