#include "integrator/integrator.h"

#include <nlohmann/json.hpp>

namespace ajar {

RenderSettings in_edges(RenderSettings settings, const Scene& scene) {
  if (!scene.has_uncounted() && !scene.has_counted_interfaces()) return settings;
  settings.counted = {settings.min_depth, settings.max_depth};
  if (scene.has_uncounted()) settings.max_depth += kMostUncounted;
  if (scene.has_counted_interfaces()) settings.min_depth = 1;
  return settings;
}

Counters& Counters::operator+=(const Counters& other) {
  for (const auto& count : kEventCounts) this->*count.number += other.*count.number;
  techniques += other.techniques;
  if (first_discarded.empty()) first_discarded = other.first_discarded;
  return *this;
}

MethodReport Integrator::report() const { return MethodReport::object(); }

}  // namespace ajar
