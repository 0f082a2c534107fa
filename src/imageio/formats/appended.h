#pragma once
#include <cstddef>
#include <vector>

namespace ajar::image_formats {

/// Adds bytes at the end, for callbacks that no exception may leave; false if there is no memory.
inline bool appended(std::vector<unsigned char>& to, const unsigned char* from,
                     std::size_t count) noexcept {
  try {
    to.insert(to.end(), from, from + count);
    return true;
  } catch (...) {
    return false;
  }
}

}  // namespace ajar::image_formats
