#include "session/render/render_passes.h"

#include <atomic>
#include <filesystem>
#include <utility>

#include "session/job/resources.h"
#include "session/output/picture_range.h"
#include "session/render/progress_notifier.h"
#include "session/render/render_concerns.h"
#include "session/render/render_writers.h"
#include "session/version.h"

namespace ajar {

namespace {

std::string absolute_path(const std::string& path) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(path, error);
  return error ? path : absolute.lexically_normal().string();
}

Checkpoint checkpoint_base(const RenderState& state) {
  Checkpoint base;
  base.version = version();
  base.render = state.plan->record;
  base.render.spec.outputs = state.request.spec.outputs;  // as they are called by now
  for (std::string& path : base.render.spec.outputs) path = absolute_path(path);
  if (state.filter) base.features = state.filter->features();
  base.layers.assign(state.film->layers().begin(), state.film->layers().end());
  base.preparation =
      state.request.resumed ? state.request.resumed->preparation : state.statistics.preparation;
  base.unprepared = state.unprepared;
  base.preparation_rounds = state.preparation_rounds;
  base.other_seconds = state.other_seconds;
  base.resumptions = state.statistics.resumptions;
  base.interruptions = state.statistics.interruptions;
  return base;
}

/// Filters the picture. False if `progress` ended it.
bool add_best_layers(const RenderState& state, const Film& film, std::uint64_t samples,
                     Picture& picture, const Denoiser::Progress& progress) {
  const PictureEstimates estimates =
      estimates_of(film, development_of(film, *state.integrator, samples), samples,
                   state.plan->record.film_scale);
  return state.filter->add_best_layers(picture, estimates, progress);
}

/// A user who wants to stop has to wait for it: the render would go on otherwise after a resume.
std::optional<double> estimate_denoised_error(const RenderState& state, const Film& film,
                                              std::uint64_t samples) {
  Picture picture = develop(film, *state.integrator, samples, state.plan->record.film_scale, {});
  add_best_layers(state, film, samples, picture, {});
  return denoised_error(picture);
}

RenderJobOptions job_options(RenderState& state, std::vector<PassObserver*> observers) {
  RenderJobOptions options;
  options.budget = state.plan->setup.budget;
  // A time limit covers everything after loading.
  if (options.budget.seconds) {
    options.budget.seconds = seconds_of_passes(*options.budget.seconds, state.other_seconds,
                                               state.kept_seconds, state.filter_seconds);
  }
  options.threads = state.request.spec.threads;
  options.estimate_error = [&integrator = *state.integrator](const Film& film,
                                                             std::uint64_t samples) {
    return estimate_error(film, integrator, samples);
  };
  options.estimate_denoised_error = [&state](const Film& film, std::uint64_t samples) {
    return estimate_denoised_error(state, film, samples);
  };
  options.interrupts = &state.interrupts;
  options.share = state.request.spec.share;
  options.ranks = state.request.ranks;
  if (state.request.resumed) {
    options.resumed = std::move(state.request.resumed->job);
    const RenderSpec& before = state.request.resumed->render.spec;
    const bool is_of_same_picture = before.denoised_target == options.budget.denoised_target &&
                                    (!options.budget.denoised_target ||
                                     before.denoiser_name() == state.request.spec.denoiser_name());
    // Errors of the one picture say nothing of those of the other.
    if (!is_of_same_picture) options.resumed->recent_errors.clear();
  }
  options.observers = std::move(observers);
  return options;
}

/// Traces features between passes, more rays the more samples there are: in the end nothing is left
/// to trace, and their time is within that of the passes.
class FeatureRays final : public PassObserver {
 public:
  FeatureRays(FeatureTracer& tracer, const InterruptCount& interrupts)
      : tracer_(tracer), interrupts_(interrupts) {}
  bool wants_picture(const JobState& job) override {
    tracer_.trace(feature_rays(job.samples_per_pixel),
                  [this](double /*done*/) { return interrupts_ == 0; });
    return false;
  }
  void see_picture(const Film& /*film*/, const JobState& /*job*/) override {}

 private:
  FeatureTracer& tracer_;
  const InterruptCount& interrupts_;
};

/// While it lives, passes may be looked at.
class OpenPasses {
 public:
  explicit OpenPasses(PassQueue& passes) : passes_(passes) { passes_.open(); }
  ~OpenPasses() { passes_.close(); }
  OpenPasses(const OpenPasses&) = delete;
  OpenPasses& operator=(const OpenPasses&) = delete;

