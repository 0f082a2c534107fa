#include "measuring/timed_render.h"

#include <tbb/info.h>

#include <algorithm>
#include <limits>

#include "measuring/cpu_alarm.h"
#include "session/job/preparation.h"
#include "session/job/render_job.h"
#include "session/job/resources.h"
#include "session/output/output.h"
#include "session/render/resolved_render.h"

namespace ajar::bench {

namespace {

/// A render overshoots its time by half a pass on average; passes too short waste time between
/// them.
double pass_seconds(const TimeLimit& limit, int threads) {
  constexpr double kPasses = 40.0;
  return std::clamp(limit.cpu_seconds / threads / kPasses, 0.02, 0.5);
}

}  // namespace

TimedRender render_for(const TimeLimit& limit, const Scene& scene, const Variant& variant,
                       const RenderSettings& settings, const InterruptCount& user_interrupts) {
  // Not a `Render`: the alarm must not cut the preparation short, which has its time limits as in
  // one, and the error is not needed before the end.
  const double before = cpu_seconds();
  const CpuAlarm alarm(limit.cpu_seconds, user_interrupts);
  const int threads = limit.threads > 0 ? limit.threads : tbb::info::default_concurrency();
  const std::unique_ptr<Integrator> integrator = variant.make(scene, settings);
  // On a machine that others use, the wall's clock would leave it no time.
  Preparation(*integrator, {.seconds = limit.cpu_seconds / threads,
                            .clock = [&] { return cpu_seconds() / threads; }})
      .run();
  Film film = film_for(scene, settings, *integrator);
  RenderJobOptions options;
  options.threads = threads;
  options.pass_seconds = pass_seconds(limit, options.threads);
  options.interrupts = &alarm.interrupts();
  const RenderResult result = RenderJob(*integrator, film, options).run();

  TimedRender render;
  render.cpu_seconds = cpu_seconds() - before;
  render.samples = result.samples_per_pixel;
  render.complete = result.complete;
  render.estimate = estimate_error(film, *integrator, render.samples);
  const Development scales = development_of(film, *integrator, render.samples);
  render.estimates = estimates_of(film, scales, render.samples, scene.film().scale);
  Picture picture =
      develop(film, *integrator, render.samples, scene.film().scale, {"standard-error"});
  render.picture = std::move(picture.layers.front().pixels);
  if (picture.layers.back().name == "standard-error") {
    render.standard_error = std::move(picture.layers.back().pixels);
  } else {
    // Too short a render to know.
    render.standard_error.assign(render.picture.size(), std::numeric_limits<float>::infinity());
  }
  return render;
}

}  // namespace ajar::bench
