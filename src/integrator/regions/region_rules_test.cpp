#include "integrator/regions/region_rules.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace ajar {
namespace {

using Subject = RegionRule::Subject;
using Choice = RegionRule::Choice;

std::vector<RegionRule> parse(const std::string& text) {
  return parse_region_rules(text, "my.rules");
}

/// The message that the text is refused with.
std::string refusal(const std::string& text) {
  try {
    parse(text);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "not refused";
}
void expect_in(const std::string& part, const std::string& message) {
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(RegionRules, AreOnePerLine) {
  const auto rules = parse(
      "# lamps\n"
      "object lamp* chain\n"
      "\n"
      "  material\t\"white paint\"  omc # not the #hard ones\r\n"
      "object vase 0.25\n"
      "object vase#2 auto");
  ASSERT_EQ(rules.size(), 4U);
  EXPECT_EQ(rules[0].subject, Subject::Object);
  EXPECT_EQ(rules[0].pattern, "lamp*");
  EXPECT_EQ(rules[0].choice, Choice::Chain);
  EXPECT_EQ(rules[0].where.to_string(), "my.rules:2:8");
  EXPECT_EQ(rules[1].subject, Subject::Material);
  EXPECT_EQ(rules[1].pattern, "white paint");
  EXPECT_EQ(rules[1].choice, Choice::Omc);
  EXPECT_EQ(rules[1].where.to_string(), "my.rules:4:12");
  EXPECT_EQ(rules[2].choice, Choice::Weight);
  EXPECT_EQ(rules[2].weight, 0.25F);
  EXPECT_EQ(rules[3].pattern, "vase#2");
  EXPECT_EQ(rules[3].choice, Choice::Auto);
}

TEST(RegionRules, MayBeMarkedAsUnicode) {
  EXPECT_EQ(parse_region_rules("\xEF\xBB\xBFobject lamp omc\n", "rules.txt").size(), 1U);
}

TEST(RegionRules, OfAnEmptyTextAreNone) {
  for (const char* text : {"", "\n\n", "   ", "# only this", "\r\n \t\r\n"}) {
    EXPECT_TRUE(parse(text).empty()) << text;
  }
}

TEST(RegionRules, SayWhereAndWhatIsWrong) {
  expect_in("my.rules:2:1: unknown subject of a rule \"objct\"; did you mean \"object\"?",
            refusal("object a omc\nobjct b omc"));
  expect_in("Valid: object, material", refusal("objct b omc"));
  const std::string choice = refusal("object a chian");
  expect_in("my.rules:1:10: unknown choice \"chian\"; did you mean \"chain\"?", choice);
  expect_in("Valid: auto, omc, chain, or a weight between 0 and 1", choice);
  expect_in("my.rules:1:7: expected the name", refusal("object"));
  expect_in("my.rules:1:9: expected the name", refusal("object  # a omc"));
  expect_in("my.rules:1:9: expected auto, omc, chain, or a weight", refusal("object a"));
  expect_in("my.rules:1:14: \"omc\" is too much", refusal("object a omc omc"));
  expect_in("my.rules:1:16: unknown choice \"paint\"", refusal("material white paint omc"));
}

TEST(RegionRules, RefuseWeightsThatAreNone) {
  for (const char* weight : {"1.5", "-0.1", "inf", "nan", "1e9"}) {
    expect_in("my.rules:1:10: the weight", refusal(std::string("object a ") + weight));
  }
  for (const char* weight : {"0.5x", "0,5", "+-1", "1e99999"}) {
    expect_in("my.rules:1:10: unknown choice", refusal(std::string("object a ") + weight));
  }
  EXPECT_EQ(parse("object a 0")[0].weight, 0.F);
  EXPECT_EQ(parse("object a 1")[0].weight, 1.F);
}

TEST(RegionRules, RefuseQuotesThatDoNotFit) {
  expect_in("my.rules:1:8: this quotation mark is not closed",
            refusal("object \"a omc\nobject b omc\""));
  expect_in("my.rules:1:11: expected a space", refusal("object \"a\"omc"));
  expect_in("my.rules:1:8: the name is empty", refusal("object \"\" omc"));
  EXPECT_EQ(parse("object \"# a\" omc")[0].pattern, "# a");
}

TEST(MatchesPattern, FillsStarsWithAnything) {
  EXPECT_TRUE(matches_pattern("lamp", "lamp"));
  EXPECT_FALSE(matches_pattern("lamp", "lamp2"));
  EXPECT_FALSE(matches_pattern("lamp2", "lamp"));
  EXPECT_TRUE(matches_pattern("*", ""));
  EXPECT_TRUE(matches_pattern("*", "anything"));
  EXPECT_TRUE(matches_pattern("lamp*", "lamp"));
  EXPECT_TRUE(matches_pattern("*lamp", "old lamp"));
  EXPECT_TRUE(matches_pattern("a*b*c", "axxbyybzc"));
  EXPECT_FALSE(matches_pattern("a*b*c", "axxbyybz"));
  EXPECT_TRUE(matches_pattern("**a**", "a"));
  EXPECT_TRUE(matches_pattern("*aab", "aaaab"));
  EXPECT_FALSE(matches_pattern("", "a"));
  EXPECT_TRUE(matches_pattern("", ""));
}

/// By trying every length of every star.
bool matches_by_trial(std::string_view pattern, std::string_view name) {
  if (pattern.empty()) return name.empty();
  if (pattern[0] != '*') {
    return !name.empty() && name[0] == pattern[0] &&
           matches_by_trial(pattern.substr(1), name.substr(1));
  }
  for (std::size_t length = 0; length <= name.size(); ++length) {
    if (matches_by_trial(pattern.substr(1), name.substr(length))) return true;
  }
  return false;
}

TEST(MatchesPattern, EqualsTryingEveryLengthOfEveryStar) {
  // All patterns of up to five and all names of up to six characters.
  const auto words = [](const std::string& letters, std::size_t longest) {
    std::vector<std::string> result = {""};
    for (std::size_t i = 0; i < result.size() && result[i].size() < longest; ++i) {
      for (const char letter : letters) result.push_back(result[i] + letter);
    }
    return result;
  };
  const auto names = words("ab", 6);
  for (const std::string& pattern : words("ab*", 5)) {
    for (const std::string& name : names) {
      ASSERT_EQ(matches_pattern(pattern, name), matches_by_trial(pattern, name))
          << pattern << ", " << name;
    }
  }
}

TEST(MatchesPattern, NeedsNoExponentialTime) {
  std::string pattern;
  for (int i = 0; i < 50; ++i) pattern += "a*";
  EXPECT_FALSE(matches_pattern(pattern + "b", std::string(5000, 'a')));
}

TEST(FindRegionRule, TakesTheLastThatMatches) {
  const auto rules = parse("object * omc\nmaterial glass chain\nobject vase 0.5\nobject lamp auto");
  EXPECT_EQ(find_region_rule(rules, "table", "wood"), &rules[0]);
  EXPECT_EQ(find_region_rule(rules, "table", "glass"), &rules[1]);
  EXPECT_EQ(find_region_rule(rules, "vase", "glass"), &rules[2]);
  EXPECT_EQ(find_region_rule(rules, "lamp", "glass"), &rules[3]);
  EXPECT_EQ(find_region_rule(parse("object vase omc"), "glass", "vase"), nullptr);
  EXPECT_EQ(find_region_rule({}, "a", "b"), nullptr);
}

TEST(FixedWeight, IsEpsilonForMonteCarloAndOneForChains) {
  const auto rules = parse("object a omc\nobject a chain\nobject a 0.3\nobject a auto");
  EXPECT_EQ(fixed_weight(rules[0], 0.1F), 0.1F);
  EXPECT_EQ(fixed_weight(rules[1], 0.1F), 1.F);
  EXPECT_EQ(fixed_weight(rules[2], 0.1F), 0.3F);
  EXPECT_EQ(fixed_weight(rules[3], 0.1F), std::nullopt);
}

TEST(CheckRegionRules, FindsNamesThatTheSceneDoesNotHave) {
  const std::vector<std::string> objects = {"lamp", "lamp-foot", "table"};
  const std::vector<std::string> materials = {"glass"};
  EXPECT_NO_THROW(
      check_region_rules(parse("object lamp* omc\nmaterial * omc"), objects, materials));
  const auto message = [&](const std::string& text) -> std::string {
    try {
      check_region_rules(parse(text), objects, materials);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "not refused";
  };
  const std::string object = message("object table omc\nobject tabel omc");
  expect_in("my.rules:2:8: unknown object \"tabel\"; did you mean \"table\"?", object);
  expect_in("Valid: lamp, lamp-foot, table", object);
  expect_in("unknown material \"table\"", message("material table omc"));
  expect_in("unknown object \"chair*\"", message("object chair* omc"));
}

TEST(CheckRegionRules, DoesNotListThousandsOfNames) {
  std::vector<std::string> objects;
  objects.reserve(5000);
  for (int i = 0; i < 5000; ++i) objects.push_back("leaf " + std::to_string(i));
  try {
    check_region_rules(parse("object \"lead 7\" omc"), objects, {});
    FAIL();
  } catch (const SceneError& error) {
    expect_in("did you mean \"leaf 7\"?", error.what());
    EXPECT_LT(std::string(error.what()).size(), 200U);
  }
}

}  // namespace
}  // namespace ajar
