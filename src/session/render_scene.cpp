#include "session/render_scene.h"

#include <utility>

#include "session/scene_file.h"
#include "session/statistics_of.h"

namespace ajar {

namespace {

/// What is known once it is clear what is rendered.
RenderStatistics first_statistics(const RenderState& state) {
  RenderStatistics statistics = statistics_of(state.plan->record);
  const RenderOrder& order = state.order;
  statistics.scene = order.scene;  // as the user calls it
  statistics.budget = state.plan->setup.budget;
  statistics.checkpoint = order.files.checkpoint;
  statistics.ranks = order.ranks == nullptr ? 1 : order.ranks->count();
  statistics.times = state.statistics.times;
  return statistics;
}

}  // namespace

desc::SceneDesc load_description(RenderState& state) {
  if (state.order.description) return *std::exchange(state.order.description, std::nullopt);
  state.events.phase_begun(RenderPhase::Load);
  const Stopwatch clock;
  desc::SceneDesc description = load_scene(state.order.scene, state.warnings);
  state.statistics.times.load = clock.seconds();
  return description;
}

void build_scene(RenderState& state, desc::SceneDesc description) {
  RenderPlan& plan = *state.plan;
  // What the method makes of it is known later; it makes these at least.
  MemoryEstimate least =
      memory_of(plan, state.order, {LayerSpec{.name = "direct"}, LayerSpec{.name = "indirect"}});
  least.scene = scene_bytes(description);
  check_memory(least, state.order, description.film.where);
  state.events.phase_begun(RenderPhase::Build);
  const Stopwatch clock;
  state.scene = std::make_unique<const Scene>(std::move(description),
                                              BuildOptions{plan.setup.resolution}, state.warnings);
  state.statistics.times.build = clock.seconds();
  plan.record.scene_hash = state.scene->hash();
  state.statistics = first_statistics(state);
  state.watch.know(state.statistics);
  state.events.scene_warnings(state.warnings);
  for (const std::string& note : plan.setup.notes) state.events.note(note);
}

}  // namespace ajar
