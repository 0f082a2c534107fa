#include "session/preparation.h"

#include <tbb/enumerable_thread_specific.h>

#include "core/parallel_for.h"

namespace ajar {

Counters prepare(Integrator& integrator) {
  Counters whole;
  for (int round = 0;; ++round) {
    const std::uint64_t items = integrator.begin_preparation(round);
    if (items == 0) return whole;
    tbb::enumerable_thread_specific<Counters> counters;
    parallel_for(
        items, [&](std::uint64_t item) { integrator.prepare_item(round, item, counters.local()); });
    for (const Counters& own : counters) whole += own;
  }
}

}  // namespace ajar
