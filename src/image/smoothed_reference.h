#pragma once
#include <vector>

#include "core/vector.h"
#include "image/statistics.h"

namespace ajar {

/// Estimate of each value of a noise-free picture of `size` pixels (3 values each, rows from the
/// top), from its replicates. It is a denominator of errors: the picture itself would not do, since
/// a pixel that is too bright by chance has both a large error and a large value.
///
/// Pixels of which replicates disagree are averaged with those around, in five rounds whose
/// neighbours lie 1, 2, 4, 8 and 16 pixels away (the à-trous scheme of Dammertz et al. 2010), as
/// long as they disagree. Neighbours count whose surroundings look the same, up to noise (as
/// patches do in non-local means, Buades et al. 2005): without the brightest replicate of each,
/// which may have a firefly. Each replicate is averaged for itself with the same weights, and the
/// result is the median of the averages (of two the lower), so that no firefly of a single
/// replicate is in it. The median lacks the mean of rare paths: so the result as a whole is made as
/// bright as the picture, each pixel relative to its own value.
///
/// Needs R ≥ 2 replicates of that size, else std::invalid_argument.
std::vector<float> smoothed_reference(Replicates replicates, Vec2i size);

}  // namespace ajar
