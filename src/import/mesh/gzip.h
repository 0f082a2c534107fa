#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace ajar {

/// True if `bytes` start like a gzip stream.
bool is_gzip(std::string_view bytes);
/// Decompresses a gzip stream of one or more members; empty if it is damaged, truncated, or larger
/// than `max_size` bytes when decompressed. Raises IoError if that is more than the memory there
/// is.
std::optional<std::string> gunzip(std::string_view bytes, std::size_t max_size);

}  // namespace ajar
