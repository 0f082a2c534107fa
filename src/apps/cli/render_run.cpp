#include "apps/cli/render_run.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <utility>

#include "apps/cli/messages.h"
#include "apps/cli/render_report.h"
#include "core/archive.h"
#include "core/error.h"
#include "core/warnings.h"
#include "image/make_filter.h"
#include "scene/scene.h"
#include "session/checkpoint_writer.h"
#include "session/interrupts.h"
#include "session/memory_estimate.h"
#include "session/option_values.h"
#include "session/picture_range.h"
#include "session/picture_writer.h"
#include "session/preparation.h"
#include "session/preview/preview.h"
#include "session/progress.h"
#include "session/render_job.h"
#include "session/resources.h"
#include "session/scene_file.h"
#include "session/stats_json.h"
#include "session/version.h"
#include "session/written_paths.h"

namespace ajar::cli {

namespace {

namespace fs = std::filesystem;

constexpr int kExitFile = 4;
constexpr int kExitInterrupted = 130;

std::string absolute_path(const std::string& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  return error ? path : absolute.lexically_normal().string();
}

/// Wrong usage if the user chose the size, the scene's fault if its film did.
void check_memory(const MemoryEstimate& estimate, bool size_from_scene,
                  const SourceLocation& film) {
  const std::string complaint = memory_complaint(estimate, available_memory_bytes());
  if (complaint.empty()) return;
  if (size_from_scene) throw SceneError(film, complaint);
  throw UsageError(complaint);
}

RenderSnapshot snapshot_of(const Preparation& preparation) {
  RenderSnapshot snapshot;
  snapshot.preparation = preparation.fraction_done();
  snapshot.seconds = preparation.seconds();
  return snapshot;
}

/// One render from beginning to end.
class Run {
 public:
  explicit Run(RunOrder order);
  int carry_out();

 private:
  desc::SceneDesc load();
  void choose(const desc::SceneDesc& description);
  std::vector<std::string> written_files(std::vector<std::string> pictures) const;
  /// Raises UsageError for files that would be written twice, or over what is read.
  void check_files(const desc::SceneDesc& description) const;
  /// Of the film and what hangs on it.
  MemoryEstimate memory_of(const std::vector<LayerSpec>& layers) const;
  void build(desc::SceneDesc description);
  void prepare_integrator();
  void make_film();
  PreparationLimits preparation_limits() const;
  void check_resumed();
  void add_observers();
  RenderJobOptions job_options();
  void complete_statistics(const RenderResult& result);
  Checkpoint checkpoint_base() const;
  Picture picture_of(const Film& film, const JobState& state, StopReason reason);
  int finish(const RenderJob& job);
  /// Says it, and keeps it for the statistics.
  void warn(const Warning& warning);
  bool is_root() const { return order_.run.ranks == nullptr || order_.run.ranks->is_root(); }
  /// What the user asked for in this run.
  const RunArguments& run() const { return order_.run; }

  RunOrder order_;
  ProgressStyle style_;
  Display display_;
  double checkpoint_every_ = 0.0;
  double output_every_ = std::numeric_limits<double>::infinity();
  std::unique_ptr<tbb::global_control> thread_limit_;

