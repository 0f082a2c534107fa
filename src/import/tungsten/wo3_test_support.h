#pragma once
#include <cstdint>
#include <string>

namespace ajar::tungsten {

template <typename Value>
void append(std::string& bytes, Value value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// The unit square in x and y, facing +z; its second triangle has the material 1.
inline std::string wo3_of_two_materials() {
  std::string bytes;
  append<std::uint64_t>(bytes, 4);
  for (const auto& [x, y] : {std::pair{0.F, 0.F}, {1.F, 0.F}, {1.F, 1.F}, {0.F, 1.F}}) {
    for (const float value : {x, y, 0.F, 0.F, 0.F, 1.F, x, y}) append(bytes, value);
  }
  append<std::uint64_t>(bytes, 2);
  for (const std::uint32_t value : {0U, 1U, 2U, 0U, 0U, 2U, 3U, 1U}) append(bytes, value);
  return bytes;
}

}  // namespace ajar::tungsten
