#include "core/located_json.h"

#include <gtest/gtest.h>

#include <functional>

namespace ajar {
namespace {

using Kind = LocatedJson::Kind;

LocatedJson parse(std::string_view text, JsonRules rules = {}) {
  rules.name = "a.json";
  return LocatedJson::parse(std::string(text), std::move(rules));
}

std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

std::string error_in(std::string_view text, const JsonRules& rules = {}) {
  return error_of([&] { parse(text, rules); });
}

std::string place(const LocatedJson& json) { return json.where().to_string(); }

TEST(LocatedJson, LocatesEveryKindOfValue) {
  const LocatedJson root = parse(
      "{\"a\": 1,\n"
      "  \"b\" :[true,null , -2.5e1,\"x\"],\n"
      "\t\"c\":\n"
      "    {\"d~/\":7}}\n");
  EXPECT_EQ(place(root), "a.json:1:1");
  const std::vector<LocatedJson::Member> members = root.members();
  ASSERT_EQ(members.size(), 3U);
  EXPECT_EQ(place(members[0].value), "a.json:1:7#/a");
  EXPECT_EQ(place(members[1].key), "a.json:2:3") << "a name is a part of its object";
  const LocatedJson& b = members[1].value;
  EXPECT_EQ(place(b), "a.json:2:8#/b");
  ASSERT_EQ(b.size(), 4U);
  EXPECT_EQ(place(b[0]), "a.json:2:9#/b/0");
  EXPECT_EQ(place(b[1]), "a.json:2:14#/b/1");
  EXPECT_EQ(place(b[2]), "a.json:2:21#/b/2");
  EXPECT_EQ(place(b[3]), "a.json:2:28#/b/3");
  EXPECT_EQ(place(members[2].value), "a.json:4:5#/c");
  EXPECT_EQ(place(members[2].value.members()[0].value), "a.json:4:12#/c/d~0~1");
  EXPECT_EQ(place(b.without_members()), place(b));
  EXPECT_FALSE(b.without_members().has("a"));
}

TEST(LocatedJson, LocatesNestedArraysInTheirOrder) {
  const LocatedJson root =
      parse("[ {\"a\": [1,\n 2, \"three\"], \"b\": -1.5e3,\"c\":null},\n\t[[true] ] ]");
  EXPECT_EQ(place(root[0]), "a.json:1:3#/0");
  EXPECT_EQ(place(root[0].at("a")), "a.json:1:9#/0/a");
  EXPECT_EQ(place(root[0].at("a")[2]), "a.json:2:5#/0/a/2");
  EXPECT_EQ(root[0].at("a").items().size(), 3U);
  EXPECT_EQ(place(root[0].at("c")), "a.json:2:31#/0/c");
  EXPECT_EQ(place(root[1][0][0]), "a.json:3:4#/1/0/0");
  EXPECT_EQ(place(parse("\xef\xbb\xbf[7]")[0]), "a.json:1:2#/0");
}

TEST(LocatedJson, HasTheValuesOfTheText) {
  const LocatedJson root = parse(R"([true, -25, 3000000000, 0.5, "\u0041\n\"", null, [], {}])");
  ASSERT_EQ(root.size(), 8U);
  EXPECT_TRUE(root[0].flag());
  EXPECT_EQ(root[1].number(), -25.0);
  EXPECT_EQ(root[1].as<int>(), -25);
  EXPECT_EQ(root[2].as<std::uint64_t>(), 3000000000U);
  EXPECT_EQ(root[3].as<float>(), 0.5F);
  EXPECT_EQ(root[4].text(), "A\n\"");
  EXPECT_TRUE(root[5].is(Kind::Null));
  EXPECT_TRUE(root[6].is(Kind::Array));
  EXPECT_TRUE(root[7].is(Kind::Object));
  EXPECT_EQ(parse("[1, 2, 3]").as<Vec3>(), Vec3(1.F, 2.F, 3.F));
  EXPECT_EQ(parse(R"({"\u0061/": 1e-400})").value_or("a/", 1.0), 0.0);
  EXPECT_EQ(parse("[18446744073709551615]")[0].as<std::uint64_t>(), ~std::uint64_t{0});
}

TEST(LocatedJson, RefusesValuesOfOtherTypes) {
  const LocatedJson root = parse(R"({"a": [1, "x", -3, 2.5, 3.0, 1e300, null, [1,
    2]]})");
  const LocatedJson a = root.at("a");
  EXPECT_EQ(error_of([&] { a[0].text(); }), "a.json:1:8#/a/0: must be text, not 1");
  EXPECT_EQ(error_of([&] { a[1].number(); }), "a.json:1:11#/a/1: must be a number, not \"x\"");
  EXPECT_EQ(error_of([&] { a[2].as<std::uint64_t>(); }),
            "a.json:1:16#/a/2: must be a whole number from 0 on, not -3");
  EXPECT_EQ(error_of([&] { a[3].as<int>(); }),
            "a.json:1:20#/a/3: must be a whole number from -2147483648 to 2147483647, not 2.5");
  EXPECT_EQ(a[4].as<int>(), 3);
  EXPECT_NE(error_of([&] { a[4].whole(4, 5); }), "no error");
  EXPECT_NE(error_of([&] { a[5].as<float>(); }), "no error");
  EXPECT_NE(error_of([&] { a[5].as<int>(); }), "no error");
  EXPECT_NE(error_of([&] { a[6].flag(); }), "no error");
  EXPECT_EQ(error_of([&] { a[7].as<Vec3>(); }),
            "a.json:1:43#/a/7: must be 3 numbers, not [1,\\n    2]");
  EXPECT_EQ(error_of([&] { a[0].index(1); }),
            "a.json:1:8#/a/0: refers to number 1, but there are 1, counted from 0");
  EXPECT_EQ(error_of([&] { a.find("b"); }).find("a.json:1:7#/a: must be an object, not ["), 0U);
  EXPECT_EQ(error_of([&] { root.at("b"); }), "a.json:1:1: there is no \"b\" here");
  EXPECT_EQ(error_of([&] {
              root.check_members("part", {"aa", "c"});
            }),
            "a.json:1:2: unknown part \"a\"; did you mean \"aa\"? Valid: aa, c");
}

