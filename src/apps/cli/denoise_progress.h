#pragma once
#include <functional>

#include "post/denoise/denoiser.h"

namespace ajar::cli {

/// Shows on stderr how far `filter` is, which Ctrl-C ends: it is given what to tell, and returns
/// whether it came to its end. Returns the same.
bool denoise_with_progress(const std::function<bool(const Denoiser::Progress& progress)>& filter);

}  // namespace ajar::cli
