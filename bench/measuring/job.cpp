#include "measuring/job.h"

#include "image/make_filter.h"
#include "session/preparation.h"

namespace ajar::bench {

Job make_job(const Scene& scene, const Variant& variant, int max_depth) {
  RenderSettings settings;
  settings.resolution = scene.camera().resolution();
  settings.crop = Box2i(Vec2i(0, 0), settings.resolution - Vec2i(1, 1));
  settings.max_depth = max_depth;
  settings.replicates = 4;
  Job job;
  job.integrator = variant.make(scene, settings);
  prepare(*job.integrator);
  job.film =
      std::make_unique<Film>(settings.resolution, settings.crop, make_filter(scene.film().filter),
                             settings.replicates, job.integrator->layers());
  job.samples = 4;
  job.integrator->begin_pass(0, job.samples, *job.film);
  job.items = job.integrator->items_in_pass();
  return job;
}

}  // namespace ajar::bench
