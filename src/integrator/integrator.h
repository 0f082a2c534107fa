#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/archive_forward.h"
#include "core/method_report.h"
#include "core/parameters.h"
#include "core/warnings.h"
#include "core/work_slice.h"
#include "image/develop_scale.h"
#include "image/film.h"
#include "image/plane.h"
#include "integrator/technique_shares.h"
#include "scene/ray_counts.h"
#include "scene/scene.h"
#include "transport/counted_depth.h"

namespace ajar {

/// Settings of every integrator.
struct RenderSettings {
  Vec2i resolution{0, 0};  ///< size of the full image
  Box2i crop;              ///< pixels to render, min and max inclusive
  int min_depth = 1;       ///< path edges (docs/methods/notation.md)
  int max_depth = 100;
  CountedDepth counted{};  ///< in addition, of depths that are not those of edges
  std::uint64_t seed = 0;
  int replicates = 4;
  std::vector<std::string> aovs;  ///< extra layers asked for
  /// True if auxiliary buffers and unbiased estimates for denoisers are needed: the chains' light
  /// is then also estimated by independent samples, where there are any (`LayerSpec::instead_of`),
  /// and splats are also kept with a box filter of one pixel (`LayerSpec::box_of`).
  bool for_filters = false;
};

/// `settings`, whose depths are those that count, with limits of edges that are wide enough for
/// them in this scene: no path passes more than `kMostUncounted` surfaces uncounted.
RenderSettings in_edges(RenderSettings settings, const Scene& scene);
inline constexpr int kMostUncounted = 32;

/// Numbers of events, which add up. Each has its row in `kEventCounts`.
struct EventCounts : RayCounts {
  std::uint64_t samples = 0;
  std::uint64_t mutations = 0;
  std::uint64_t discarded_nan = 0;
  std::uint64_t discarded_infinite = 0;
  std::uint64_t discarded_negative = 0;
};

/// A counter, for all that must not forget one: sums over threads and ranks, checkpoints,
/// statistics, reference.
struct EventCount {
  std::uint64_t EventCounts::*number;
  const char* name;               ///< in statistics; a dot leads into an object
  const char* help;               ///< one line
  bool with_preparation = false;  ///< statistics count those of the preparation, too
};
inline constexpr auto kEventCounts = std::to_array<EventCount>(
    {{&EventCounts::rays, "rays", "nearest-hit and shadow rays", true},
     {&EventCounts::samples, "samples", "camera samples"},
     {&EventCounts::mutations, "mutations", "steps of Markov chains"},
     {&EventCounts::discarded_nan, "discarded.nan", "contributions that were no numbers"},
     {&EventCounts::discarded_infinite, "discarded.infinite", "infinite contributions"},
     {&EventCounts::discarded_negative, "discarded.negative", "negative contributions"},
     {&EventCounts::rays_out_of_range, "discarded.rays_out_of_range",
      "rays that could not be traced, because of coordinates that are no numbers or too large",
      true}});
static_assert(sizeof(EventCounts) == kEventCounts.size() * sizeof(std::uint64_t));

/// Counts of every integrator; summed over threads by the job.
struct Counters : EventCounts {
  TechniqueShares techniques;  ///< light and variance of each technique
  /// Description of the first discarded contribution of an item: enough to replay it.
  std::string first_discarded;
  Counters& operator+=(const Counters& other);
};

/// One of a preparation. Efforts are in camera samples per pixel.
struct PreparationRound {
  std::uint64_t items = 0;
  double effort = 1.0;
  double later_effort = 0.0;       ///< effort of the rounds after it
  double later_kept_effort = 0.0;  ///< part of `later_effort` whose samples are kept
  bool stays = false;              ///< its samples are kept in the picture
  /// True if its result is of use even if none of the later rounds runs.
  bool serves_alone = false;
  /// Effort of one sample per pixel of the render. 0: however few there are, the preparation comes
  /// to its end, since without it another method would render than was asked for.
  double sample_effort = 0.0;
};

/// Reason why the preparation was cut short.
enum class PreparationCut : bool { Time, Samples };

/// Results of the preparation.
struct Findings {
  std::vector<Warning> concerns;   ///< for the user; without a place in a file
  std::vector<std::string> notes;  ///< further remarks for the user
  /// True if there is light that it cannot sample, however long it renders: then replicates
  /// underestimate the error.
  bool misses_light = false;
  /// Pictures about the render, of one channel over the crop: those AOVs that are not sums of
  /// samples.
  std::vector<std::pair<std::string, Plane>> maps;
  /// Where pictures for the eye need smoothing along edges (post/antialias.h); empty if nowhere.
  std::optional<Plane> antialias_mask;
};

/// A rendering method, cut into work items. It is independent of threads, files and clocks: the job
/// first runs the rounds of its preparation, then calls `run_item` for every item of a round of a
/// pass, in any order and on any thread. Each item is a pure function of its index and, for methods
/// with state, of that of the same item after the passes before (chains) and of all items after the
/// rounds before (photons).
class Integrator {
 public:
  virtual ~Integrator() = default;
  /// Begins a round (counted from 0) of the preparation; one without items ends it. Called once per
  /// round, after all items of the round before.
  virtual PreparationRound begin_preparation(int /*round*/) { return {}; }
  virtual void prepare_item(int /*round*/, std::uint64_t /*item*/, Counters& /*counters*/) {}
  /// There is too little of something for the rest of the preparation: the integrator renders as
  /// well as it can without. Called once a round has begun, of which any items may have run; the
  /// picture depends on the number of the round only.
  virtual void skip_preparation(PreparationCut /*of*/) {}
  /// Preview of the picture during the preparation: RGB in the film's unit, row by row of the crop;
  /// empty if there is none, or nothing new since the last call. Called between the rounds of the
  /// preparation. For the eye only: none of it need be in the picture.
  virtual std::vector<float> take_first_look() { return {}; }
  virtual Findings findings() const { return {}; }

