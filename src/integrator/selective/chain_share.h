#pragma once
#include "integrator/division.h"
#include "integrator/selective/region_choice.h"

namespace ajar {

/// Which share of a picture chains are to make, 0 to 1, as the pilot has seen it: the mean over
/// cells of 16×16 pixels, each of which counts as much as any other, however bright it is, so that
/// a single firefly is not half of the picture. An estimate to be told, not to decide by.
double chain_share(const PilotView& view, const Divisions& divisions);

}  // namespace ajar
