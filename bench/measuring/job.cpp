#include "measuring/job.h"

#include "session/job/preparation.h"
#include "session/render/resolved_render.h"

namespace ajar::bench {

Job make_job(const Scene& scene, const Variant& variant, int max_depth) {
  RenderSettings settings = settings_for(scene);
  settings.max_depth = max_depth;
  settings.replicates = 4;
  Job job;
  job.integrator = variant.make(scene, settings);
  prepare(*job.integrator);
  job.film = std::make_unique<Film>(film_for(scene, settings, *job.integrator));
  job.samples = 4;
  job.integrator->begin_pass(0, job.samples, *job.film);
  job.items = job.integrator->items_in_round();
  return job;
}

}  // namespace ajar::bench
