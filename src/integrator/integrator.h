#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/parameters.h"
#include "image/film.h"
#include "integrator/technique_tally.h"
#include "scene/scene.h"

namespace ajar {

/// What every integrator is told.
struct RenderSettings {
  Vec2i resolution{0, 0};  ///< of the full image
  Box2i crop;              ///< pixels to render, min and max inclusive
  int min_depth = 1;       ///< path edges (METHODS, section 1)
  int max_depth = 100;
  std::uint64_t seed = 0;
  int replicates = 4;
  std::vector<std::string> aovs;  ///< extra layers asked for
};

/// Numbers every integrator counts; summed over threads by the job.
struct Counters {
  std::uint64_t rays = 0;      ///< nearest-hit and shadow rays
  std::uint64_t samples = 0;   ///< camera samples or mutations
  TechniqueShares techniques;  ///< what each technique brought
  std::uint64_t discarded_nan = 0;
  std::uint64_t discarded_infinite = 0;
  std::uint64_t discarded_negative = 0;
  /// What to say about the first discarded contribution of an item: enough to replay it.
  std::string first_discarded;
  Counters& operator+=(const Counters& other);
};

/// A rendering method, cut into work items. It knows nothing of threads, files and clocks: the job
/// calls `run_item` for every item of a pass, in any order and on any thread, and each item is a
/// pure function of its index.
class Integrator {
 public:
  virtual ~Integrator() = default;
  /// Layers of the film; includes "direct" and "indirect".
  virtual std::vector<LayerSpec> layers() const = 0;
  /// Number of items in pass `pass` (counted from 0) when `samples` samples per pixel (mutations
  /// per pixel) are wanted in it.
  virtual std::uint64_t items_in_pass() const = 0;
  /// Adds the contribution of one item of one pass, `first_sample`..`first_sample + samples` per
  /// pixel, to the film.
  virtual void run_item(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples,
                        Film& film, Counters& counters) const = 0;
  /// Factor that turns sums into pixel values after `samples` samples per pixel over all
  /// replicates, for one replicate or all; the same for each pixel.
  virtual double develop_scale(std::uint64_t samples, std::optional<int> replicate) const = 0;
};

/// An entry of the registry.
struct IntegratorInfo {
  std::string name;
  std::string summary;  ///< one line
  std::string source;   ///< paper
  std::vector<ParameterSpec> parameters;
  std::function<std::unique_ptr<Integrator>(const Scene&, const RenderSettings&, const Parameters&)>
      make;
};

/// A layer that users can ask for with `--aov`.
struct AovInfo {
  std::string name;
  std::string summary;  ///< one line
};
/// Every layer there is, those that need no asking for ("direct", "indirect") included.
const std::vector<AovInfo>& aovs();

/// All integrators, sorted by name.
const std::vector<IntegratorInfo>& integrators();
/// Raises UsageError with the nearest name.
const IntegratorInfo& find_integrator(const std::string& name);

}  // namespace ajar
