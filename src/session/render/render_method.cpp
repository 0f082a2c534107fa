#include "session/render/render_method.h"

#include <algorithm>
#include <exception>
#include <utility>
#include <vector>

#include "core/archive.h"
#include "core/error.h"
#include "integrator/montecarlo/scene_features.h"
#include "session/job/preparation.h"
#include "session/render/first_look.h"

namespace ajar {

namespace {

RenderSnapshot snapshot_of(const Preparation& preparation) {
  RenderSnapshot snapshot;
  snapshot.phase = RenderPhase::Prepare;
  snapshot.phase_done = preparation.fraction_done();
  snapshot.seconds = preparation.seconds();
  return snapshot;
}

PreparationLimits preparation_limits(const RenderState& state) {
  PreparationLimits limits;
  if (state.request.resumed) {
    // Once more as it was: the checkpoint holds what came after it.
    if (const auto& preparation_cut = state.request.resumed->unprepared) {
      limits.earlier = {state.request.resumed->preparation_rounds, *preparation_cut};
    }
  } else {
    // A share of a render must be prepared like the others, or refused like them.
    if (state.request.spec.share.count > 1) return limits;
    const ResolvedRender& setup = state.plan->setup;
    limits.seconds = setup.budget.seconds;
    if (limits.seconds) *limits.seconds -= state.statistics.times.build;
    if (setup.budget.samples_per_pixel) {
      limits.samples = PassSchedule(setup.budget, setup.settings.replicates, 0.0).total();
    }
    const Vec2i size = setup.settings.crop.size() + Vec2i(1, 1);
    limits.pixels = static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
  }
  limits.interrupts = &state.interrupts;
  limits.ranks = state.request.ranks;
  return limits;
}

void prepare(RenderState& state) {
  const ResolvedRender& setup = state.plan->setup;
  state.integrator = setup.integrator->make(*state.scene, in_edges(setup.settings, *state.scene),
                                            state.plan->parameters);
  open_preview(state);
  Preparation::Show show;
  // A render that goes on has had better pictures.
  if (state.request.is_root() && !state.request.resumed) {
    show = [&state](std::vector<float> rgb) { show_first_look(state, std::move(rgb)); };
  }
  Preparation preparation(*state.integrator, preparation_limits(state), std::move(show));
  {
    const ScopedActivity at_work(state, [&] { return snapshot_of(preparation); });
    state.statistics.preparation = preparation.run();
  }
  state.statistics.prepared = preparation.end() == PreparationEnd::Done;
  if (!state.statistics.prepared) {
    state.unprepared = preparation.end() == PreparationEnd::FewSamples ? PreparationCut::Samples
                                                                       : PreparationCut::Time;
  }
  state.preparation_rounds = preparation.rounds();
  state.kept_seconds = preparation.seconds_kept();
  state.has_begun = preparation.end() != PreparationEnd::Interrupted;
}

void tell_of_method(RenderState& state) {
  const ResolvedRender& setup = state.plan->setup;
  if (state.request.spec.share.count > 1 && state.integrator->keeps_state()) {
    throw UsageError("renders with " + setup.integrator->name +
                     " cannot be divided into shares: its chains learn from each other; render "
                     "several seeds, and merge them");
  }
  const Findings found = state.integrator->findings();
  for (const Warning& concern : found.concerns) state.warn(concern);
  // Notes on the method are of no use after an early stop.
  if (state.has_begun) {
    for (const std::string& note : found.notes) state.events.note(note);
  }
  const Budget& budget = setup.budget;
  if (budget.target_error && !budget.seconds && !budget.samples_per_pixel && found.misses_light) {
    state.events.note(
        "--target-error cannot end this render, since its error stays a lower bound as long as "
        "light is missing: choose another method, or give --time or --spp, too");
  }
}

/// True if the render continues, which a user who stopped the preparation may not want.
bool goes_on(RenderState& state) {
  if (state.has_begun) return true;
  if (state.request.resumed) {
    state.events.note("interrupted before it could go on: the checkpoint is as it was");
    return false;
  }
  if (state.interrupts > 1 && state.request.ranks == nullptr) {
    state.events.note(
        "interrupted twice while preparing: nothing was rendered, nothing is written");
    return false;
  }
  state.events.note(
      "interrupted while preparing: the picture will be of what was found so far; the render "
      "itself has not begun" +
      std::string(state.request.spec.checkpoint.empty() ? "" : ", so no checkpoint is written"));
  return true;
}

void take_state(RenderState& state) {
  Checkpoint& checkpoint = *state.request.resumed;
  const std::vector<LayerSpec> layers = state.integrator->layers();
  check_scene(checkpoint, state.scene->hash(), layers, state.request.resumed_from,
              state.request.spec.force);
  try {
    unarchive(checkpoint.integrator_state, [&](InputArchive& archive) {
      state.integrator->load_state(archive, checkpoint.job.samples_per_pixel);
    });
  } catch (const std::exception& error) {
    throw IoError(state.request.resumed_from + ": makes no sense: " + error.what());
  }
}

/// Makes the filter of pictures, if there is one.
void make_filter(RenderState& state) {
  std::string note;
  std::shared_ptr<const Denoiser> denoiser =
      find_denoiser(state.request.spec.denoiser_name(), &note);
  if (!note.empty()) state.events.note(note);
  if (!denoiser) return;
  const RenderSettings& settings = state.plan->setup.settings;
  const auto tracer = std::make_shared<FeatureTracer>(*state.scene, settings);
  const auto look = [tracer, roughly = !state.has_begun](std::uint32_t rays,
                                                         const Denoiser::Progress& progress) {
    return tracer->look(roughly ? 1 : rays, progress);
  };
  state.filter = std::make_shared<PictureFilter>(std::move(denoiser), look);
  if (!state.has_begun) return;
  state.features = tracer;
  const Vec2i size = settings.crop.size() + Vec2i(1, 1);
  // A merge of checkpoints has no scene to look at.
  if (!state.request.spec.checkpoint.empty()) {
    const int before = state.interrupts;
    state.filter->know_features(size, [&](double /*done*/) { return state.interrupts == before; });
  }
  if (!state.plan->setup.budget.seconds || !PictureFilter::mixes(settings.replicates)) return;
  const std::vector<LayerSpec> layers = state.integrator->layers();
  const bool has_others = std::any_of(layers.begin(), layers.end(), [](const LayerSpec& layer) {
    return !layer.instead_of.empty();
  });
  state.filter_seconds = state.filter->expected_seconds(size, has_others);
}

void make_film(RenderState& state) {
  const ResolvedRender& setup = state.plan->setup;
  const std::vector<LayerSpec> layers = state.integrator->layers();
  if (!state.request.as_before && !state.request.spec.wants_all_layers() &&
      !state.request.may_lack_layers && state.statistics.prepared) {
    std::vector<LayerSpec> made = layers;
    for (const auto& [name, plane] : state.integrator->findings().maps)
      made.push_back({.name = name});
    check_layers(setup, made);
  }
  MemoryEstimate memory = memory_of(*state.plan, state.request, layers);
  memory.method = state.integrator->memory_bytes();
  if (state.filter) {
    const Vec2i size = setup.settings.crop.size() + Vec2i(1, 1);
    memory.denoiser = state.filter->memory_bytes(static_cast<std::uint64_t>(size.x) *
                                                 static_cast<std::uint64_t>(size.y));
  }
  check_memory(memory, state.request, state.scene->film().where);
  if (state.request.resumed) take_state(state);
  if (state.request.resumed) {
    // All ranks: a method that has gone on takes other magnitudes for its layers, and sums of
    // different quanta cannot be added.
    state.film.emplace(
        film_of(*state.request.resumed, state.plan->filter, state.request.resumed_from));
    if (!state.request.is_root()) state.film->clear();
  } else {
    state.film.emplace(film_for(*state.scene, setup.settings, *state.integrator));
  }
}

void add_earlier_runs(RenderState& state) {
  if (!state.request.resumed) return;
  state.other_seconds += state.request.resumed->other_seconds;
  state.passes_before = state.request.resumed->job.passes;
  state.statistics.resumed_from = state.request.resumed_from;
  state.statistics.resumptions = state.request.resumed->resumptions + 1;
  state.statistics.interruptions = state.request.resumed->interruptions;
}

}  // namespace

bool prepare_method(RenderState& state) {
  state.events.phase_begun(RenderPhase::Prepare);
  const Stopwatch clock;
  prepare(state);
  tell_of_method(state);
  if (!goes_on(state)) return false;
  if (state.request.is_root()) make_filter(state);
  make_film(state);
  state.statistics.times.prepare = clock.seconds();
  state.other_seconds = state.statistics.times.build + state.statistics.times.prepare;
  add_earlier_runs(state);
  state.monitor.publish(state.statistics);
  return true;
}

}  // namespace ajar
