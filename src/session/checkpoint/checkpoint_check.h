#pragma once
#include "session/checkpoint/checkpoint.h"

namespace ajar {

/// Whether this program can have written it: all that later code relies on. A file's checksums say
/// only that it is as its author made it. Raises std::runtime_error with what is wrong. The
/// integrator's state is left to `Integrator::load_state`.
void check_sense(const Checkpoint& checkpoint);

/// Sums of a film with these layers fill `sums` exactly, so that it may be made.
bool film_fits(const RenderSettings& settings, const std::vector<LayerSpec>& layers,
               std::size_t sums);

}  // namespace ajar
