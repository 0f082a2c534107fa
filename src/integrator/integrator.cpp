#include "integrator/integrator.h"

#include <nlohmann/json.hpp>

namespace ajar {

Counters& Counters::operator+=(const Counters& other) {
  add_rays(other);
  samples += other.samples;
  mutations += other.mutations;
  techniques += other.techniques;
  discarded_nan += other.discarded_nan;
  discarded_infinite += other.discarded_infinite;
  discarded_negative += other.discarded_negative;
  if (first_discarded.empty()) first_discarded = other.first_discarded;
  return *this;
}

MethodReport Integrator::report() const { return MethodReport::object(); }

}  // namespace ajar