  Warnings warnings_;
  RenderStatistics statistics_;
  RenderSetup setup_;
  std::vector<std::string> outputs_;
  std::optional<Parameters> parameters_;
  RenderRecord record_;
  std::optional<Filter> filter_;
  std::unique_ptr<const Scene> scene_;
  std::unique_ptr<Integrator> integrator_;
  std::optional<Film> film_;
  /// False if the user stopped it while it was prepared: what is shown then is another picture, by
  /// ordinary Monte Carlo alone, which no checkpoint must go on with.
  bool has_begun_ = true;
  std::uint64_t preparation_rounds_ = 0;
  double other_seconds_ = 0.0;  ///< of building and preparing, all runs together
  std::uint64_t passes_before_ = 0;
  std::unique_ptr<CheckpointWriter> checkpoint_writer_;
  std::unique_ptr<PictureWriter> picture_writer_;
  std::unique_ptr<Preview> preview_;
};

Run::Run(RunOrder order) : order_(std::move(order)) {
  const RunArguments& a = run();
  style_ = is_root() ? progress_style(a.progress, isatty(STDERR_FILENO) != 0) : ProgressStyle::None;
  display_ = display_of(a.tone_map.empty() ? "srgb" : a.tone_map, a.exposure.value_or(Exposure()));
  checkpoint_every_ = parse_duration("--checkpoint-every", a.checkpoint_every);
  // Told before anything is loaded.
  if (!a.preview.empty()) find_addresses("--preview", parse_viewer("--preview", a.preview));
  if (!a.output_every.empty()) output_every_ = parse_duration("--output-every", a.output_every);
  if (is_root()) {
    // An interrupted render that goes on where its folder is gone is told so in the end.
    if (order_.request) check_picture_paths(a.outputs);
    for (const std::string& path : {a.stats, a.checkpoint}) {
      if (!path.empty() && path != order_.resumed_from) check_writable(path);
    }
    if (!a.checkpoint.empty()) check_new_checkpoint(a.checkpoint, order_.resumed_from);
    check_distinct(written_files(a.outputs));
  }
  if (order_.resumed) check_resumable(*order_.resumed, order_.resumed_from, a.force);
  if (a.threads > 0) {
    thread_limit_ = std::make_unique<tbb::global_control>(
        tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(a.threads));
  }
}

desc::SceneDesc Run::load() {
  statistics_.scene = order_.scene;
  report_phase(style_, "load");
  const Stopwatch clock;
  desc::SceneDesc description = load_scene(order_.scene, warnings_);
  statistics_.times.load = clock.seconds();
  return description;
}

void Run::choose(const desc::SceneDesc& description) {
  if (order_.request) {
    setup_ = make_setup(*order_.request, description.hints, description.film);
    if (order_.resumed) {
      setup_.settings.replicates = order_.resumed->render.settings.replicates;
      check_budget(setup_.budget, setup_.settings.replicates);
    }
  } else {
    setup_ = setup_of(order_.resumed->render, order_.budget);
  }
  if (order_.share.count > 1 && setup_.budget.target_error) {
    throw UsageError("--target-error cannot go with a share: all shares need the same samples");
  }
  outputs_ = run().outputs;
  if (outputs_.empty()) {
    outputs_ = default_outputs(description.film.filename, scene_stem(order_.scene));
    if (is_root()) check_picture_paths(outputs_);
  }
  try {
    parameters_.emplace(setup_.integrator->read(setup_.parameters));
  } catch (const UsageError& error) {
    // The scene may have chosen it.
    throw UsageError("integrator " + setup_.integrator->name + ": " + error.what());
  }
  record_ = record_of(setup_, *parameters_, order_.scene, order_.share);
  record_.film_scale = static_cast<double>(description.film.scale);
  if (order_.resumed) check_same_render(order_.resumed->render, record_, order_.resumed_from);
  filter_ = make_filter(description.film.filter);
}

std::vector<std::string> Run::written_files(std::vector<std::string> pictures) const {
  for (const std::string& path : {run().stats, run().checkpoint}) {
    if (!path.empty()) pictures.push_back(path);
  }
  return pictures;
}

void Run::check_files(const desc::SceneDesc& description) const {
  if (!is_root()) return;
  const std::vector<std::string> written = written_files(outputs_);
  check_distinct(written);
  check_spares(written, description.files);
}

MemoryEstimate Run::memory_of(const std::vector<LayerSpec>& layers) const {
  MemoryEstimate estimate;
  const int replicates = setup_.settings.replicates;
  // The root of several ranks has the sum beside its own part, a preview develops a copy.
  const std::uint64_t films =
      1U + (run().ranks != nullptr ? 1U : 0U) + (run().preview.empty() ? 0U : 1U);
  estimate.film = films * film_bytes(setup_.crop, replicates, layers);
  estimate.pictures = picture_bytes(setup_.crop, replicates, layers, setup_.aovs);
  return estimate;
}

void Run::build(desc::SceneDesc description) {
  // What the method makes of it is known later; it makes these at least.
  MemoryEstimate least = memory_of({LayerSpec{.name = "direct"}, LayerSpec{.name = "indirect"}});
  least.scene = scene_bytes(description);
  check_memory(least, order_.size_from_scene, description.film.where);
  report_phase(style_, "build");
  const Stopwatch clock;
  scene_ = std::make_unique<const Scene>(std::move(description), BuildOptions{setup_.resolution},
                                         warnings_);
  statistics_.times.build = clock.seconds();
  record_.scene_hash = scene_->hash();
  print_warnings(warnings_, order_.scene);
  for (const std::string& note : setup_.notes) print_note(note);
}

void Run::prepare_integrator() {
  integrator_ = setup_.integrator->make(*scene_, setup_.settings, *parameters_);
  if (order_.resumed) {
    // Once more as it was: the checkpoint holds what came after it.
    PreparationLimits as_before;
    if (!order_.resumed->prepared) as_before.rounds = order_.resumed->preparation_rounds;
    as_before.interrupts = &interrupt_count();
    as_before.ranks = run().ranks;
    Preparation preparation(*integrator_, as_before);
    const ProgressReporter progress(style_, [&] { return snapshot_of(preparation); });
    statistics_.preparation = preparation.run();
    statistics_.prepared = preparation.end() == PreparationEnd::Done;
    preparation_rounds_ = preparation.rounds();
    has_begun_ = preparation.end() != PreparationEnd::Interrupted;
  } else {
    Preparation preparation(*integrator_, preparation_limits());
    const ProgressReporter progress(style_, [&] { return snapshot_of(preparation); });
    statistics_.preparation = preparation.run();
    statistics_.prepared = preparation.end() == PreparationEnd::Done;
    preparation_rounds_ = preparation.rounds();
    has_begun_ = preparation.end() != PreparationEnd::Interrupted;
  }
  if (order_.share.count > 1 && integrator_->keeps_state()) {
    throw UsageError("renders with " + setup_.integrator->name +
                     " cannot be divided into shares: its chains learn from each other; render "
                     "several seeds, and merge them");
  }
  for (const Warning& concern : integrator_->concerns()) warn(concern);
  for (const std::string& note : integrator_->notes()) print_note(note);
  const Budget& budget = setup_.budget;
  if (budget.target_error && !budget.seconds && !budget.samples_per_pixel &&
      integrator_->misses_light()) {
    print_note(
        "--target-error cannot end this render, since its error stays a lower bound as long as "
        "light "
        "is missing: choose another method, or give --time or --spp, too");
  }
}

PreparationLimits Run::preparation_limits() const {
  PreparationLimits limits;
  // A share of a render must be prepared like the others, or refused like them.
  if (order_.share.count > 1) return limits;
  limits.seconds = setup_.budget.seconds;
  if (limits.seconds) *limits.seconds -= statistics_.times.build;
  limits.interrupts = &interrupt_count();
  limits.ranks = run().ranks;
  return limits;
}

void Run::check_resumed() {
  Checkpoint& checkpoint = *order_.resumed;
  const std::vector<LayerSpec> layers = integrator_->layers();
  check_scene(checkpoint, scene_->hash(), layers, order_.resumed_from, run().force);
  try {
    unarchive(checkpoint.integrator_state, [&](InputArchive& archive) {
      integrator_->load_state(archive, checkpoint.job.samples_per_pixel);
    });
  } catch (const std::exception& error) {
    throw IoError(order_.resumed_from + ": makes no sense: " + error.what());
  }
}

void Run::make_film() {
  const std::vector<LayerSpec> layers = integrator_->layers();
  if (order_.request && !order_.all_aovs && statistics_.prepared) {
    std::vector<LayerSpec> made = layers;
    for (const auto& [name, plane] : integrator_->maps()) made.push_back({.name = name});
    check_layers(setup_.settings, made);
  }
  MemoryEstimate memory = memory_of(layers);
  memory.method = integrator_->memory_bytes();
  check_memory(memory, order_.size_from_scene, scene_->film().where);
  if (order_.resumed) check_resumed();
  if (order_.resumed && is_root()) {
    film_.emplace(film_of(*order_.resumed, *filter_, order_.resumed_from));
  } else {
    film_.emplace(setup_.resolution, setup_.crop, *filter_, setup_.settings.replicates, layers);
  }
}

Checkpoint Run::checkpoint_base() const {
  Checkpoint base;
  base.version = version();
  base.render = record_;
  base.budget = setup_.budget;
  for (const std::string& path : outputs_) base.outputs.push_back(absolute_path(path));
  base.tone_map = run().tone_map.empty() ? "srgb" : run().tone_map;
  base.exposure = run().exposure.value_or(Exposure());
  base.layers.assign(film_->layers().begin(), film_->layers().end());
  base.preparation = order_.resumed ? order_.resumed->preparation : statistics_.preparation;
  base.prepared = statistics_.prepared;
  base.preparation_rounds = preparation_rounds_;
  base.other_seconds = other_seconds_;
  base.resumptions = statistics_.resumptions;
  base.interruptions = statistics_.interruptions;
  return base;
}

void Run::add_observers() {
  if (!is_root()) return;
  if (!run().checkpoint.empty() && has_begun_) {
    checkpoint_writer_ =
        std::make_unique<CheckpointWriter>(run().checkpoint, checkpoint_every_, checkpoint_base(),
                                           *integrator_, print_warning, print_note);
  }
  picture_writer_ = std::make_unique<PictureWriter>(
      outputs_, output_every_, &picture_requests(), display_,
      [this](const Film& film, const JobState& state) {
        return picture_of(film, state, StopReason::NotYet);
      },
      print_warning, print_note);
  if (run().preview.empty()) return;
  PreviewOptions options;
  options.viewer = parse_viewer("--preview", run().preview);
  options.name = "ajar: " + scene_stem(order_.scene);
  options.film_scale = record_.film_scale;
  options.aovs = setup_.aovs;
  options.note = print_note;
  preview_ = std::make_unique<Preview>(std::move(options), *integrator_);
}

RenderJobOptions Run::job_options() {
  RenderJobOptions options;
  options.budget = setup_.budget;
  // A time limit covers everything after loading.
  if (options.budget.seconds) *options.budget.seconds -= other_seconds_;
  options.threads = run().threads;
  options.estimate_error = [this](const Film& film, std::uint64_t samples) {
    return estimate_error(film, *integrator_, samples);
  };
  options.interrupts = &interrupt_count();
  options.share = order_.share;
  options.ranks = run().ranks;
  if (order_.resumed) options.resumed = std::move(order_.resumed->job);
  if (checkpoint_writer_) options.observers.push_back(checkpoint_writer_.get());
  if (picture_writer_) options.observers.push_back(picture_writer_.get());
  if (preview_) options.observers.push_back(preview_.get());
  return options;
}

void Run::complete_statistics(const RenderResult& result) {
  statistics_.result = result;
  statistics_.chains = integrator_->chain_report();
  statistics_.selective = integrator_->selective_report();
  statistics_.scene_hash = scene_->hash();
  statistics_.integrator = setup_.integrator->name;
  statistics_.parameters = parameters_->values();
  statistics_.seed = setup_.settings.seed;
  statistics_.replicates = setup_.settings.replicates;
  statistics_.min_depth = setup_.settings.min_depth;
  statistics_.max_depth = setup_.settings.max_depth;
  statistics_.resolution = setup_.resolution;
  statistics_.crop = setup_.crop;
  statistics_.budget = setup_.budget;
  statistics_.share = order_.share;
  statistics_.checkpoint = run().checkpoint;
  statistics_.ranks = run().ranks == nullptr ? 1 : run().ranks->count();
  statistics_.warning_count = warnings_.count();
  statistics_.warnings = warnings_.messages();
}

Picture Run::picture_of(const Film& film, const JobState& state, StopReason reason) {
  RenderResult result;
  result.counters = state.counters;
  result.samples_per_pixel = state.mean_samples();
  result.seconds = state.seconds;
  result.cpu_seconds = state.cpu_seconds;
  result.chain_seconds = state.chain_seconds;
  result.relative_error = state.relative_error;
  result.complete = !state.partial;
  result.stopped_by = reason;
  complete_statistics(result);
  Picture picture =
      develop(film, *integrator_, result.samples_per_pixel, record_.film_scale, setup_.aovs);
  picture.metadata = to_metadata(statistics_);
  return picture;
}

void Run::warn(const Warning& warning) {
  warnings_.add(warning);
  print_warning(warning.text());
}

int Run::finish(const RenderJob& job) {
  const RenderResult result = statistics_.result;
  const bool interrupted = result.stopped_by == StopReason::Interrupted;
  if (interrupted) ++statistics_.interruptions;
  report_phase(style_, "write");
  if (preview_) preview_->show_last(job.film(), job.state());
  std::vector<FinalFile> files;
  // The picture of a finished render may be wanted where the checkpoint cannot be written.
  const bool nothing_new = order_.resumed && job.state().passes == passes_before_ &&
                           !job.state().partial && run().checkpoint == order_.resumed_from;
  const bool has_checkpoint = checkpoint_writer_ && !nothing_new;
  if (has_checkpoint) {
    files.push_back(checkpoint_writer_->last(job.film(), job.state(), interrupted));
  }
  Picture picture =
      develop(job.film(), *integrator_, result.samples_per_pixel, record_.film_scale, setup_.aovs);
  if (const auto complaint = range_complaint(job.film(), picture, record_.film_scale)) {
    warn(*complaint);
  }
  for (const Warning& concern : concerns_about(result)) warn(concern);
  complete_statistics(result);
  picture.metadata = to_metadata(statistics_);
  const DisplayOptions display = display_.of(picture);
  statistics_.exposure = {display_.exposure.automatic, display.exposure};
  for (FinalFile& file : picture_files(picture, outputs_, display)) {
    files.push_back(std::move(file));
  }
  Patience patience(interrupt_count(), print_warning);
  const std::vector<WrittenFile> written = write_final_files(files, &patience);
  for (std::size_t i = has_checkpoint ? 1 : 0; i < written.size(); ++i) {
    if (!written[i].path.empty()) statistics_.outputs.push_back(written[i].path);
  }
  statistics_.peak_memory_bytes = peak_memory_bytes();
  bool all_written = write_statistics(statistics_, run().stats);
  report_end(result, statistics_.times.prepare);
  report_exposure(picture, outputs_, display, display_.exposure.automatic);
  for (const WrittenFile& file : written) all_written = report_file(file) && all_written;
  for (const std::string& path : statistics_.outputs) print_path(path);
  if (!all_written) return kExitFile;
  return interrupted ? kExitInterrupted : 0;
}

int Run::carry_out() {
  desc::SceneDesc description = load();
  choose(description);
  check_files(description);
  build(std::move(description));
  // When a render goes on, its checkpoint is all there is to lose until it does.
  if (!order_.resumed) begin_render();
  report_phase(style_, "prepare");
  const Stopwatch clock;
  prepare_integrator();
  if (!has_begun_ && order_.resumed) {
    print_note("interrupted before it could go on: the checkpoint is as it was");
    return kExitInterrupted;
  }
  if (!has_begun_ && interrupt_count() > 1 && run().ranks == nullptr) {
    print_note("interrupted twice while preparing: nothing was rendered, nothing is written");
    return kExitInterrupted;
  }
  if (!has_begun_) {
    print_note(
        "interrupted while preparing: the picture will be of what was found so far; the render "
        "itself has not begun" +
        std::string(run().checkpoint.empty() ? "" : ", so no checkpoint is written"));
  }
  make_film();
  statistics_.times.prepare = clock.seconds();
  other_seconds_ = statistics_.times.build + statistics_.times.prepare;
  if (order_.resumed) {
    other_seconds_ += order_.resumed->other_seconds;
    passes_before_ = order_.resumed->job.passes;
    statistics_.resumed_from = order_.resumed_from;
    statistics_.resumptions = order_.resumed->resumptions + 1;
    statistics_.interruptions = order_.resumed->interruptions;
  }

  begin_render();
  report_phase(style_, "render");
  add_observers();
  RenderJob job(*integrator_, *film_, job_options());
  RenderResult result;
  {
    const ProgressReporter progress(style_, [&job] { return job.snapshot(); });
    result = job.run();
  }
  statistics_.result = result;
  if (!is_root()) return result.stopped_by == StopReason::Interrupted ? kExitInterrupted : 0;
  return finish(job);
}

}  // namespace

Display display_of(const std::string& tone_map, const Exposure& exposure) {
  return {tone_map_by_name(tone_map), exposure};
}

void lock_checkpoint_of(RunOrder& order) {
  const std::string& path = order.run.checkpoint;
  const bool is_root = order.run.ranks == nullptr || order.run.ranks->is_root();
  if (is_root && !path.empty()) order.lock.emplace(lock_checkpoint(path));
}

Budget budget_of(const RunArguments& a) {
  Budget budget;
  budget.samples_per_pixel = a.spp;
  if (!a.time.empty()) budget.seconds = parse_duration("--time", a.time);
  budget.target_error = a.target_error;
  return budget;
}

int carry_out(RunOrder order) { return Run(std::move(order)).carry_out(); }

}  // namespace ajar::cli
