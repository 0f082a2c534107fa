#include "core/warning_digest.h"

#include <gtest/gtest.h>

#include <deque>

#include "core/testing/warning_kinds.h"

namespace ajar {
namespace {

using testing::kImage;
using testing::kLamp;
using testing::kParameter;
using testing::kTriangle;
using testing::line;

constexpr std::size_t kScreen = 20;
constexpr WarningKind kSpare{Effect::None, "spares are left"};

using Lines = std::vector<std::string>;

TEST(WarningDigest, IsEmptyWithoutWarnings) {
  const WarningDigest empty = digest(Warnings(), kScreen, "ajar info a.pbrt");
  EXPECT_TRUE(empty.lines.empty());
  EXPECT_EQ(empty.note, "");
}

TEST(WarningDigest, PrintsSingleWarningsInFull) {
  Warnings warnings;
  warnings.add(kImage, line(2), "cannot read \"a.png\"", "a.png");
  warnings.add(kLamp, line(3), "the lamp is out");
  const WarningDigest digested = digest(warnings, kScreen, "ajar info a.pbrt");
  EXPECT_EQ(digested.lines,
            (Lines{"a.pbrt:3:1: the lamp is out", "a.pbrt:2:1: cannot read \"a.png\""}));
  EXPECT_EQ(digested.note, "");
}

TEST(WarningDigest, GroupsAKindInOneLineWithExamples) {
  Warnings warnings;
  for (int i = 0; i < 3000; ++i) warnings.add(kParameter, line(i + 1), "ignored");
  for (int i = 0; i < 12; ++i) {
    warnings.add(kImage, line(9000 + i), "cannot read", std::to_string(i) + ".png");
  }
  const WarningDigest digested = digest(warnings, kScreen, "ajar info a.pbrt");
  EXPECT_EQ(digested.lines,
            (Lines{"a.pbrt:9000:1: 12 textures cannot be read, shown as magenta: 0.png, 1.png, "
                   "2.png, 3.png, …",
                   "a.pbrt:1:1: 3000 parameters are ignored"}));
  EXPECT_EQ(digested.note, "ajar info a.pbrt lists all 3012 warnings");
  EXPECT_EQ(digest(warnings, kScreen, "").note, "");
}

TEST(WarningDigest, CountsInvisibleWarningsInTheNote) {
  Warnings warnings;
  for (int i = 0; i < 2; ++i) warnings.add({kTriangle, line(i + 1), "3 of 8", "b.ply", 3});
  WarningDigest digested = digest(warnings, kScreen, "ajar info a.pbrt");
  EXPECT_TRUE(digested.lines.empty());
  EXPECT_EQ(digested.note,
            "without visible effect: a.pbrt:1:1: 6 triangles have no area, in 2 meshes: b.ply; "
            "ajar info a.pbrt lists all 2 warnings");
  warnings.add(kSpare, line(7), "a spare is left");
  EXPECT_EQ(digest(warnings, kScreen, "").note,
            "without visible effect: 6 triangles have no area, in 2 meshes (a.pbrt:1:1); "
            "a.pbrt:7:1: a spare is left");
}

TEST(WarningDigest, KeepsEveryKind) {
  std::deque<std::string> texts;
  Warnings warnings;
  const auto add_kinds = [&](Effect effect, int count) {
    for (int i = 0; i < count; ++i) {
      const WarningKind kind{effect, texts.emplace_back("kind " + std::to_string(texts.size()))};
      warnings.add(kind, line(1), texts.back());
    }
  };
  const auto all_told = [&](const Lines& lines) {
    std::string whole;
    for (const std::string& text : lines) whole += text + ";";
    return std::all_of(texts.begin(), texts.end(), [&](const std::string& text) {
      return whole.find(text + ";") != std::string::npos;
    });
  };
  add_kinds(Effect::Slight, 15);
  add_kinds(Effect::Surface, 5);
  add_kinds(Effect::Light, 3);
  // Warnings of the least effect share a line.
  Lines lines = digest(warnings, kScreen, "").lines;
  EXPECT_EQ(lines.size(), 9U);
  EXPECT_EQ(lines.front(), "a.pbrt:1:1: kind 20");
  EXPECT_TRUE(all_told(lines));
  add_kinds(Effect::Surface, 40);
  lines = digest(warnings, kScreen, "").lines;
  EXPECT_EQ(lines.size(), 5U);
  EXPECT_TRUE(all_told(lines));
  add_kinds(Effect::Light, 40);
  lines = digest(warnings, kScreen, "").lines;
  EXPECT_EQ(lines.size(), 3U);
  EXPECT_TRUE(all_told(lines));
}

}  // namespace
}  // namespace ajar
