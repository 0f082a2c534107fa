#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace ajar {

/// Container of compressed data.
enum class StreamKind { Gzip, Zlib };

/// Decompresses a stream of zlib, or one of gzip of one or more members; bytes behind it are
/// ignored. Empty if it is damaged, truncated, or larger than `max_size` bytes when decompressed.
/// Raises IoError if that is more than the memory there is.
std::optional<std::string> inflate_stream(std::string_view bytes, StreamKind kind,
                                          std::size_t max_size);

}  // namespace ajar
