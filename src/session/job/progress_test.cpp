#include "session/job/progress.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace ajar {
namespace {

RenderSnapshot half_way() {
  RenderSnapshot s;
  s.budget.samples_per_pixel = 64;
  s.total_samples = 64;
  s.samples_done = 32.0;
  s.rays = 20'000'000;
  s.seconds = 10.0;
  s.relative_error = RelativeError{.value = 0.034};
  s.error_samples = 32;
  return s;
}

TEST(Progress, TimeLeftFollowsTheLimitThatComesFirst) {
  RenderSnapshot s = half_way();
  EXPECT_DOUBLE_EQ(seconds_left(s).value(), 10.0);
  EXPECT_DOUBLE_EQ(fraction_done(s).value(), 0.5);
  s.budget.seconds = 12.0;
  EXPECT_DOUBLE_EQ(seconds_left(s).value(), 2.0);
  s.budget.seconds = 100.0;
  EXPECT_DOUBLE_EQ(seconds_left(s).value(), 10.0);
}

TEST(Progress, TimeLeftUntilTheErrorGrowsWithItsSquare) {
  RenderSnapshot s = half_way();
  s.total_samples = 0;
  s.budget = {};
  s.budget.target_error = 0.017;
  EXPECT_NEAR(seconds_left(s).value(), 30.0, 1e-9);  // 4 times the samples, 10 s are over
}

TEST(Progress, APreparationTellsTheTimeItStillTakes) {
  RenderSnapshot s;
  s.budget.seconds = 100.0;
  s.seconds = 6.0;
  s.phase = RenderPhase::Prepare;
  EXPECT_FALSE(seconds_left(s).has_value());
  s.phase_done = 0.75;
  EXPECT_DOUBLE_EQ(seconds_left(s).value(), 2.0);
  EXPECT_DOUBLE_EQ(fraction_done(s).value(), 0.75);
  EXPECT_EQ(plain_line(s), "0:06, preparing, 0:02 left");
  EXPECT_NE(bar_line(s, 80).find("75 % · preparing · 0:06"), std::string::npos) << bar_line(s, 80);
  EXPECT_EQ(nlohmann::json::parse(json_line(s, "progress")).at("phase"), "prepare");
  EXPECT_EQ(nlohmann::json::parse(json_line(half_way(), "progress")).at("phase"), "render");
}

TEST(Progress, TimeLeftIsUnknownWithoutALimit) {
  RenderSnapshot s = half_way();
  s.budget = {};
  s.total_samples = 0;
  EXPECT_FALSE(seconds_left(s).has_value());
  EXPECT_FALSE(fraction_done(s).has_value());
  EXPECT_EQ(bar_line(s, 80).find('['), std::string::npos);
}

TEST(Progress, NothingIsKnownBeforeTheFirstSample) {
  RenderSnapshot s = half_way();
  s.samples_done = 0.0;
  s.seconds = 0.0;
  s.rays = 0;
  s.relative_error.reset();
  EXPECT_FALSE(seconds_left(s).has_value());
  EXPECT_FALSE(plain_line(s).empty());
  EXPECT_FALSE(bar_line(s, 80).empty());
}

TEST(Progress, NothingIsPromisedOnceTheTimeIsOver) {
  RenderSnapshot s = half_way();
  s.budget.seconds = s.seconds - 5.0;
  EXPECT_TRUE(plain_line(s).ends_with("finishing the pass")) << plain_line(s);
  EXPECT_EQ(bar_line(s, 120).find("0:00 left"), std::string::npos);
}

/// Near the target, it may take long until enough estimates agree.
TEST(Progress, NothingIsPromisedOnceTheErrorIsNearItsTarget) {
  RenderSnapshot s = half_way();
  s.total_samples = 0;
  s.budget = {};
  s.budget.target_error = 0.02;
  s.relative_error = {.value = 0.01};
  s.error_samples = 1;
  EXPECT_TRUE(plain_line(s).ends_with("checking the error")) << plain_line(s);
}

TEST(Progress, PlainLineHasAllNumbers) {
  EXPECT_EQ(plain_line(half_way()), "0:10, 32/64 spp, 2 M rays/s, error 3.4 %, 0:10 left");
}

TEST(Progress, BarFitsTheTerminal) {
  for (const int columns : {1, 10, 20, 40, 80, 100, 200}) {
    const std::string line = bar_line(half_way(), columns);
    const auto dots = std::count(line.begin(), line.end(), '\xC2');
    EXPECT_LE(static_cast<int>(line.size()) - static_cast<int>(dots), columns) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
  EXPECT_NE(bar_line(half_way(), 120).find("[####"), std::string::npos);
}

TEST(Progress, JsonLineHasItsKeys) {
  const auto json = nlohmann::json::parse(json_line(half_way(), "progress"));
  EXPECT_EQ(json.at("event"), "progress");
  EXPECT_EQ(json.at("samples_per_pixel"), 32.0);
  EXPECT_EQ(json.at("total_samples_per_pixel"), 64);
  EXPECT_EQ(json.at("rays"), 20'000'000);
  EXPECT_EQ(json.at("rays_per_second"), 2e6);
  EXPECT_EQ(json.at("estimated_relative_error"), 0.034);
  EXPECT_EQ(json.at("fraction"), 0.5);
  EXPECT_EQ(json.at("seconds_left"), 10.0);
  EXPECT_EQ(json.at("finishing"), false);
  RenderSnapshot unknown;
  EXPECT_TRUE(nlohmann::json::parse(json_line(unknown, "done")).at("seconds_left").is_null());
}

TEST(Numbers, AreShort) {
  EXPECT_EQ(short_number(950), "950");
  EXPECT_EQ(short_number(12'345), "12.3 k");
  EXPECT_EQ(short_number(4.56e6), "4.56 M");
  EXPECT_EQ(short_number(0), "0");
}

TEST(ClockText, ShowsHoursOnlyIfThereAreAny) {
  EXPECT_EQ(clock_text(5), "0:05");
  EXPECT_EQ(clock_text(723), "12:03");
  EXPECT_EQ(clock_text(3723), "1:02:03");
}

}  // namespace
}  // namespace ajar
