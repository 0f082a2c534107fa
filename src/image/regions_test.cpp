#include "image/regions.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace ajar {
namespace {

/// One letter per pixel: its object; rows are separated by spaces. '.' is "nothing there".
Regions regions_of(const std::string& picture) {
  const auto width = static_cast<int>(std::min(picture.find(' '), picture.size()));
  std::vector<PixelIdentity> identities;
  for (const char c : picture) {
    if (c == ' ') continue;
    const auto object = c == '.' ? 0U : static_cast<std::uint32_t>(c - 'a' + 1);
    identities.push_back({object, object == 0 ? 0U : 1U});
  }
  return connected_regions(Vec2i(width, static_cast<int>(identities.size()) / width), identities);
}
using Labels = std::vector<std::uint32_t>;

TEST(Regions, AreNumberedRowByRow) {
  const Regions regions = regions_of("aabb acab cccc");
  EXPECT_EQ(regions.labels, (Labels{0, 0, 1, 1,  //
                                    0, 2, 3, 1,  //
                                    2, 2, 2, 2}));
  EXPECT_EQ(regions.pixel_counts, (Labels{3, 3, 5, 1}));
  EXPECT_EQ(regions.identities[1].object, 2U);
  EXPECT_EQ(regions.identities[3].object, 1U);
}

TEST(Regions, DoNotConnectThroughCorners) {
  EXPECT_EQ(regions_of("ab ba").labels, (Labels{0, 1, 2, 3}));
}

TEST(Regions, DoNotConnectAroundTheBorder) {
  // The end of a row and the start of the next lie side by side in memory only.
  EXPECT_EQ(regions_of("ba ab").labels, (Labels{0, 1, 2, 3}));
  EXPECT_EQ(regions_of("aba aba").labels, (Labels{0, 1, 2, 0, 1, 2}));
}

TEST(Regions, JoinBranchesThatMeetFurtherDown) {
  // The arms of a U and of a W are met before what joins them; a spiral is one region.
  EXPECT_EQ(regions_of("aba aaa").labels, (Labels{0, 1, 0, 0, 0, 0}));
  EXPECT_EQ(regions_of("ababa aaaaa").count(), 3U);
  EXPECT_EQ(regions_of("aaaaa bbbba aaaba abbba aaaaa").count(), 2U);
}

TEST(Regions, OfOneRowOrColumn) {
  EXPECT_EQ(regions_of("aabba").labels, (Labels{0, 0, 1, 1, 2}));
  EXPECT_EQ(regions_of("a a b b a").labels, (Labels{0, 0, 1, 1, 2}));
  EXPECT_EQ(regions_of("a").labels, (Labels{0}));
}

TEST(Regions, OfBackgroundAreRegionsToo) {
  const Regions regions = regions_of(".a. .a.");
  EXPECT_EQ(regions.labels, (Labels{0, 1, 2, 0, 1, 2}));
  EXPECT_EQ(regions.identities[0], PixelIdentity());
}

TEST(Regions, SeparateMaterialsOfAnObject) {
  const std::vector<PixelIdentity> identities = {{1, 1}, {1, 2}, {2, 2}, {2, 2}};
  EXPECT_EQ(connected_regions(Vec2i(4, 1), identities).labels, (Labels{0, 1, 2, 2}));
}

TEST(Regions, EqualAFloodFillOnRandomPictures) {
  std::mt19937 generator(9);
  for (int run = 0; run < 50; ++run) {
    const Vec2i size(1 + static_cast<int>(generator() % 17),
                     1 + static_cast<int>(generator() % 13));
    std::vector<PixelIdentity> identities(static_cast<std::size_t>(size.x * size.y));
    for (PixelIdentity& identity : identities) {
      identity = {static_cast<std::uint32_t>(generator() % 2),
                  static_cast<std::uint32_t>(generator() % 2)};
    }
    // Labels grow by one neighbour at a time until none changes.
    std::vector<std::size_t> expected(identities.size());
    for (std::size_t i = 0; i < expected.size(); ++i) expected[i] = i;
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < expected.size(); ++i) {
        for (std::size_t j = 0; j < expected.size(); ++j) {
          const auto width = static_cast<std::size_t>(size.x);
          const bool beside = i / width == j / width && (i + 1 == j || j + 1 == i);
          const bool below = i + width == j || j + width == i;
          if ((beside || below) && identities[i] == identities[j] && expected[j] < expected[i]) {
            expected[i] = expected[j];
            changed = true;
          }
        }
      }
    }
    const Regions regions = connected_regions(size, identities);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (expected[i] == i) {
        EXPECT_EQ(regions.labels[i], next++);
      } else {
        EXPECT_EQ(regions.labels[i], regions.labels[expected[i]]);
      }
      EXPECT_EQ(regions.identities[regions.labels[i]], identities[i]);
    }
    EXPECT_EQ(regions.count(), next);
  }
}

TEST(Regions, OfALargePictureNeedNoDeepStack) {
  const Vec2i size(1000, 1000);
  const Regions regions =
      connected_regions(size, std::vector<PixelIdentity>(1000000, PixelIdentity{1, 1}));
  EXPECT_EQ(regions.pixel_counts, (Labels{1000000}));
}

TEST(Regions, RefuseIdentitiesOfAnotherPicture) {
  EXPECT_THROW(connected_regions(Vec2i(2, 2), std::vector<PixelIdentity>(3)),
               std::invalid_argument);
  EXPECT_EQ(connected_regions(Vec2i(0, 5), {}).count(), 0U);
}

TEST(FillRegions, GivesEachPixelTheValueOfItsRegion) {
  const Regions regions = regions_of("ab aa");
  EXPECT_EQ(fill_regions(regions, std::vector<float>{0.5F, 2.F}).values,
            (std::vector<float>{0.5F, 2.F, 0.5F, 0.5F}));
  EXPECT_THROW(fill_regions(regions, std::vector<float>{1.F}), std::invalid_argument);
}

}  // namespace
}  // namespace ajar
