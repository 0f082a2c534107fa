#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/parameters.h"
#include "integrator/integrator.h"
#include "integrator/metropolis/path_group.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/regions/user_regions.h"
#include "mcmc/primary/primary_kernel.h"

namespace ajar {

/// Settings of a render by `selective`: its parameters, read and checked. Immutable.
struct SelectiveConfig {
  /// Picture whose error is to be least.
  enum class Objective {
    Filtered,  ///< the filtered picture
    Raw        ///< the picture as rendered
  };
  /// Use of the samples from which the division is decided.
  enum class PilotSamples {
    CrossFit,  ///< kept; each half of the replicates has the division of the other half's samples
    Discard
  };

  static std::vector<ParameterSpec> parameters();
  /// Raises UsageError, SceneError (rules) or IoError (files).
  SelectiveConfig(const Scene& the_scene, const RenderSettings& render_settings,
                  const Parameters& parameters);

  std::uint64_t pixels() const;  ///< number in the crop
  /// Tests for light that ordinary Monte Carlo and chains may share: paths of more than two edges.
  bool has_long_paths() const;

  const Scene& scene;
  RenderSettings settings;
  ChainSpace kind;  ///< OnePath, ExplicitPath or ByPath
  Objective objective;
  PilotSamples pilot;
  std::uint64_t pilot_samples;  ///< per pixel, at least
  std::string roulette;         ///< parameter
  bool antialias;               ///< along edges where the division has a step
  UserRegions regions;
  PathFamilyDefaults omc;   ///< techniques of both halves, unless a pilot chooses
  bool chooses_techniques;  ///< a pilot does
  bool chooses_division;    ///< a pilot does, without a word of the user
  /// T that regions choose from, relative to the brightness, ascending.
  std::vector<double> thresholds;
  double fireflies_threshold;  ///< T of chains that make fireflies only, relative to the brightness
  bool relative_importance;    ///< importance follows the pilot's brightness
  ChainView view;              ///< with the importance, unless that is relative
  std::shared_ptr<const Mutation> mutation;  ///< mutation of primary numbers
  PrimarySettings moves;
  std::vector<double> path_mutations;  ///< weights, of chains of explicit paths
};

}  // namespace ajar
