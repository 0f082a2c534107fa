#include "session/render.h"

#include <tbb/global_control.h>

#include <utility>

#include "session/render/render_files.h"
#include "session/render/render_method.h"
#include "session/render/render_passes.h"
#include "session/render/render_scene.h"
#include "session/render/render_state.h"

namespace ajar {

namespace {

RenderEvents& nobody() {
  static RenderEvents listens;
  return listens;
}

std::unique_ptr<tbb::global_control> thread_limit(int threads) {
  if (threads <= 0) return nullptr;
  return std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                               static_cast<std::size_t>(threads));
}

/// True if there is anything to render. If not, or on an error, the preview is discarded.
bool is_prepared(RenderState& state) {
  const auto forget = [&] {
    state.preview.reset();
    state.monitor.publish(std::shared_ptr<const Picture>());
  };
  try {
    if (prepare_method(state)) return true;
  } catch (...) {
    forget();
    throw;
  }
  forget();
  return false;
}

}  // namespace

struct Render::Parts {
  Parts(RenderRequest request, RenderEvents& events)
      : interrupts(request.interrupts != nullptr ? *request.interrupts : own_interrupts),
        threads(thread_limit(request.spec.threads)),
        state{std::move(request), events, interrupts, monitor} {}

  InterruptCount own_interrupts{0};
  InterruptCount& interrupts;
  RenderMonitor monitor;
  std::unique_ptr<tbb::global_control> threads;
  RenderState state;
  RenderOutcome outcome;
};

Render::Render(RenderRequest request) : Render(std::move(request), nobody()) {}
Render::Render(RenderRequest request, RenderEvents& events)
    : parts_(std::make_unique<Parts>(std::move(request), events)) {
  RenderState& state = parts_->state;
  const RenderRequest& wanted = state.request;
  wanted.spec.display();  // its curve may be none
  check_files(wanted);
  if (wanted.resumed) check_resumable(*wanted.resumed, wanted.resumed_from, wanted.spec.force);
  state.statistics.render.scene = wanted.scene;
  state.monitor.publish(state.statistics);
}
Render::~Render() = default;

const RenderOutcome& Render::run() {
  RenderState& state = parts_->state;
  RenderOutcome& outcome = parts_->outcome;
  desc::SceneDesc description = load_description(state);
  change_film(state.request, description);
  state.plan.emplace(make_plan(state.request, description));
  complete_files(state.request, description);
  build_scene(state, std::move(description));
  if (is_prepared(state)) {
    outcome = render_passes(state);
  } else {
    outcome.interrupted = true;
    outcome.statistics = state.statistics;
  }
  state.events.finished(outcome);
  return outcome;
}

void Render::stop() { parts_->interrupts.fetch_add(1, std::memory_order_relaxed); }

RenderSnapshot Render::snapshot() const { return parts_->monitor.snapshot(); }

std::shared_ptr<const Picture> Render::picture() {
  std::shared_ptr<const Picture> picture;
  const auto look = [&](const Film& film, const JobState& job) {
    picture = std::make_shared<const Picture>(picture_of(parts_->state, film, job));
  };
  return parts_->monitor.passes.ask(look) ? picture : parts_->monitor.last_picture();
}

RenderStatistics Render::statistics() {
  RenderStatistics statistics;
  const auto look = [&](const Film& /*film*/, const JobState& job) {
    statistics = statistics_at(parts_->state, job);
  };
  return parts_->monitor.passes.ask(look) ? statistics : parts_->monitor.statistics();
}

}  // namespace ajar
