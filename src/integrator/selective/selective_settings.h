#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/parameters.h"
#include "integrator/integrator.h"
#include "integrator/regions/region_map.h"
#include "integrator/regions/region_rules.h"
#include "integrator/selective/pilot_use.h"

namespace ajar {

/// What `selective` is told beyond the parameters of its chains (docs/methods/selective.md).
struct SelectiveSettings {
  enum class Map {
    Optimal,  ///< of least predicted error
    Binary    ///< as published
  };

  /// Whose error is to become least.
  enum class Objective {
    Filtered,  ///< of the picture without noise
    Raw        ///< of the picture as it is rendered
  };

  /// Of a parameter that is left to a pilot.
  static constexpr const char* kOpen = "auto";

  Objective objective = Objective::Filtered;
  Map map = Map::Optimal;
  PilotUse pilot = PilotUse::Cross;
  std::uint64_t pilot_samples = 0;  ///< per pixel; 0: as many as suit the map
  RegionMapSettings binary{};
  bool adaptive = true;  ///< more camera samples where there is more noise (sample_rates.h)
  bool efficient_roulette = true;  ///< rays are saved where they bring little (ray_price.h)
  bool exclusive = false;          ///< each pixel's light is of one method alone
  bool diffuse_out = false;        ///< no chains where a pixel shows a diffuse material
  bool antialias = false;          ///< along edges where the map has a step
  std::string techniques{};        ///< of the chains
  std::string omc{};               ///< techniques of ordinary Monte Carlo
  bool chooses_omc = false;        ///< they are for a pilot to find, and those of chains as well
  bool omc_shares = true;  ///< they are the chains', so that light can be divided path by path
  std::vector<RegionRule> rules{};
  std::vector<float> painted{};  ///< σ of each pixel of the crop, given by the user; or empty

  /// Parameters other than those of chains.
  static std::vector<ParameterSpec> parameters();
  /// `given` with what a preset, or a kind of chains, sets and the user has not.
  static std::map<std::string, std::string> apply_preset(std::map<std::string, std::string> given);
  /// Raises UsageError, SceneError (rules) or IoError (files).
  static SelectiveSettings read(const Parameters& parameters, const RenderSettings& settings);
};

}  // namespace ajar
