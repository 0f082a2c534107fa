#include "session/render/render_scene.h"

#include <utility>

#include "session/scenes/scene_file.h"

namespace ajar {

namespace {

/// Statistics that are known once the scene is.
RenderStatistics first_statistics(const RenderState& state) {
  RenderStatistics statistics;
  const RenderOrder& order = state.order;
  statistics.render = state.plan->record;
  statistics.render.scene = order.scene;  // as the user calls it
  statistics.ranks = order.ranks == nullptr ? 1 : order.ranks->count();
  statistics.times = state.statistics.times;
  return statistics;
}

std::shared_ptr<const BuiltScene> build(RenderState& state, desc::SceneDesc&& description) {
  state.events.phase_begun(RenderPhase::Build);
  const Stopwatch clock;
  auto built = std::make_shared<const BuiltScene>(
      std::move(description), state.plan->setup.resolution, state.plan->record.spec.filter);
  state.statistics.times.build = clock.seconds();
  if (state.order.loaded) state.order.loaded->keep(built);
  return built;
}

}  // namespace

desc::SceneDesc load_description(RenderState& state) {
  if (state.order.loaded) return state.order.loaded->description();
  state.events.phase_begun(RenderPhase::Load);
  const Stopwatch clock;
  desc::SceneDesc description =
      load_scene(state.order.scene, state.warnings, state.order.spec.definitions);
  state.statistics.times.load = clock.seconds();
  return description;
}

void build_scene(RenderState& state, desc::SceneDesc description) {
  RenderPlan& plan = *state.plan;
  // The method's layers are known later; these are the least.
  MemoryEstimate least =
      memory_of(plan, state.order, {LayerSpec{.name = "direct"}, LayerSpec{.name = "indirect"}});
  std::shared_ptr<const BuiltScene> built;
  if (state.order.loaded) {
    built = state.order.loaded->built(plan.setup.resolution, plan.record.spec.filter);
  }
  if (!built) least.scene = scene_bytes(description);
  check_memory(least, state.order, description.film.where);
  if (!built) built = build(state, std::move(description));
  state.scene = std::shared_ptr<const Scene>(built, &built->scene);
  state.warnings.add_all(built->warnings);
  plan.record.scene_hash = state.scene->hash();
  state.statistics = first_statistics(state);
  state.watch.know(state.statistics);
  state.events.scene_warnings(state.warnings);
  for (const std::string& note : plan.setup.notes) state.events.note(note);
}

}  // namespace ajar
