#include "core/printable_text.h"

#include <array>
#include <cstdint>

namespace ajar {

namespace {

struct Character {
  std::size_t bytes = 0;  ///< 0: this is no UTF-8
  std::uint32_t code = 0;
};

/// The first character of a text that is not empty (Unicode 15, table 3-7).
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80U) return {1, lead};
  const std::size_t count = lead >= 0xf0U ? 4 : lead >= 0xe0U ? 3 : 2;
  if (lead < 0xc2U || lead > 0xf4U || text.size() < count) return {};
  std::uint32_t code = lead & (0x7fU >> count);
  for (std::size_t i = 1; i < count; ++i) {
    if ((byte(i) & 0xc0U) != 0x80U) return {};
    code = code << 6U | (byte(i) & 0x3fU);
  }
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80U, 0x800U, 0x10000U};
  const bool is_surrogate = code >= 0xd800U && code <= 0xdfffU;
  if (code < kLeast[count] || is_surrogate || code > 0x10ffffU) return {};
  return {count, code};
}

bool is_control(std::uint32_t code) {
  const bool is_c0_or_c1 = code < 0x20U || (code >= 0x7fU && code < 0xa0U);
  // Line and paragraph separators, marks, embeddings, overrides and isolates of direction.
  const bool turns = code == 0x61cU || code == 0x200eU || code == 0x200fU ||
                     (code >= 0x2028U && code <= 0x202eU) || (code >= 0x2066U && code <= 0x2069U);
  return is_c0_or_c1 || turns;
}

std::string hexadecimal(std::uint32_t number, int digits) {
  std::string text;
  for (int i = digits - 1; i >= 0; --i) {
    text += "0123456789abcdef"[number >> (4U * static_cast<unsigned>(i)) & 0xfU];
  }
  return text;
}

std::string escaped(std::uint32_t code) {
  if (code == '\n') return "\\n";
  if (code == '\t') return "\\t";
  return code < 0x80U ? "\\x" + hexadecimal(code, 2) : "\\u" + hexadecimal(code, 4);
}

std::string printable(std::string_view text, bool keeps_lines) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const Character character = first_character(text);
    const std::size_t bytes = character.bytes == 0 ? 1 : character.bytes;
    const bool stays = keeps_lines && (character.code == '\n' || character.code == '\t');
    if (character.bytes == 0) {
      result += "\\x" + hexadecimal(static_cast<unsigned char>(text.front()), 2);
    } else if (is_control(character.code) && !stays) {
      result += escaped(character.code);
    } else {
      result += text.substr(0, bytes);
    }
    text.remove_prefix(bytes);
  }
  return result;
}

}  // namespace

std::string printable_text(std::string_view text) { return printable(text, true); }

std::string printable_line(std::string_view text) { return printable(text, false); }

std::string valid_utf8(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::size_t bytes = first_character(text).bytes;
    result += bytes == 0 ? std::string_view("\xef\xbf\xbd") : text.substr(0, bytes);
    text.remove_prefix(bytes == 0 ? 1 : bytes);
  }
  return result;
}

std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  if (text.size() <= kLongest) return printable_line(text);
  // Not in the middle of a character: its further bytes are 10xxxxxx.
  std::size_t end = kLongest;
  while (end > kLongest - 4 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
  return printable_line(text.substr(0, end)) + "…";
}

}  // namespace ajar