  /// Layers of the film, known after the preparation; includes "direct" and "indirect".
  virtual std::vector<LayerSpec> layers() const = 0;
  /// Rounds of every pass, with a barrier between them: photons are traced before they are
  /// gathered. More than one need `keeps_state`, as other processes need the state of a round in
  /// the next.
  virtual int rounds_in_pass() const { return 1; }
  /// A later round of the pass (the first is 1), on one thread: all items of the round before have
  /// run, of all processes. A state that is saved in the midst of a pass leads back to its round.
  virtual void begin_round(int /*round*/) {}
  /// Number of items in the round that has begun; a sample is a mutation per pixel where chains
  /// run.
  virtual std::uint64_t items_in_round() const = 0;
  /// Called between passes, on one thread. A pass does not cross a milestone (`milestone_after`).
  /// `film`: samples so far, of all processes at a milestone. Additions before the first pass
  /// become part of the picture.
  virtual void begin_pass(std::uint64_t /*first_sample*/, std::uint64_t /*samples*/,
                          Film& /*film*/) {}
  /// Adds the contribution of one item of the round of a pass, `first_sample`..`first_sample +
  /// samples` per pixel, to the film.
  virtual void run_item(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples,
                        Film& film, Counters& counters) = 0;
  /// True for an item of Markov chains, whose time statistics show apart.
  virtual bool is_of_chains(std::uint64_t /*item*/) const { return false; }
  /// Scale from the sums of a layer to pixel values after `samples` samples per pixel over all
  /// replicates, for one replicate or all.
  virtual DevelopScale develop_scale(const LayerSpec& layer, std::uint64_t samples,
                                     std::optional<int> replicate) const = 0;

  /// True if items keep state for later passes. Only methods without can be cut into slices that
  /// are rendered each by itself.
  virtual bool keeps_state() const { return false; }
  /// Between passes, after the preparation: writes the state of the items, and restores it in an
  /// integrator that was made and prepared in the same way. Rendering then continues with the same
  /// bits after `samples` samples per pixel. `load_state` raises some std::exception if the bytes
  /// make no sense: any state that it accepts can be rendered on.
  virtual void save_state(OutputArchive& /*archive*/) const {}
  virtual void load_state(InputArchive& /*archive*/, std::uint64_t /*samples*/) {}
  /// Between passes of a render whose items are shared by several processes: serialises this
  /// process's state changes (items of `slice`) since the last exchange, and applies those of the
  /// process of `slice`. After the exchange of all, in the order of their slices and their own
  /// among them, all have the same state, as if they had rendered all items.
  virtual void export_delta(OutputArchive& /*archive*/, const WorkSlice& /*slice*/) {}
  virtual void import_delta(InputArchive& /*archive*/, const WorkSlice& /*slice*/) {}

  /// Memory that it keeps while it renders, beside the scene and the film, bytes; known after the
  /// preparation. An estimate.
  virtual std::uint64_t memory_bytes() const { return 0; }

  /// Report of the run, between passes.
  virtual MethodReport report() const;
};

/// An entry of the registry.
struct IntegratorInfo {
  std::string name;
  std::string summary;  ///< one line
  std::string source;   ///< paper
  std::vector<ParameterSpec> parameters;
  std::function<std::unique_ptr<Integrator>(const Scene&, const RenderSettings&, const Parameters&)>
      make;
  /// Raises UsageError for names of older versions, with the new ones; may be empty.
  std::function<void(const std::map<std::string, std::string>& given)> check = nullptr;

  /// Parameters for `make`. Raises UsageError as `Parameters` does.
  Parameters read(const std::map<std::string, std::string>& given) const {
    if (check) check(given);
    return {parameters, given};
  }
};

/// Values of a layer, of three sums per pixel.
enum class LayerValue {
  Color,
  Number,  ///< the first
  Mean     ///< the first over the second, a number of events
};

/// A layer that users can ask for with `--aov`. A new one needs its row in `aovs`, and the code
/// that makes it: a `LayerSpec` of integrators, or a part of `develop` (session/output/output.h).
struct AovInfo {
  std::string name;
  std::string summary;      ///< one line
  bool part_of_all = true;  ///< false for large layers, and those of some integrators only
  LayerValue value = LayerValue::Color;
  bool made_by_method = true;  ///< false: of sums that every film has
  std::string made_with{};     ///< the layer of a film that it is made of, if not of its own name
  int pictures = 0;            ///< layers that are made of it beside those of the film
  static constexpr int kPerReplicate = -1;  ///< value of `pictures`
};
/// Every layer there is, those that need no asking for ("direct", "indirect") included.
const std::vector<AovInfo>& aovs();
/// Null for a name that is none of theirs.
const AovInfo* find_aov(const std::string& name);

/// All integrators, sorted by name.
const std::vector<IntegratorInfo>& integrators();
/// Raises UsageError with the nearest name.
const IntegratorInfo& find_integrator(const std::string& name);

}  // namespace ajar
