#include "import/pbrt/lexer.h"

#include <gtest/gtest.h>

#include "core/printable_text.h"

namespace ajar::pbrt {
namespace {

Lexer lexer_of(std::string_view text) { return {std::make_shared<const std::string>("f"), text}; }

template <typename Function>
std::string error_in(Function function) {
  try {
    function();
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Lexer, CutsWordsStringsAndBracketsWithTheirPlaces) {
  Lexer lexer = lexer_of("Shape \"a b\" # \"comment\n  [1.5]");
  const TokenKind kinds[] = {TokenKind::Word, TokenKind::String, TokenKind::Open, TokenKind::Word,
                             TokenKind::Close};
  const char* texts[] = {"Shape", "a b", "[", "1.5", "]"};
  const unsigned lines[] = {1, 1, 2, 2, 2};
  const unsigned columns[] = {1, 7, 3, 4, 7};
  for (int i = 0; i < 5; ++i) {
    const Token token = lexer.next();
    EXPECT_EQ(token.kind, kinds[i]) << i;
    EXPECT_EQ(token.text, texts[i]) << i;
    EXPECT_EQ(token.line, lines[i]) << i;
    EXPECT_EQ(token.column, columns[i]) << i;
  }
  EXPECT_EQ(lexer.next().kind, TokenKind::End);
}

TEST(Lexer, NeedsNoSpaceAroundBracketsAndComments) {
  Lexer lexer = lexer_of("a[b]c#d\n\"e\"f");
  std::string all;
  for (Token token = lexer.next(); token.kind != TokenKind::End; token = lexer.next())
    all += std::string(token.text) + "|";
  EXPECT_EQ(all, "a|[|b|]|c|e|f|");
}

TEST(Lexer, SkipsAByteOrderMarkAndCarriageReturns) {
  Lexer lexer = lexer_of(
      "\xEF\xBB\xBF"
      "a\r\nb");
  EXPECT_EQ(lexer.next().column, 1U);
  const Token b = lexer.next();
  EXPECT_EQ(b.line, 2U);
  EXPECT_EQ(b.text, "b");
}

TEST(Lexer, DecodesEscapes) {
  Lexer lexer = lexer_of(R"("a\"b\\c\n\t")");
  EXPECT_EQ(lexer.string_value(lexer.next()), "a\"b\\c\n\t");
  Lexer other = lexer_of(R"("a\wood\q.png")");
  EXPECT_EQ(other.string_value(other.next()), "a\\wood\\q.png") << "as names on Windows are";
}

TEST(Lexer, LocatesStringsWithoutAnEnd) {
  EXPECT_EQ(error_in([] { lexer_of("\n  \"abc\n\"").next(); }),
            "f:2:3: this string has no end on its line");
  EXPECT_EQ(error_in([] { lexer_of("\"abc\\").next(); }),
            "f:1:1: this string has no end on its line");
  EXPECT_EQ(error_in([] { lexer_of("\"").next(); }), "f:1:1: this string has no end on its line");
}

TEST(Lexer, ReadsNumbersOfAllShapes) {
  Lexer lexer = lexer_of("1 -0 .5 5. 1e3 -1.5E-2 +2 1e-60 1e-400");
  const float expected[] = {1.F, -0.F, 0.5F, 5.F, 1000.F, -0.015F, 2.F, 0.F, 0.F};
  for (const float value : expected) EXPECT_EQ(lexer.float_value(lexer.next()), value);
}

TEST(Lexer, RejectsNonFiniteNumbers) {
  for (const char* text :
       {"nan", "inf", "-inf", "NaN", "infinity", "1x", "--1", "1e", "abc", "0x10", "+", ""}) {
    Lexer lexer = lexer_of(text);
    EXPECT_THROW(lexer.float_value(lexer.next()), SceneError) << text;
  }
  EXPECT_EQ(error_in([] {
              Lexer l = lexer_of(" 1e39");
              l.float_value(l.next());
            }),
            "f:1:2: the number 1e39 is too large");
  EXPECT_EQ(error_in([] {
              Lexer l = lexer_of("1e999");
              l.double_value(l.next());
            }),
            "f:1:1: the number 1e999 is too large");
}

TEST(Lexer, IntegersMayBeWrittenAsWholeFloats) {
  Lexer lexer = lexer_of("7 -3 2.0 1e3");
  for (const int value : {7, -3, 2, 1000}) EXPECT_EQ(lexer.int_value(lexer.next()), value);
  EXPECT_EQ(error_in([] {
              Lexer l = lexer_of("2.5");
              l.int_value(l.next());
            }),
            "f:1:1: expected an integer, found 2.5");
  EXPECT_EQ(error_in([] {
              Lexer l = lexer_of("3000000000");
              l.int_value(l.next());
            }),
            "f:1:1: the integer 3000000000 is too large");
}

TEST(Printable, HidesControlCharactersAndShortens) {
  EXPECT_EQ(printable("a\nb\x1b"), "a\\nb\\x1b");
  EXPECT_LT(printable(std::string(1000, 'x')).size(), 100U);
}

}  // namespace
}  // namespace ajar::pbrt
