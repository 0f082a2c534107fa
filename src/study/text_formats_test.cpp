#include "study/text_formats.h"

#include <gtest/gtest.h>

namespace ajar::study {
namespace {

TEST(MarkdownText, IsNoMarkup) {
  EXPECT_EQ(markdown_text("bdpt, 4 spp (fine)"), "bdpt, 4 spp (fine)");
  EXPECT_EQ(markdown_text("<script>a|b`c`</script>"), "\\<script\\>a\\|b\\`c\\`\\</script\\>");
  EXPECT_EQ(markdown_text("![x](http://a)"), "\\!\\[x\\](http://a)");
  EXPECT_EQ(markdown_text("a\n# b \x1b[1m"), "a\\\\n\\# b \\\\x1b\\[1m");
}

TEST(CsvCell, QuotesDelimiters) {
  EXPECT_EQ(csv_cell("plain text"), "plain text");
  EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_cell("say \"x\"\r\n"), "\"say \"\"x\"\"\r\n\"");
}

TEST(CsvCell, IsNoFormula) {
  EXPECT_EQ(csv_cell("=1+2"), "'=1+2");
  EXPECT_EQ(csv_cell("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(csv_cell("-5,x"), "\"'-5,x\"");
  EXPECT_EQ(csv_cell("\t=1"), "'\t=1");
  EXPECT_EQ(csv_cell("a=1"), "a=1");
}

}  // namespace
}  // namespace ajar::study
