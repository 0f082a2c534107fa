#pragma once
#include "import/tungsten/object_reader.h"

namespace ajar::tungsten {

/// Warns unless the "transmittance" of a medium is exponential, as all are here, and of members
/// that it does not have.
void check_transmittance(const Context& context, const LocatedJson& json);

}  // namespace ajar::tungsten
