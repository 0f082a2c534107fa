#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace ajar {

/// Accumulates a 64-bit hash of contents, eight bytes at a time. Not cryptographic.
class ContentHash {
 public:
  void word(std::uint64_t value) {
    // Multiply-xorshift in the manner of MurmurHash3's finaliser.
    state_ = (state_ ^ value) * 0xff51afd7ed558ccdULL;
    state_ ^= state_ >> 32U;
  }
  void bytes(const void* data, std::size_t size) {
    word(size);
    const char* place = static_cast<const char*>(data);
    for (; size >= 8; place += 8, size -= 8) {
      std::uint64_t value = 0;
      std::memcpy(&value, place, 8);
      word(value);
    }
    std::uint64_t rest = 0;
    if (size > 0) std::memcpy(&rest, place, size);
    word(rest);
  }
  std::uint64_t result() const { return state_; }

 private:
  std::uint64_t state_ = 0x9e3779b97f4a7c15ULL;
};

}  // namespace ajar
