#pragma once
#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace ajar {

/// Puts into the bytes of a checkpoint the checksums that fit them, so that what else is wrong with
/// them is met. Nothing if they are too short for a header.
inline void make_checkpoint_checksums_right(std::span<std::byte> file) {
  // Layout of `Header` in checkpoint.cpp.
  constexpr std::size_t kContentChecksum = 20;
  constexpr std::size_t kHeaderChecksum = 40;
  constexpr std::size_t kHeader = 48;
  if (file.size() < kHeader) return;
  const auto checksum = [&](std::size_t first, std::size_t count) {
    return crc32_z(0, reinterpret_cast<const Bytef*>(file.data()) + first, count);
  };
  const auto content = static_cast<std::uint32_t>(checksum(kHeader, file.size() - kHeader));
  std::memcpy(file.data() + kContentChecksum, &content, sizeof(content));
  const auto header = static_cast<std::uint64_t>(checksum(0, kHeaderChecksum));
  std::memcpy(file.data() + kHeaderChecksum, &header, sizeof(header));
}

}  // namespace ajar
