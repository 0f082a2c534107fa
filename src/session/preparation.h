#pragma once
#include "integrator/integrator.h"

namespace ajar {

/// Runs the rounds of an integrator's preparation on all threads that TBB may use.
Counters prepare(Integrator& integrator);

}  // namespace ajar
