#pragma once
#include <limits>

namespace ajar {

/// The depths that paths may have where not all of their vertices count: edges, less the events by
/// which light passes a surface uncounted, and as many more as there are interfaces that count.
struct CountedDepth {
  int minimum = 1;
  int maximum = std::numeric_limits<int>::max();
  bool holds(int depth) const { return depth >= minimum && depth <= maximum; }
};

}  // namespace ajar
