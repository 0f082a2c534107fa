#pragma once
#include <stdexcept>

namespace ajar {

/// Raises std::invalid_argument with that message if the condition does not hold.
inline void check_argument(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

}  // namespace ajar
