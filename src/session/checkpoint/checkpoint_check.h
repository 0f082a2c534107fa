#pragma once
#include "session/checkpoint/checkpoint.h"

namespace ajar {

/// Checks all invariants of a checkpoint that later code relies on. Checksums protect a file from
/// damage only, not from its author. Raises std::runtime_error with the fault.
/// `Integrator::load_state` checks the integrator's state.
void check_sense(const Checkpoint& checkpoint);

/// Sums of a film with these layers fill `sums` exactly, so that it may be made.
bool film_fits(const RenderSettings& settings, const std::vector<LayerSpec>& layers,
               std::size_t sums);

}  // namespace ajar
