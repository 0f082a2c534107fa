#include "import/common/text_encoding.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

namespace ajar {
namespace {

/// Storage of characters' numbers.
struct Encoding {
  std::size_t unit;  ///< bytes
  bool is_big_endian;
  std::size_t mark;  ///< bytes at the beginning that say so
};

std::optional<Encoding> encoding_of(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("\xFF\xFE\0\0"sv)) return Encoding{4, false, 4};
  if (text.starts_with("\0\0\xFE\xFF"sv)) return Encoding{4, true, 4};
  if (text.starts_with("\xFF\xFE"sv)) return Encoding{2, false, 2};
  if (text.starts_with("\xFE\xFF"sv)) return Encoding{2, true, 2};
  // Without a mark: all formats begin with characters of ASCII.
  if (text.size() < 4) return std::nullopt;
  unsigned zeros = 0;
  for (std::size_t i = 0; i < 4; ++i) zeros = zeros * 2 + (text[i] == '\0' ? 1 : 0);
  switch (zeros) {
    case 0b0111:
      return Encoding{4, false, 0};
    case 0b1110:
      return Encoding{4, true, 0};
    case 0b0101:
      return Encoding{2, false, 0};
    case 0b1010:
      return Encoding{2, true, 0};
    default:
      return std::nullopt;
  }
}

void append_utf8(std::string& text, std::uint32_t character) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  const auto tail = [&](unsigned shift) { add(0x80U | (character >> shift & 0x3FU)); };
  if (character < 0x80) return add(character);
  if (character < 0x800) {
    add(0xC0U | character >> 6U);
    return tail(0);
  }
  if (character < 0x10000) {
    add(0xE0U | character >> 12U);
  } else {
    add(0xF0U | character >> 18U);
    tail(12);
  }
  tail(6);
  tail(0);
}

/// Nothing for invalid text.
std::optional<std::string> converted(std::string_view bytes, const Encoding& from) {
  bytes.remove_prefix(from.mark);
  if (bytes.size() % from.unit != 0) return std::nullopt;
  const auto unit_at = [&](std::size_t place) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < from.unit; ++i) {
      const std::size_t at = place + (from.is_big_endian ? i : from.unit - 1 - i);
      value = value << 8U | static_cast<unsigned char>(bytes[at]);
    }
    return value;
  };
  const auto is_surrogate = [](std::uint32_t unit, std::uint32_t first) {
    return unit >= first && unit < first + 0x400;
  };
  constexpr std::uint32_t kHigh = 0xD800;
  constexpr std::uint32_t kLow = 0xDC00;
  std::string text;
  text.reserve(bytes.size() / from.unit);
  for (std::size_t i = 0; i < bytes.size(); i += from.unit) {
    std::uint32_t character = unit_at(i);
    if (is_surrogate(character, kHigh) && from.unit == 2) {
      i += 2;
      if (i == bytes.size() || !is_surrogate(unit_at(i), kLow)) return std::nullopt;
      character = 0x10000 + ((character - kHigh) << 10U) + (unit_at(i) - kLow);
    }
    constexpr std::uint32_t kLast = 0x10FFFF;
    if (character == 0 || character > kLast || is_surrogate(character, kHigh) ||
        is_surrogate(character, kLow)) {
      return std::nullopt;
    }
    append_utf8(text, character);
  }
  return text;
}

FileBytes owned(std::string_view text) {
  auto bytes = std::make_unique<char[]>(text.size());
  std::copy(text.begin(), text.end(), bytes.get());
  return {std::move(bytes), text.size()};
}

}  // namespace

FileBytes in_utf8(FileBytes bytes) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  const std::string_view view = bytes.view();
  if (view.starts_with(kMark)) return owned(view.substr(kMark.size()));
  if (const std::optional<Encoding> encoding = encoding_of(view)) {
    if (const std::optional<std::string> text = converted(view, *encoding)) return owned(*text);
  }
  return bytes;
}

}  // namespace ajar
