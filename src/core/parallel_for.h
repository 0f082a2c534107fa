#pragma once
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/fork_join.h"

namespace ajar {

/// `body(i)` for each i in [0, count), on the threads of the current arena, in no particular order.
template <typename Index, typename Body>
void parallel_for(Index count, const Body& body) {
  ForkJoin loop;
  tbb::parallel_for(Index{0}, count, [&](Index i) {
    const ForkJoin::Task task(loop);
    body(i);
  });
}

/// `body(range)` for the parts of [0, count) that splitting gives: of `grain` indices and less.
template <typename Index, typename Body, typename Partitioner = tbb::auto_partitioner>
void parallel_for_ranges(Index count, Index grain, const Body& body,
                         const Partitioner& partitioner = {}) {
  ForkJoin loop;
  tbb::parallel_for(
      tbb::blocked_range<Index>(0, count, grain),
      [&](const tbb::blocked_range<Index>& range) {
        const ForkJoin::Task task(loop);
        body(range);
      },
      partitioner);
}

}  // namespace ajar
