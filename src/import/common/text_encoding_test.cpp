#include "import/common/text_encoding.h"

#include <gtest/gtest.h>

#include <string>

namespace ajar {
namespace {

using namespace std::string_literals;

std::string utf8_of(const std::string& bytes) {
  return std::string(in_utf8(FileBytes(bytes)).view());
}

std::string encoded(const std::u32string& text, std::size_t unit, bool is_big_endian) {
  std::string bytes;
  for (const char32_t c : text) {
    for (std::size_t i = 0; i < unit; ++i) {
      bytes += static_cast<char>(c >> (8 * (is_big_endian ? unit - 1 - i : i)));
    }
  }
  return bytes;
}

TEST(TextEncoding, TextOfEveryEncodingIsTheSame) {
  const std::u32string text = U"v 0 1\n# \u00E4\u20AC\n";
  for (const bool has_mark : {true, false}) {
    for (const std::size_t unit : {std::size_t{2}, std::size_t{4}}) {
      for (const bool is_big_endian : {false, true}) {
        const std::string bytes = encoded((has_mark ? U"\uFEFF" : U"") + text, unit, is_big_endian);
        EXPECT_EQ(utf8_of(bytes), "v 0 1\n# \xC3\xA4\xE2\x82\xAC\n")
            << unit << is_big_endian << has_mark;
      }
    }
  }
  EXPECT_EQ(utf8_of("\xEF\xBB\xBFply\n"), "ply\n");
}

TEST(TextEncoding, SurrogatePairsAreOneCharacter) {
  EXPECT_EQ(utf8_of("\xFF\xFE\x3D\xD8\x00\xDE"s), "\xF0\x9F\x98\x80");
}

TEST(TextEncoding, InvalidTextIsUnchanged) {
  for (const std::string& bytes :
       {"\xFF\xFE\x3D\xD8"s, "\xFF\xFE\x00\xDE"s, "\xFF\xFE\x41"s, "a\0b\0\0\0"s, "ply\n"s, "a"s,
        ""s, "\xFF\xFE\0\0\0\0\x11\0"s, "\0\0\0\0abcd"s}) {
    EXPECT_EQ(utf8_of(bytes), bytes);
  }
}

}  // namespace
}  // namespace ajar
