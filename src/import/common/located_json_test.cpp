#include "import/common/located_json.h"

#include <gtest/gtest.h>

namespace ajar {
namespace {

using Kind = LocatedJson::Kind;

LocatedJson parse(std::string_view text) { return LocatedJson::parse(text, "a.json"); }

std::string error_in(std::string_view text) {
  try {
    parse(text);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

std::string place(const LocatedJson& json) { return json.where().to_string(); }

TEST(LocatedJson, LocatesEveryKindOfValue) {
  const LocatedJson root = parse(
      "{\"a\": 1,\n"
      "  \"b\" :[true,null , -2.5e1,\"x\"],\n"
      "\t\"c\":\n"
      "    {\"d\":7}}\n");
  EXPECT_EQ(place(root), "a.json:1:1");
  ASSERT_EQ(root.members().size(), 3U);
  EXPECT_EQ(place(root.members()[0].value), "a.json:1:7");
  EXPECT_EQ(root.members()[1].where.to_string(), "a.json:2:3");
  const LocatedJson& b = root.members()[1].value;
  EXPECT_EQ(place(b), "a.json:2:8");
  ASSERT_EQ(b.items().size(), 4U);
  EXPECT_EQ(place(b.items()[0]), "a.json:2:9");
  EXPECT_EQ(place(b.items()[1]), "a.json:2:14");
  EXPECT_EQ(place(b.items()[2]), "a.json:2:21");
  EXPECT_EQ(place(b.items()[3]), "a.json:2:28");
  EXPECT_EQ(place(root.members()[2].value), "a.json:4:5");
  EXPECT_EQ(place(root.members()[2].value.members()[0].value), "a.json:4:10");
}

TEST(LocatedJson, HasTheValuesOfTheFile) {
  const LocatedJson root = parse(R"([true, -25, 3000000000, 0.5, "A\n\"", null, [], {}])");
  ASSERT_EQ(root.items().size(), 8U);
  EXPECT_TRUE(root.items()[0].flag());
  EXPECT_EQ(root.items()[1].number(), -25.0);
  EXPECT_EQ(root.items()[2].number(), 3e9);
  EXPECT_EQ(root.items()[3].number(), 0.5);
  EXPECT_EQ(root.items()[4].text(), "A\n\"");
  EXPECT_TRUE(root.items()[5].is(Kind::Null));
  EXPECT_TRUE(root.items()[6].is(Kind::Array));
  EXPECT_TRUE(root.items()[7].is(Kind::Object));
}

TEST(LocatedJson, FindsTheFirstOfTwoMembersAndKeepsBoth) {
  const LocatedJson root = parse(R"({"a": 1, "b": 2, "a": 3})");
  EXPECT_EQ(root.members().size(), 3U);
  ASSERT_NE(root.find("a"), nullptr);
  EXPECT_EQ(root.find("a")->number(), 1.0);
  EXPECT_EQ(root.find("c"), nullptr);
}

TEST(LocatedJson, LocatesSyntaxErrors) {
  EXPECT_EQ(error_in("{\n  \"a\": 1,\n  \"b\" 2\n}").find("a.json:3:7: this is no JSON: "), 0U)
      << error_in("{\n  \"a\": 1,\n  \"b\" 2\n}");
  EXPECT_EQ(error_in("").find("a.json:1:1: this is no JSON: "), 0U) << error_in("");
  EXPECT_EQ(error_in("[1, 2\n").find("a.json:2:1: this is no JSON: "), 0U) << error_in("[1, 2\n");
  for (const char* text : {"[NaN]", "[Infinity]", "[1,]", "{} {}", "[01]", "'a'", "[\"\xff\"]"}) {
    EXPECT_NE(error_in(text).find("this is no JSON"), std::string::npos) << text;
  }
}

LocatedJson parse_with_extras(std::string_view text) {
  return LocatedJson::parse(text, "a.json", JsonExtras::CommentsAndTrailingCommas);
}

TEST(LocatedJson, LeavesCommentsAndTrailingCommasOutIfTheyAreAllowed) {
  const LocatedJson root = parse_with_extras(
      "// a remark, with \"\n"
      "{\"a\": /* two,\n"
      " lines ] */ [1, 2, // \u00fc\n"
      "  ], \"b//\": \"/* ,] \\\" */\" , /* } */ }\n");
  ASSERT_EQ(root.members().size(), 2U);
  const LocatedJson& a = root.members()[0].value;
  ASSERT_EQ(a.items().size(), 2U);
  EXPECT_EQ(place(a), "a.json:3:13");
  EXPECT_EQ(place(a.items()[1]), "a.json:3:17");
  EXPECT_EQ(root.members()[1].name, "b//");
  EXPECT_EQ(root.members()[1].where.to_string(), "a.json:4:6");
  EXPECT_EQ(root.members()[1].value.text(), "/* ,] \" */");
}

TEST(LocatedJson, RefusesOtherCommasAndCommentsWithoutAnEnd) {
  for (const char* text : {"[,]", "{,}", "[1,,]", "[1] /* ", "[1 / 2]", "[1,", "[NaN]", "\"a"}) {
    EXPECT_THROW(parse_with_extras(text), SceneError) << text;
  }
  EXPECT_NE(error_in("[1, /* no */ 2]").find("a.json:1:5: this is no JSON"), std::string::npos)
      << error_in("[1, /* no */ 2]");
  EXPECT_NE(error_in("{\"a\": 1,}"), "no error");
}

TEST(LocatedJson, RefusesNumbersBeyondDoubles) {
  EXPECT_EQ(error_in("[1,\n 1e999]"),
            "a.json:2:2: the number 1e999 is beyond the range of numbers");
}

TEST(LocatedJson, RefusesDeepNesting) {
  const std::string deep(LocatedJson::kDeepest + 1, '[');
  EXPECT_EQ(error_in(deep), "a.json:1:101: values are nested more than 100 levels deep");
  const std::string allowed =
      std::string(LocatedJson::kDeepest, '[') + std::string(LocatedJson::kDeepest, ']');
  EXPECT_EQ(error_in(allowed), "no error");
}

}  // namespace
}  // namespace ajar
