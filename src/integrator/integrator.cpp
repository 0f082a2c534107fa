#include "integrator/integrator.h"

#include <nlohmann/json.hpp>

namespace ajar {

Counters& Counters::operator+=(const Counters& other) {
  for (const auto number : kEventCounts) this->*number += other.*number;
  techniques += other.techniques;
  if (first_discarded.empty()) first_discarded = other.first_discarded;
  return *this;
}

MethodReport Integrator::report() const { return MethodReport::object(); }

}  // namespace ajar
