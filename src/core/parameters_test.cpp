#include "core/parameters.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace ajar {
namespace {

std::vector<ParameterSpec> specs() {
  return {
      {"roulette", ParameterType::Bool, "true", "", "end dark paths early", {}},
      {"chains", ParameterType::Int, "8", "", "number of chains", {}, 1, 64},
      {"sigma", ParameterType::Float, "0.5", "px", "size of small steps", {}, 0.0, 1.0},
      {"heuristic", ParameterType::Choice, "power", "", "MIS", {"balance", "power"}},
      {"label", ParameterType::Text, "", "", "free text", {}},
      {"limit", ParameterType::Float, "auto", "", "a bound", {"auto"}, 0.0, 8.0},
  };
}

std::string message_of(const std::map<std::string, std::string>& given) {
  try {
    const auto declared = specs();
    const Parameters parameters(declared, given);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(Parameters, DefaultsFillWhatIsNotGiven) {
  const auto declared = specs();
  const Parameters parameters(declared, {{"chains", "12"}});
  EXPECT_TRUE(parameters.get_bool("roulette"));
  EXPECT_EQ(parameters.get_int("chains"), 12);
  EXPECT_EQ(parameters.get_float("sigma"), 0.5);
  EXPECT_EQ(parameters.get_text("heuristic"), "power");
  EXPECT_EQ(parameters.get_text("label"), "");
  EXPECT_EQ(parameters.values().size(), declared.size());
}

TEST(Parameters, NumbersMayHaveWordsAsValues) {
  const auto declared = specs();
  EXPECT_FALSE(Parameters(declared, {}).get_number("limit"));
  EXPECT_EQ(Parameters(declared, {{"limit", "0.5"}}).get_number("limit"), 0.5);
  EXPECT_NE(message_of({{"limit", "none"}}).find("a number or auto"), std::string::npos);
  EXPECT_NE(message_of({{"limit", "9"}}).find("between 0 and 8"), std::string::npos);
}

TEST(Parameters, AllButTheBasicOnesAreForExperts) {
  auto declared = specs();
  mark_experts(declared, {"sigma", "chains"});
  std::string basic;
  for (const ParameterSpec& spec : declared) basic += spec.expert ? "" : spec.name + " ";
  EXPECT_EQ(basic, "chains sigma ");
  EXPECT_THROW(mark_experts(declared, {"sigmas"}), std::logic_error);
}

TEST(Parameters, AreInactiveWithoutAnEffect) {
  auto declared = specs();
  ParameterSpec& sigma = declared[2];
  sigma.depends_on = "heuristic";
  sigma.matters_for = {"balance"};
  EXPECT_FALSE(Parameters(declared, {}).matters(sigma));
  const Parameters balanced(declared, {{"heuristic", "balance"}});
  EXPECT_TRUE(balanced.matters(sigma));
  EXPECT_TRUE(balanced.matters(declared[0]));
}

TEST(Parameters, BooleansAreNormalised) {
  const auto declared = specs();
  for (const char* no : {"false", "off", "no", "0"}) {
    const Parameters parameters(declared, {{"roulette", no}});
    EXPECT_FALSE(parameters.get_bool("roulette")) << no;
    EXPECT_EQ(parameters.values().at("roulette"), "false") << no;
  }
}

TEST(Parameters, UnknownNameSuggestsTheNearestAndListsAll) {
  const std::string message = message_of({{"chain", "1"}});
  EXPECT_NE(message.find("did you mean \"chains\""), std::string::npos) << message;
  for (const auto& spec : specs()) {
    EXPECT_NE(message.find(spec.name), std::string::npos) << message;
  }
}

TEST(Parameters, WrongTypesAreUsageErrors) {
  EXPECT_NE(message_of({{"chains", "many"}}).find("whole number"), std::string::npos);
  EXPECT_NE(message_of({{"chains", "1.5"}}).find("whole number"), std::string::npos);
  EXPECT_NE(message_of({{"chains", ""}}).find("whole number"), std::string::npos);
  EXPECT_NE(message_of({{"sigma", "nan"}}).find("a number"), std::string::npos);
  EXPECT_NE(message_of({{"sigma", "0.5x"}}).find("a number"), std::string::npos);
  EXPECT_NE(message_of({{"roulette", "maybe"}}).find("true or false"), std::string::npos);
  EXPECT_NE(message_of({{"heuristic", "powr"}}).find("did you mean \"power\""), std::string::npos);
}

TEST(Parameters, RangeIsInclusiveAndChecked) {
  EXPECT_EQ(message_of({{"chains", "1"}}), "");
  EXPECT_EQ(message_of({{"chains", "64"}}), "");
  EXPECT_NE(message_of({{"chains", "0"}}).find("between 1 and 64"), std::string::npos);
  EXPECT_NE(message_of({{"chains", "65"}}).find("between 1 and 64"), std::string::npos);
  EXPECT_NE(message_of({{"sigma", "-0.1"}}).find("between 0 and 1"), std::string::npos);
}

TEST(Parameters, OpenRangesExcludeTheirBounds) {
  std::vector<ParameterSpec> declared = {
      {"fov", ParameterType::Float, "45", "degrees", "angle", {}, 0.0, 180.0}};
  declared[0].open_range = true;
  EXPECT_EQ(Parameters(declared, {{"fov", "179.9"}}).get_float("fov"), 179.9);
  for (const char* bound : {"0", "180"}) {
    try {
      const Parameters parameters(declared, {{"fov", bound}});
      FAIL() << bound;
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find("between 0 and 180, both excluded"),
                std::string::npos)
          << error.what();
    }
  }
}

TEST(Parameters, TypesOfScenesCannotBeSetAsText) {
  const std::vector<ParameterSpec> declared = {
      {"tint", ParameterType::Color, "1", "", "a colour", {}}};
  EXPECT_THROW(Parameters(declared, {}), std::logic_error);
}

TEST(Parameters, AskingForAnUndeclaredNameIsAProgrammingError) {
  const auto declared = specs();
  const Parameters parameters(declared, {});
  EXPECT_THROW(parameters.get_int("absent"), std::logic_error);
}

}  // namespace
}  // namespace ajar
