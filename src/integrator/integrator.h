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
#include "core/work_share.h"
#include "image/develop_scale.h"
#include "image/film.h"
#include "image/plane.h"
#include "integrator/technique_shares.h"
#include "scene/ray_counts.h"
#include "scene/scene.h"
#include "transport/counted_depth.h"

namespace ajar {

/// What every integrator is told.
struct RenderSettings {
  Vec2i resolution{0, 0};  ///< of the full image
  Box2i crop;              ///< pixels to render, min and max inclusive
  int min_depth = 1;       ///< path edges (docs/methods/notation.md)
  int max_depth = 100;
  CountedDepth counted{};  ///< in addition, of depths that are not those of edges
  std::uint64_t seed = 0;
  int replicates = 4;
  std::vector<std::string> aovs;  ///< extra layers asked for
  /// Whether filters of noise will be fed: what chains make is then also estimated by independent
  /// samples, where there are any (`LayerSpec::instead_of`), and splats are kept as a filter of one
  /// pixel's box has them, too (`LayerSpec::box_of`).
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
  TechniqueShares techniques;  ///< what each technique brought
  /// What to say about the first discarded contribution of an item: enough to replay it.
  std::string first_discarded;
  Counters& operator+=(const Counters& other);
};

/// One of a preparation. Efforts are in camera samples per pixel.
struct PreparationRound {
  std::uint64_t items = 0;
  double effort = 1.0;
  double later_effort = 0.0;  ///< of the rounds after it
  double later_stays = 0.0;   ///< of that, what becomes part of the picture
  bool stays = false;         ///< what it renders becomes part of the picture
  /// What it finds serves the render even if none of the later rounds runs.
  bool serves_alone = false;
  /// Effort of one sample per pixel of the render. 0: however few there are, the preparation comes
  /// to its end, since without it another method would render than was asked for.
  double sample_effort = 0.0;
};

/// Of what a render had too little for its whole preparation.
enum class Shortage : bool { Time, Samples };

/// What a method knows since its preparation.
struct Findings {
  std::vector<Warning> concerns;   ///< what the user should know; of no place
  std::vector<std::string> notes;  ///< what the user may like to know beside
  /// Whether there is light that it cannot see, however long it renders: then replicates know too
  /// little of the error.
  bool misses_light = false;
  /// Pictures about the render, of one channel over the crop: those AOVs that are not sums of
  /// samples.
  std::vector<std::pair<std::string, Plane>> maps;
  /// Where pictures for the eye need smoothing along edges (post/antialias.h); empty if nowhere.
  std::optional<Plane> antialias_mask;
};

/// A rendering method, cut into work items. It knows nothing of threads, files and clocks: the job
/// first runs the rounds of its preparation, then calls `run_item` for every item of a round of a
/// pass, in any order and on any thread. Each item is a pure function of its index and, for methods
/// with a memory, of what the same item left behind in the passes before (chains) and all items in
/// the rounds before (photons).
class Integrator {
 public:
  virtual ~Integrator() = default;
  /// A round (counted from 0) of what comes before everything else; one without items ends the
  /// preparation. Called once per round, after all items of the round before.
  virtual PreparationRound begin_preparation(int /*round*/) { return {}; }
  virtual void prepare_item(int /*round*/, std::uint64_t /*item*/, Counters& /*counters*/) {}
  /// There is too little of something for the rest of the preparation: the integrator renders as
  /// well as it can without. Called once a round has begun, of which any items may have run; the
  /// picture depends on the number of the round only.
  virtual void skip_preparation(Shortage /*of*/) {}
  /// What the preparation has seen of the picture: RGB in the film's unit, row by row of the crop;
  /// empty if there is nothing to look at, or nothing new since this was asked last. Asked between
  /// the rounds of the preparation. For the eye only: none of it need be in the picture.
  virtual std::vector<float> take_first_look() { return {}; }
  virtual Findings findings() const { return {}; }

