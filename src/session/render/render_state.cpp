#include "session/render/render_state.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "session/output/output.h"

namespace ajar {

void RenderState::warn(const Warning& warning) {
  warnings.add(warning);
  events.warning(warning);
}

RenderStatistics RenderState::statistics_with(const RenderResult& result) const {
  RenderStatistics all = statistics;
  all.result = result;
  all.report = std::make_shared<const MethodReport>(integrator->report());
  all.warning_count = warnings.count();
  all.warnings = warnings.messages();
  return all;
}

Picture RenderState::develop_with(const Film& of, const RenderStatistics& known) const {
  Picture picture = develop(of, *integrator, known.result.samples_per_pixel,
                            plan->record.film_scale, plan->setup.aovs);
  picture.metadata = to_metadata(known);
  return picture;
}

ScopedActivity::ScopedActivity(RenderState& state, std::function<RenderSnapshot()> snapshot)
    : state_(state) {
  state_.monitor.attach(std::move(snapshot));
  state_.events.work_begun([&monitor = state.monitor] { return monitor.snapshot(); });
}

ScopedActivity::~ScopedActivity() {
  state_.events.work_ended();
  state_.monitor.detach();
}

}  // namespace ajar
