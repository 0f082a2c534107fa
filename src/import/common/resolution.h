#pragma once

namespace ajar {

/// Pixels along one side of a film, at most.
inline constexpr int kLargestResolution = 65536;

}  // namespace ajar
