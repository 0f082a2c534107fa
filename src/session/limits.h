#pragma once

namespace ajar {

/// Pixels along one side of a picture, at most.
inline constexpr int kMaxResolution = 65536;

}  // namespace ajar
