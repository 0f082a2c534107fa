#pragma once
#include <cstddef>

namespace ajar {

/// Values of a pixel: scene-linear red, green and blue.
inline constexpr std::size_t kChannels = 3;

}  // namespace ajar
