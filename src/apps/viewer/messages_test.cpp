#include "apps/viewer/messages.h"

#include <gtest/gtest.h>

#include <random>

#include "core/error.h"

namespace ajar::viewer {
namespace {

LiveState after(const std::string& text) {
  LiveState state;
  EXPECT_TRUE(apply_message(parse_message(text), state)) << text;
  return state;
}

TEST(ViewerMessages, ChangeTheState) {
  EXPECT_EQ(after(R"({"type":"resolution","width":64,"height":32})").resolution,
            (std::array<int, 2>{64, 32}));
  EXPECT_EQ(after(R"({"type":"crop","window":[1,2,3,4]})").crop, (std::array<int, 4>{1, 2, 3, 4}));
  EXPECT_FALSE(after(R"({"type":"crop","window":null})").crop);
  const LiveState method =
      after(R"({"type":"method","integrator":"pt","parameters":{"roulette":"usual"}})");
  EXPECT_EQ(method.integrator, "pt");
  EXPECT_EQ(method.parameters.at("roulette"), "usual");
  const LiveState rules =
      after(R"({"type":"regions","rules":[{"kind":"object","name":"a b","choice":"chain"},)"
            R"({"kind":"material","name":"glass*","choice":0.25}]})");
  EXPECT_EQ(rules_text(rules.rules), "object \"a b\" chain\nmaterial \"glass*\" 0.25\n");
  const LiveState camera =
      after(R"({"type":"camera","position":[0,0,0],"target":[0,0,2],"up":[0,1,0],"fov":40,)"
            R"("lens_radius":0.1,"focal_distance":2})");
  EXPECT_EQ(camera.camera->target, Vec3(0, 0, 2));
  const LiveState edit =
      after(R"({"type":"edit","kind":"lights","index":0,"parameters":{"power":2}})");
  EXPECT_EQ(edit.edits.front().at("kind"), "light");
}

TEST(ViewerMessages, WhatCannotBeChangesNothing) {
  for (const char* text :
       {"",
        "[]",
        "null",
        "7",
        "{",
        R"({"type":7})",
        R"({"type":"resolution"})",
        R"({"type":"resolution","width":0,"height":9})",
        R"({"type":"resolution","width":1e9,"height":9})",
        R"({"type":"resolution","width":1.5,"height":9})",
        R"({"type":"crop","window":[4,4,4,5]})",
        R"({"type":"crop","window":[-1,0,4,5]})",
        R"({"type":"crop","window":[0,0,4]})",
        R"({"type":"method","integrator":"nothing","parameters":{}})",
        R"({"type":"method","integrator":"pt","parameters":{"roulette":"none"}})",
        R"({"type":"method","integrator":"selective","parameters":{"regions":"/etc/passwd"}})",
        R"({"type":"method","integrator":"selective","parameters":{"importance":"/etc/passwd"}})",
        R"({"type":"regions","rules":[{"kind":"object","name":"a\"b","choice":"chain"}]})",
        R"({"type":"regions","rules":[{"kind":"object","name":"a","choice":"chains"}]})",
        R"({"type":"regions","rules":[{"kind":"object","name":"a","choice":2}]})",
        R"({"type":"regions","rules":[{"kind":"lamp","name":"a","choice":"omc"}]})",
        R"({"type":"camera","position":[0,0,0],"target":[0,0,0],"up":[0,1,0],"fov":40,)"
        R"("lens_radius":0,"focal_distance":1})",
        R"({"type":"camera","position":[0,0,0],"target":[0,2,0],"up":[0,1,0],"fov":40,)"
        R"("lens_radius":0,"focal_distance":1})",
        R"({"type":"camera","position":[0,0,1e99],"target":[0,2,0],"up":[0,1,0],"fov":40,)"
        R"("lens_radius":0,"focal_distance":1})",
        R"({"type":"edit","kind":"shapes","index":0,"parameters":{}})",
        R"({"type":"edit","kind":"materials","index":-1,"parameters":{}})",
        R"({"type":"edit","kind":"materials","index":0,"parameters":{"color":{"image":0}}})"}) {
    LiveState state;
    EXPECT_THROW(apply_message(parse_message(text), state), UsageError) << text;
    EXPECT_EQ(state.resolution, std::nullopt);
    EXPECT_TRUE(state.integrator.empty() && state.rules.empty() && state.edits.empty());
  }
  LiveState state;
  EXPECT_FALSE(apply_message(parse_message(R"({"type":"dance"})"), state));
  EXPECT_THROW(parse_message(std::string(60'000, '[')), UsageError);
}

TEST(ViewerMessages, LimitsAreNumbersOrNull) {
  const StopAt stop =
      parse_stop_at(parse_message(R"({"type":"stop-at","samples":8,"seconds":null})"));
  EXPECT_EQ(stop.samples, 8.0);
  EXPECT_FALSE(stop.seconds || stop.error);
  EXPECT_THROW(parse_stop_at(parse_message(R"({"type":"stop-at","error":0})")), UsageError);
  EXPECT_THROW(parse_stop_at(parse_message(R"({"type":"stop-at","samples":"8"})")), UsageError);
}

TEST(ViewerMessages, AMaskHasAByteForEachPixel) {
  const std::string mask("AJM1\2\0\0\0\1\0\0\0\xff\x07", 14);
  const auto parsed = parse_mask(mask);
  EXPECT_EQ(parsed->size, Vec2i(2, 1));
  EXPECT_EQ(parsed->weights, (std::vector<std::uint8_t>{255, 7}));
  EXPECT_EQ(parse_mask(std::string("AJM1\0\0\0\0\0\0\0\0", 12)), nullptr);
  EXPECT_THROW(parse_mask(mask + "x"), UsageError);
  EXPECT_THROW(parse_mask(mask.substr(0, 11)), UsageError);
  EXPECT_THROW(parse_mask(std::string("AJM1\xff\xff\xff\xff\xff\xff\xff\xff", 12)), UsageError);
}

/// Changes of one or two bytes of messages: answered or refused, no more.
TEST(ViewerMessages, ChangedMessagesDoNoHarm) {
  const std::vector<std::string> whole = {
      R"({"type":"crop","window":[1,2,3,4]})",
      R"({"type":"method","integrator":"pt","parameters":{"roulette":"usual"}})",
      R"({"type":"regions","rules":[{"kind":"object","name":"a","choice":0.5}]})",
      R"({"type":"camera","position":[0,0,0],"target":[0,0,2],"up":[0,1,0],"fov":40,)"
      R"("lens_radius":0.1,"focal_distance":2})",
      R"({"type":"edit","kind":"lights","index":0,"parameters":{"power":2}})",
      std::string("AJM1\2\0\0\0\1\0\0\0\xff\x07", 14)};
  std::mt19937 random(7);
  int refused = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string text = whole[random() % whole.size()];
    for (unsigned changes = 0; changes < 1 + random() % 2; ++changes) {
      text[random() % text.size()] = static_cast<char>(random() % 256);
    }
    LiveState state;
    try {
      apply_message(parse_message(text), state);
      parse_mask(text);
    } catch (const UsageError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 10'000);
}

}  // namespace
}  // namespace ajar::viewer
