#pragma once
#include "integrator/division.h"
#include "integrator/selective/region_choice.h"

namespace ajar {

/// Fraction of a picture that chains make, as the pilot shows it: the mean over cells of 16×16
/// pixels, each of the same weight however bright, so that a single firefly is not half of the
/// picture. An estimate for messages; nothing is decided by it.
double chain_fraction(const PilotView& view, const Divisions& divisions);

}  // namespace ajar
