#include "integrator/chain_spreader.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/random.h"
#include "integrator/chain_film_sink.h"
#include "integrator/path_numbers.h"
#include "mcmc/chain_runner.h"

namespace ajar {

namespace {

/// Mutations for as much light as a pixel has. With it, and a share r of the light for chains, the
/// mutations per camera sample are r times this: near the least error at equal time for what was
/// measured of variances and costs.
constexpr double kMutationsPerBrightness = 3.0;
/// A chain begins by tracing its path again, so weak paths start one now and then only.
constexpr double kFewestSteps = 256.0;
constexpr double kMostSteps = 65536.0;

class ChainSpreader final : public StrongPathSink {
 public:
  ChainSpreader(const ChainPlan& plan, Film& film, Counters& counters)
      : plan_(plan), film_(film), counters_(counters), layer_(film.layer("indirect")) {}

  void spread(SampleSource& numbers, const StrongPath& path) override {
    const double wanted = std::abs(path.energy) / plan_.brightness * kMutationsPerBrightness;
    const double u =
        static_cast<double>(to_unit_float(static_cast<std::uint32_t>(path.key >> 32U)));
    double energy = path.energy;
    double steps = std::min(kMostSteps, std::floor(wanted + u));
    if (wanted < kFewestSteps) {
      if (!(u * kFewestSteps < wanted)) return;
      energy *= kFewestSteps / wanted;
      steps = kFewestSteps;
    }
    Worker& worker = worker_of(path.technique.depth());
    Chain chain = PathNumbers(numbers, path).start_chain(plan_, *worker.group, path);
    ReplaySource replay(chain.numbers);
    splats_.clear();
    chain.scalar = worker.target->evaluate(replay, Change{}, splats_);
    worker.target->rejected();
    if (!(chain.scalar > 0.0 && std::isfinite(chain.scalar))) {
      // Rounding has moved the path off an edge: it is splatted as it was found.
      film_.splat(layer_, path.replicate, path.raster,
                  path.value * static_cast<float>(energy / path.energy));
      return;
    }
    ChainFilmSink sink(film_, path.replicate, plan_.view.importance, *worker.target, counters_);
    sink.begin(energy / steps, nullptr);
    worker.runner->start(chain);
    const ChainStatistics statistics =
        worker.runner->go_on(chain, static_cast<std::uint64_t>(steps), sink);
    counters_.mutations += statistics.steps;
    counters_.discarded_nan += statistics.discarded_nan;
    counters_.discarded_infinite += statistics.discarded_infinite;
    counters_.discarded_negative += statistics.discarded_negative;
    const std::uint64_t rays = worker.target->rays();
    counters_.rays += rays - worker.rays;
    worker.rays = rays;
  }

 private:
  struct Worker {
    const PathGroup* group;
    std::unique_ptr<PathTarget> target;
    std::unique_ptr<ChainRunner> runner;
    std::uint64_t rays = 0;
  };

  Worker& worker_of(int depth) {
    Worker& worker = workers_[depth];
    if (!worker.target) {
      worker.group = &plan_.group_of(depth);
      worker.target = plan_.make_target(*worker.group);
      worker.runner = std::make_unique<ChainRunner>(plan_.chain_settings, *plan_.mutation,
                                                    worker.group->shape, *worker.target);
    }
    return worker;
  }

  const ChainPlan& plan_;
  Film& film_;
  Counters& counters_;
  int layer_;
  std::map<int, Worker> workers_;
  SplatBuffer splats_;
};

}  // namespace

std::unique_ptr<StrongPathSink> ChainSpreaders::make(Film& film, Counters& counters) const {
  return std::make_unique<ChainSpreader>(plan_, film, counters);
}

}  // namespace ajar