TEST(LocatedJson, PlacesAreNotRepeated) {
  const LocatedJson root = parse(R"({"scale": 1})");
  EXPECT_EQ(error_of([&] { root.located([&] { root.at("scale").text(); }); }),
            "a.json:1:11#/scale: must be text, not 1");
  EXPECT_EQ(error_of([&] { root.at("scale").located([] { throw UsageError("is odd"); }); }),
            "a.json:1:11#/scale: is odd");
}

TEST(LocatedJson, OneOfTwoMembersOfANameCounts) {
  const char* text = "{\"a\": 1, \"b\": {\"a\": 2},\n \"\\u0061\": 3}";
  const LocatedJson last = parse(text);
  const LocatedJson first = parse(text, {.first_counts = true});
  EXPECT_EQ(last.at<int>("a"), 3);
  EXPECT_EQ(first.at<int>("a"), 1);
  for (const LocatedJson& root : {first, last}) {
    EXPECT_EQ(root.members().size(), 2U);
    EXPECT_EQ(place(root.at("b").at("a")), "a.json:1:21#/b/a");
    ASSERT_EQ(root.repeated_count(), 1U);
    EXPECT_EQ(root.repeated(5).at(0).name, "a");
    EXPECT_EQ(root.repeated(5).at(0).where.to_string(), "a.json:2:2");
  }
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

LocatedJson parse_with_extras(std::string_view text) { return parse(text, {.has_extras = true}); }

TEST(LocatedJson, LeavesCommentsAndTrailingCommasOutIfTheyAreAllowed) {
  const LocatedJson root = parse_with_extras(
      "// a remark, with \"\n"
      "{\"a\": /* two,\n"
      " lines ] */ [1, 2, // \u00fc\n"
      "  ], \"b//\": \"/* ,] \\\" */\" , /* } */ }\n");
  const std::vector<LocatedJson::Member> members = root.members();
  ASSERT_EQ(members.size(), 2U);
  const LocatedJson& a = members[0].value;
  ASSERT_EQ(a.size(), 2U);
  EXPECT_EQ(place(a), "a.json:3:13#/a");
  EXPECT_EQ(place(a[1]), "a.json:3:17#/a/1");
  EXPECT_EQ(members[1].name, "b//");
  EXPECT_EQ(place(members[1].key), "a.json:4:6");
  EXPECT_EQ(members[1].value.text(), "/* ,] \" */");
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
  EXPECT_EQ(error_in("[1,\n 1e999]"), "a.json:2:2: the number 1e999 is too large; at most 1.7e308");
  EXPECT_EQ(error_in("[-1e999 ]"), "a.json:1:2: the number -1e999 is too large; at most 1.7e308");
  EXPECT_EQ(error_in("[1e308, 1e-400, 123456789012345678901234567890]"), "no error");
}

TEST(LocatedJson, NestsAsDeepAsTheTextIsLong) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + "1" + std::string(depth, ']');
  };
  EXPECT_EQ(error_in(nested(1'000'000)), "no error");
  EXPECT_EQ(error_in(nested(64), {.deepest = 64}), "no error");
  for (const std::size_t depth : {65, 1'000'000}) {
    EXPECT_EQ(error_in(nested(depth), {.deepest = 64}),
              "a.json:1:65: values are nested more than 64 deep");
  }
}

TEST(LocatedJson, RulesDecideOnNullZerosAndNames) {
  EXPECT_TRUE(parse(R"({"a": null})").has("a"));
  EXPECT_FALSE(parse(R"({"a": null})", {.null_is_absent = true}).has("a"));
  EXPECT_EQ(parse(R"("a\u0000")").text().size(), 2U);
  const LocatedJson zeros = parse(R"([1, "a\u0000b"])", {.may_have_zeros = false});
  EXPECT_EQ(error_of([&] { zeros[1].text(); }), "a.json:1:5#/1: must have no zero byte");
  const LocatedJson nameless = LocatedJson::parse(R"({"crop": [1, true]})", {});
  EXPECT_EQ(error_of([&] { nameless.at("crop")[1].number(); }),
            "crop/1: must be a number, not true");
  EXPECT_EQ(error_of([&] { nameless.at("x"); }), "there is no \"x\" here");
}

}  // namespace
}  // namespace ajar
