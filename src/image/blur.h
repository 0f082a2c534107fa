#pragma once
#include <span>
#include <vector>

#include "core/vector.h"
#include "image/statistics.h"

namespace ajar {

/// A picture after a Gaussian of `sigma` pixels, cut at 4 σ; beyond the border the pixels of the
/// border repeat. RGB interleaved, row by row. Raises std::invalid_argument if the picture has not
/// `size`.
std::vector<float> blurred(std::span<const float> rgb, Vec2i size, double sigma);
/// Each of them.
Replicates blurred(const Replicates& replicates, Vec2i size, double sigma);

}  // namespace ajar