 private:
  PassQueue& passes_;
};

/// Filters the picture, unless the user is in a hurry.
void denoise_last(RenderState& state, const RenderJob& job, Picture& picture) {
  if (!state.filter) return;
  state.events.phase_begun(RenderPhase::Denoise);
  const Stopwatch clock;
  std::atomic<double> fraction{0.0};
  bool is_filtered = false;
  {
    const ScopedActivity at_work(state, [&] {
      RenderSnapshot snapshot;
      snapshot.phase = RenderPhase::Denoise;
      snapshot.phase_done = fraction;
      snapshot.seconds = clock.seconds();
      return snapshot;
    });
    const int before = state.interrupts;
    is_filtered = add_best_layers(state, job.film(), state.statistics.result.samples_per_pixel,
                                  picture, [&](double done) {
                                    fraction = done;
                                    return state.interrupts == before;
                                  });
  }
  state.statistics.times.denoise = clock.seconds();
  if (is_filtered) {
    state.statistics.denoiser = state.filter->name();
    state.statistics.denoised_error = denoised_error(picture);
  } else {
    state.events.note("interrupted while denoising: the picture is as it was rendered");
  }
}

RenderOutcome finish(RenderState& state, const RenderJob& job, RenderWriters& writers) {
  const RenderResult& result = state.statistics.result;
  RenderOutcome outcome;
  outcome.interrupted = result.stopped_by == StopReason::Interrupted;
  if (outcome.interrupted) ++state.statistics.interruptions;
  // Before there is a picture: memory has room for one of the two.
  state.statistics.errors_by_scale = estimate_errors_by_scale(
      job.film(), development_of(job.film(), *state.integrator, result.samples_per_pixel),
      result.samples_per_pixel);
  Picture picture = state.develop_with(job.film(), state.statistics);
  denoise_last(state, job, picture);
  state.events.phase_begun(RenderPhase::Write);
  writers.show_last(job);
  const double film_scale = state.plan->record.film_scale;
  // A scene without lights has been said to be black.
  const auto complaint = range_complaint(job.film(), picture, film_scale);
  if (complaint && !state.scene->lights().empty()) state.warn(*complaint);
  for (const Warning& concern : concerns_about(result)) state.warn(concern);
  outcome.statistics = state.statistics_with(result);
  picture.metadata = to_metadata(outcome.statistics);
  const Display display = state.request.spec.display();
  outcome.display = display.of(picture);
  outcome.statistics.exposure = {display.exposure.automatic, outcome.display.exposure};
  outcome.picture = std::make_shared<const Picture>(std::move(picture));
  // Later queries get these.
  state.monitor.publish(outcome.statistics);
  state.monitor.publish(outcome.picture);
  state.monitor.passes.close(job.film(), job.state());

  const RenderRequest& request = state.request;
  const bool nothing_new = request.resumed && job.state().passes == state.passes_before &&
                           !job.state().partial && request.spec.checkpoint == request.resumed_from;
  writers.write_last(job, !nothing_new, state.interrupts, outcome);
  state.monitor.publish(outcome.statistics);
  return outcome;
}

}  // namespace

RenderOutcome render_passes(RenderState& state) {
  state.events.phase_begun(RenderPhase::Render);
  const auto develop = [&state](const Film& film, const JobState& job) {
    return picture_of(state, film, job);
  };
  ProgressNotifier teller(
      state.events, state.request.show_every, [&state] { return state.monitor.snapshot(); },
      develop);
  std::optional<RenderWriters> writers;
  std::vector<PassObserver*> observers;
  std::optional<FeatureRays> feature_tracing;
  if (state.request.is_root()) {
    std::optional<Checkpoint> base;
    if (state.has_begun && !state.request.spec.checkpoint.empty()) base = checkpoint_base(state);
    if (state.preview) state.preview->filter_by(state.filter);
    writers.emplace(state.request, *state.integrator, std::move(base), std::move(state.preview),
                    develop, state.events);
    observers = writers->observers();
    observers.insert(observers.end(), {&teller, &state.monitor.passes});
    if (state.features) {
      observers.push_back(&feature_tracing.emplace(*state.features, state.interrupts));
    }
  }
  RenderJob job(*state.integrator, *state.film, job_options(state, std::move(observers)));
  std::optional<OpenPasses> open;
  if (writers) {
    open.emplace(state.monitor.passes);
    // From now on they have the picture. What the preparation has seen takes memory.
    state.monitor.publish(std::shared_ptr<const Picture>());
  }
  {
    const ScopedActivity at_work(state, [&job] { return job.snapshot(); });
    state.statistics.result = job.run();
  }
  if (writers) return finish(state, job, *writers);
  RenderOutcome outcome;
  outcome.interrupted = state.statistics.result.stopped_by == StopReason::Interrupted;
  outcome.statistics = state.statistics;
  return outcome;
}

RenderStatistics statistics_at(const RenderState& state, const JobState& job) {
  return state.statistics_with(result_of(job, StopReason::NotYet));
}

Picture picture_of(const RenderState& state, const Film& film, const JobState& job) {
  Picture picture = state.develop_with(film, statistics_at(state, job));
  if (state.filter) state.filter->add_layers(picture);
  return picture;
}

}  // namespace ajar