  /// Layers of the film, known after the preparation; includes "direct" and "indirect".
  virtual std::vector<LayerSpec> layers() const = 0;
  /// Rounds of every pass, with a barrier between them: photons are traced before they are
  /// gathered. More than one need `keeps_state`, for what a round leaves behind to the next is news
  /// to other processes.
  virtual int rounds_in_pass() const { return 1; }
  /// A later round of the pass (the first is 1), on one thread: all items of the round before have
  /// run, of all processes. A state that is saved in the midst of a pass leads back to its round.
  virtual void begin_round(int /*round*/) {}
  /// Number of items in the round that has begun; a sample is a mutation per pixel where chains
  /// run.
  virtual std::uint64_t items_in_round() const = 0;
  /// Called between passes, on one thread. A pass does not cross a milestone (`milestone_after`).
  /// `film`: what was rendered so far, by all processes if it is at a milestone. What is added to
  /// it before the first pass becomes part of the picture.
  virtual void begin_pass(std::uint64_t /*first_sample*/, std::uint64_t /*samples*/,
                          Film& /*film*/) {}
  /// Adds the contribution of one item of the round of a pass, `first_sample`..`first_sample +
  /// samples` per pixel, to the film.
  virtual void run_item(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples,
                        Film& film, Counters& counters) = 0;
  /// Whether an item of a pass is of Markov chains: statistics tell their time apart.
  virtual bool is_of_chains(std::uint64_t /*item*/) const { return false; }
  /// What turns the sums of a layer into pixel values after `samples` samples per pixel over all
  /// replicates, for one replicate or all.
  virtual DevelopScale develop_scale(const LayerSpec& layer, std::uint64_t samples,
                                     std::optional<int> replicate) const = 0;

  /// Whether items leave anything behind for later passes. Only methods whose items do not can be
  /// cut into shares that are rendered each by itself.
  virtual bool keeps_state() const { return false; }
  /// Between passes, after the preparation: writes what the items have left behind; and takes it
  /// back, in an integrator that was made and prepared in the same way. Then rendering goes on with
  /// the same bits after `samples` samples per pixel. `load_state` raises some std::exception if
  /// the bytes make no sense, whoever wrote them: what it accepts can be rendered on.
  virtual void save_state(OutputArchive& /*archive*/) const {}
  virtual void load_state(InputArchive& /*archive*/, std::uint64_t /*samples*/) {}
  /// Between passes of a render whose items are shared by several processes: gives away what the
  /// items of `share`, which is this process's, have left behind since it did so last; and takes
  /// what the process of `share` gave. When all have taken the news of all, in the order of their
  /// shares and their own among them, they know the same again, as if they had rendered all items.
  virtual void give_news(OutputArchive& /*archive*/, const WorkShare& /*share*/) {}
  virtual void take_news(InputArchive& /*archive*/, const WorkShare& /*share*/) {}

  /// Memory that it keeps while it renders, beside the scene and the film, bytes; known after the
  /// preparation. An estimate.
  virtual std::uint64_t memory_bytes() const { return 0; }

  /// How it fares, between passes.
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
  /// Adds to what was given what follows from it, such as the values of a preset; may be empty.
  std::function<std::map<std::string, std::string>(std::map<std::string, std::string>)> complete =
      nullptr;

  /// What `make` is to be called with. Raises UsageError as `Parameters` does.
  Parameters read(const std::map<std::string, std::string>& given) const {
    return {parameters, complete ? complete(given) : given};
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
  bool part_of_all = true;  ///< false for what is large, or made by some integrators only
  LayerValue value = LayerValue::Color;
  bool made_by_method = true;  ///< false: of sums that every film has
  std::string made_with{};     ///< the layer of a film that it is made of, if not of its own name
  int pictures = 0;            ///< layers that are made of it beside those of the film
  static constexpr int kPerReplicate = -1;  ///< of `pictures`
};
/// Every layer there is, those that need no asking for ("direct", "indirect") included.
const std::vector<AovInfo>& aovs();
/// Null for a name that is none of theirs.
const AovInfo* find_aov(const std::string& name);

/// All integrators, sorted by name.
const std::vector<IntegratorInfo>& integrators();
/// Settings of theirs that tables call by names of their own.
const std::vector<IntegratorInfo>& integrator_presets();
/// Of either kind. Raises UsageError with the nearest name.
const IntegratorInfo& find_integrator(const std::string& name);

}  // namespace ajar
