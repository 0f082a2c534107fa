#include "transport/sources.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace ajar {
namespace {

/// The numbers of five vertices, and of the connections from them to a lamp and a light subpath.
template <typename Source>
std::vector<float> numbers(const SampleIdentity& identity, const Branches& branches) {
  Source source(identity);
  source.set_branches(branches);
  std::vector<float> all;
  for (int vertex = 0; vertex < 5; ++vertex) {
    all.push_back(source.get({Stream::Camera, vertex, Slot::BsdfLobe}));
    const Vec2 pair = source.get_pair({Stream::Camera, vertex, Slot::LightPositionX});
    all.insert(all.end(), {pair.x, pair.y});
    all.push_back(source.get({Stream::Connection, 3 * 256 + vertex, kConnectionCull}));
  }
  return all;
}
constexpr std::size_t kOfVertex = 4;

template <typename Source>
void expect_branches() {
  const SampleIdentity identity{7, 3, 8, 4};
  const std::vector<float> whole = numbers<Source>(identity, {});
  Branches first;
  first.enter(2, 0, 3);
  EXPECT_EQ(numbers<Source>(identity, first), whole) << "the first goes on as if it were alone";
  std::set<float> seen(whole.begin(), whole.end());
  Branches branches = first;
  for (const int index : {1, 2}) {
    branches.leave();
    branches.enter(2, index, 3);
    const std::vector<float> own = numbers<Source>(identity, branches);
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (i < 2 * kOfVertex) {
        EXPECT_EQ(own[i], whole[i]) << "vertices before the split are shared";
      } else {
        EXPECT_TRUE(seen.insert(own[i]).second) << "those after it are not: number " << i;
      }
    }
    // Split once more: the numbers in between stay.
    Branches again = branches;
    again.enter(4, 1, 2);
    EXPECT_EQ(again.paths(), 6);
    const std::vector<float> later = numbers<Source>(identity, again);
    for (std::size_t i = 0; i < later.size(); ++i) {
      EXPECT_EQ(later[i] == own[i], i < 4 * kOfVertex) << i;
    }
  }
}

TEST(Sources, GiveEachBranchNumbersOfItsOwn) {
  expect_branches<IndependentSource>();
  expect_branches<SobolSource>();
}

TEST(Sources, KeepTheLightsNumbersOfASplitPath) {
  SobolSource source({7, 3, 8, 4});
  const SampleAddress address(Stream::Light, 3, Slot::BsdfLobe);
  const float before = source.get(address);
  Branches branches;
  branches.enter(1, 1, 2);
  source.set_branches(branches);
  EXPECT_EQ(source.get(address), before);
}

}  // namespace
}  // namespace ajar
