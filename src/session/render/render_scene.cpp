#include "session/render/render_scene.h"

#include <utility>

#include "session/scenes/scene_file.h"

namespace ajar {

namespace {

/// Statistics that are known once the scene is.
RenderStatistics first_statistics(const RenderState& state) {
  RenderStatistics statistics;
  const RenderRequest& request = state.request;
  statistics.render = state.plan->record;
  statistics.render.scene = request.scene;  // as the user calls it
  statistics.ranks = request.ranks == nullptr ? 1 : request.ranks->count();
  statistics.times = state.statistics.times;
  return statistics;
}

std::shared_ptr<const BuiltScene> build(RenderState& state, desc::SceneDesc&& description) {
  state.events.phase_begun(RenderPhase::Build);
  const Stopwatch clock;
  auto built = std::make_shared<const BuiltScene>(
      std::move(description), state.plan->setup.resolution, state.plan->record.spec.filter);
  state.statistics.times.build = clock.seconds();
  if (state.request.loaded) state.request.loaded->keep(built);
  return built;
}

}  // namespace

desc::SceneDesc load_description(RenderState& state) {
  if (state.request.loaded) return state.request.loaded->description();
  state.events.phase_begun(RenderPhase::Load);
  const Stopwatch clock;
  desc::SceneDesc description =
      load_scene(state.request.scene, state.warnings, state.request.spec.definitions);
  state.statistics.times.load = clock.seconds();
  return description;
}

void build_scene(RenderState& state, desc::SceneDesc description) {
  RenderPlan& plan = *state.plan;
  // The method's layers are known later; these are the least.
  MemoryEstimate least =
      memory_of(plan, state.request, {LayerSpec{.name = "direct"}, LayerSpec{.name = "indirect"}});
  std::shared_ptr<const BuiltScene> built;
  if (state.request.loaded) {
    built = state.request.loaded->built(plan.setup.resolution, plan.record.spec.filter);
  }
  if (!built) least.scene = scene_bytes(description);
  check_memory(least, state.request, description.film.where);
  if (!built) built = build(state, std::move(description));
  state.scene = std::shared_ptr<const Scene>(built, &built->scene);
  state.warnings.add_all(built->warnings);
  plan.record.scene_hash = state.scene->hash();
  state.statistics = first_statistics(state);
  state.monitor.publish(state.statistics);
  state.events.scene_warnings(state.warnings);
  for (const std::string& note : plan.setup.notes) state.events.note(note);
}

}  // namespace ajar
