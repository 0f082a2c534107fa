#include "session/render/render_method.h"

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
  if (state.order.resumed) {
    // Once more as it was: the checkpoint holds what came after it.
    if (const auto& shortage = state.order.resumed->unprepared) {
      limits.earlier = {state.order.resumed->preparation_rounds, *shortage};
    }
  } else {
    // A share of a render must be prepared like the others, or refused like them.
    if (state.order.spec.share.count > 1) return limits;
    const RenderSetup& setup = state.plan->setup;
    limits.seconds = setup.budget.seconds;
    if (limits.seconds) *limits.seconds -= state.statistics.times.build;
    if (setup.budget.samples_per_pixel) {
      limits.samples = PassSchedule(setup.budget, setup.settings.replicates, 0.0).total();
    }
    const Vec2i size = setup.settings.crop.size() + Vec2i(1, 1);
    limits.pixels = static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
  }
  limits.interrupts = &state.interrupts;
  limits.ranks = state.order.ranks;
  return limits;
}

void prepare(RenderState& state) {
  const RenderSetup& setup = state.plan->setup;
  state.integrator = setup.integrator->make(*state.scene, in_edges(setup.settings, *state.scene),
                                            state.plan->parameters);
  open_preview(state);
  Preparation::Show show;
  // A render that goes on has had better pictures.
  if (state.order.is_root() && !state.order.resumed) {
    show = [&state](std::vector<float> rgb) { show_first_look(state, std::move(rgb)); };
  }
  Preparation preparation(*state.integrator, preparation_limits(state), std::move(show));
  {
    const AtWork at_work(state, [&] { return snapshot_of(preparation); });
    state.statistics.preparation = preparation.run();
  }
  state.statistics.prepared = preparation.end() == PreparationEnd::Done;
  if (!state.statistics.prepared) {
    state.unprepared =
        preparation.end() == PreparationEnd::FewSamples ? Shortage::Samples : Shortage::Time;
  }
  state.preparation_rounds = preparation.rounds();
  state.has_begun = preparation.end() != PreparationEnd::Interrupted;
}

void tell_of_method(RenderState& state) {
  const RenderSetup& setup = state.plan->setup;
  if (state.order.spec.share.count > 1 && state.integrator->keeps_state()) {
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
  if (state.order.resumed) {
    state.events.note("interrupted before it could go on: the checkpoint is as it was");
    return false;
  }
  if (state.interrupts > 1 && state.order.ranks == nullptr) {
    state.events.note(
        "interrupted twice while preparing: nothing was rendered, nothing is written");
    return false;
  }
  state.events.note(
      "interrupted while preparing: the picture will be of what was found so far; the render "
      "itself has not begun" +
      std::string(state.order.spec.checkpoint.empty() ? "" : ", so no checkpoint is written"));
  return true;
}

void take_state(RenderState& state) {
  Checkpoint& checkpoint = *state.order.resumed;
  const std::vector<LayerSpec> layers = state.integrator->layers();
  check_scene(checkpoint, state.scene->hash(), layers, state.order.resumed_from,
              state.order.spec.force);
  try {
    unarchive(checkpoint.integrator_state, [&](InputArchive& archive) {
      state.integrator->load_state(archive, checkpoint.job.samples_per_pixel);
    });
  } catch (const std::exception& error) {
    throw IoError(state.order.resumed_from + ": makes no sense: " + error.what());
  }
}

/// Makes the filter of pictures, if there is one.
void make_filter(RenderState& state) {
  std::string note;
  std::shared_ptr<const Denoiser> denoiser = find_denoiser(state.order.spec.denoiser_name(), &note);
  if (!note.empty()) state.events.note(note);
  if (!denoiser) return;
  const RenderSettings& settings = state.plan->setup.settings;
  Features known;
  if (state.order.resumed) known = state.order.resumed->features;
  const auto look = [&scene = *state.scene, settings, roughly = !state.has_begun,
                     known = std::move(known)](const Denoiser::Progress& progress) {
    return known.empty() ? trace_features(scene, settings, progress, roughly) : known;
  };
  state.filter = std::make_shared<PictureFilter>(std::move(denoiser), look);
  // A merge of checkpoints has no scene to look at.
  if (state.order.spec.checkpoint.empty() || !state.has_begun) return;
  const int before = state.interrupts;
  state.filter->know_features(settings.crop.size() + Vec2i(1, 1),
                              [&](double /*done*/) { return state.interrupts == before; });
}

void make_film(RenderState& state) {
  const RenderSetup& setup = state.plan->setup;
  const std::vector<LayerSpec> layers = state.integrator->layers();
  if (!state.order.as_before && !state.order.spec.wants_all_layers() && state.statistics.prepared) {
    std::vector<LayerSpec> made = layers;
    for (const auto& [name, plane] : state.integrator->findings().maps)
      made.push_back({.name = name});
    check_layers(setup, made);
  }
  MemoryEstimate memory = memory_of(*state.plan, state.order, layers);
  memory.method = state.integrator->memory_bytes();
  if (state.filter) {
    const Vec2i size = setup.settings.crop.size() + Vec2i(1, 1);
    memory.denoiser = state.filter->memory_bytes(static_cast<std::uint64_t>(size.x) *
                                                 static_cast<std::uint64_t>(size.y));
  }
  check_memory(memory, state.order, state.scene->film().where);
  if (state.order.resumed) take_state(state);
  if (state.order.resumed) {
    // All ranks: a method that has gone on takes other magnitudes for its layers, and sums of
    // different quanta cannot be added.
    state.film.emplace(film_of(*state.order.resumed, state.plan->filter, state.order.resumed_from));
    if (!state.order.is_root()) state.film->clear();
  } else {
    state.film.emplace(film_for(*state.scene, setup.settings, *state.integrator));
  }
}

void add_earlier_runs(RenderState& state) {
  if (!state.order.resumed) return;
  state.other_seconds += state.order.resumed->other_seconds;
  state.passes_before = state.order.resumed->job.passes;
  state.statistics.resumed_from = state.order.resumed_from;
  state.statistics.resumptions = state.order.resumed->resumptions + 1;
  state.statistics.interruptions = state.order.resumed->interruptions;
}

}  // namespace

bool prepare_method(RenderState& state) {
  state.events.phase_begun(RenderPhase::Prepare);
  const Stopwatch clock;
  prepare(state);
  tell_of_method(state);
  if (!goes_on(state)) return false;
  if (state.order.is_root()) make_filter(state);
  make_film(state);
  state.statistics.times.prepare = clock.seconds();
  state.other_seconds = state.statistics.times.build + state.statistics.times.prepare;
  add_earlier_runs(state);
  state.watch.know(state.statistics);
  return true;
}

}  // namespace ajar
