#include "core/printable_text.h"

#include <gtest/gtest.h>

namespace ajar {
namespace {

TEST(PrintableText, KeepsTextAndItsLines) {
  for (const char* text :
       {"", "plain", "Bibliothèque, 図書館, 🎨", "two\nlines\tand a tab", "\\x1b"}) {
    EXPECT_EQ(printable_text(text), text);
  }
  EXPECT_EQ(printable_line("two\nlines\tand a tab"), "two\\nlines\\tand a tab");
}

TEST(PrintableText, EscapesControlCharacters) {
  EXPECT_EQ(printable_text("\x1b[31mred\x1b]0;title\x07"), "\\x1b[31mred\\x1b]0;title\\x07");
  EXPECT_EQ(printable_text("over\rwritten\b\x7f"), "over\\x0dwritten\\x08\\x7f");
  EXPECT_EQ(printable_text(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable_text("\xc2\x9b\x33\x31m"), "\\u009b31m") << "C1: a CSI in two bytes";
  EXPECT_EQ(printable_text("exe.\xe2\x80\xaegnp"), "exe.\\u202egnp") << "right to left";
}

TEST(PrintableText, EscapesInvalidUtf8) {
  EXPECT_EQ(printable_text("caf\xe9"), "caf\\xe9");
  EXPECT_EQ(printable_text("\x9b\x33\x31m"), "\\x9b31m") << "C1 in one byte";
  for (const char* wrong : {"\xc0\xaf", "\xe0\x80\xaf", "\xf0\x80\x80\xaf", "\xed\xa0\x80",
                            "\xf4\x90\x80\x80", "\xf8", "\xe2\x80", "\x80"}) {
    for (const char c : printable_text(wrong)) EXPECT_LT(static_cast<unsigned char>(c), 0x7f);
  }
}

TEST(ValidUtf8, ReplacesInvalidBytes) {
  EXPECT_EQ(valid_utf8("Bibliothèque\n\x1b"), "Bibliothèque\n\x1b");
  EXPECT_EQ(valid_utf8("caf\xe9.png\xc0"), "caf\xef\xbf\xbd.png\xef\xbf\xbd");
}

TEST(Printable, EndsBetweenCharacters) {
  EXPECT_EQ(printable("wall\n"), "wall\\n");
  const std::string sixty(60, 'a');
  EXPECT_EQ(printable(sixty), sixty);
  EXPECT_EQ(printable(sixty + "a"), sixty + "…");
  // The two bytes of é are the last that fits and the first that does not.
  EXPECT_EQ(printable(std::string(59, 'a') + "éa"), std::string(59, 'a') + "…");
}

}  // namespace
}  // namespace ajar
