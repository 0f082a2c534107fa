#include "core/warnings.h"

#include <gtest/gtest.h>

#include <thread>

#include "core/testing/warning_kinds.h"

namespace ajar {
namespace {

using testing::kImage;
using testing::kLamp;
using testing::kParameter;
using testing::kTriangle;
using testing::line;

constexpr WarningKind kOther{Effect::Slight, "others are ignored"};

TEST(Warnings, CountsAllAndKeepsSome) {
  Warnings warnings;
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&warnings] {
      for (int i = 0; i < 100; ++i) warnings.add(kParameter, {}, "same text");
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(warnings.count(), 400U);
  EXPECT_EQ(warnings.messages().size(), Warnings::kMaxKept);
  EXPECT_EQ(warnings.groups().front().count, 400U);
}

TEST(Warnings, KeepsThePlace) {
  Warnings warnings;
  warnings.add(kParameter, line(4), "unused parameter");
  ASSERT_EQ(warnings.messages().size(), 1U);
  EXPECT_EQ(warnings.messages()[0], "a.pbrt:4:1: unused parameter");
}

TEST(Warnings, KeepsTheOnesOfLargestEffect) {
  Warnings warnings(3);
  for (int i = 1; i <= 10; ++i) warnings.add(kParameter, line(i), "parameter");
  warnings.add(kImage, line(11), "first image");
  warnings.add(kLamp, line(12), "lamp");
  warnings.add(kImage, line(13), "second image");
  EXPECT_EQ(warnings.messages(),
            (std::vector<std::string>{"a.pbrt:12:1: lamp", "a.pbrt:11:1: first image",
                                      "a.pbrt:13:1: second image"}));
  EXPECT_EQ(warnings.count(), 13U);
  EXPECT_EQ(warnings.count(Effect::Slight), 10U);
  EXPECT_EQ(warnings.count(Effect::Geometry), 0U);
}

TEST(Warnings, AreGroupedByKindInTheOrderOfEffects) {
  Warnings warnings;
  warnings.add({kTriangle, line(1), "7 of 9", "a.ply", 7});
  warnings.add(kOther, line(2), "other");
  warnings.add(kParameter, line(3), "parameter", "x");
  warnings.add({kTriangle, line(4), "2 of 4", "b.ply", 2});
  warnings.add(kLamp, line(5), "lamp");
  warnings.add(kParameter, line(6), "parameter", "x");
  const std::vector<WarningGroup> groups = warnings.groups();
  ASSERT_EQ(groups.size(), 4U);
  EXPECT_EQ(groups[0].first.text(), "a.pbrt:5:1: lamp");
  EXPECT_EQ(groups[1].first.message, "other");
  EXPECT_EQ(groups[2].first.message, "parameter");
  EXPECT_EQ(groups[2].count, 2U);
  EXPECT_EQ(groups[2].subjects, std::vector<std::string>{"x"});
  EXPECT_EQ(groups[3].count, 2U);
  EXPECT_EQ(groups[3].amount, 9U);
  EXPECT_EQ(groups[3].subjects, (std::vector<std::string>{"a.ply", "b.ply"}));
  EXPECT_FALSE(groups[3].has_more_subjects);
}

TEST(Warnings, OfTheSameEffectAreInTheOrderOfTheFile) {
  const auto other = std::make_shared<const std::string>("b.pbrt");
  Warnings warnings;
  warnings.add(kParameter, line(7), "seventh");
  warnings.add(kOther, {}, "nowhere");
  warnings.add(kOther, {other, 1, 1}, "in another file");
  warnings.add(kOther, line(5), "fifth");
  warnings.add(kParameter, line(3), "third");
  EXPECT_EQ(
      warnings.messages(),
      (std::vector<std::string>{"a.pbrt:3:1: third", "a.pbrt:5:1: fifth", "a.pbrt:7:1: seventh",
                                "b.pbrt:1:1: in another file", "nowhere"}));
  const std::vector<WarningGroup> groups = warnings.groups();
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].first.message, "third");
  EXPECT_EQ(groups[0].count, 2U);
}

TEST(Warnings, NameAFewExamplesOfAGroup) {
  Warnings warnings;
  for (int i = 0; i < 9; ++i) warnings.add(kImage, line(i), "gone", std::to_string(i));
  const WarningGroup group = warnings.groups().front();
  EXPECT_EQ(group.subjects, (std::vector<std::string>{"0", "1", "2", "3"}));
  EXPECT_TRUE(group.has_more_subjects);
}

TEST(Warnings, MergeOthers) {
  Warnings others;
  for (int i = 0; i < 300; ++i) others.add(kParameter, line(i + 2), "parameter", std::to_string(i));
  others.add(kLamp, line(1), "lamp");
  Warnings warnings;
  warnings.add(kParameter, line(302), "the last", "0");
  warnings.add_all(others);
  EXPECT_EQ(warnings.count(), 302U) << "also of those that are not kept";
  EXPECT_EQ(warnings.messages().size(), Warnings::kMaxKept);
  EXPECT_EQ(warnings.messages().front(), "a.pbrt:1:1: lamp");
  const WarningGroup group = warnings.groups().at(1);
  EXPECT_EQ(group.count, 301U);
  EXPECT_EQ(group.amount, 301U);
  EXPECT_EQ(group.first.text(), "a.pbrt:2:1: parameter");
  EXPECT_EQ(group.subjects, (std::vector<std::string>{"0", "1", "2", "3"}));
  EXPECT_TRUE(group.has_more_subjects);
}

}  // namespace
}  // namespace ajar
