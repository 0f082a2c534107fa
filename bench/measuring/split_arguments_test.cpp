#include "measuring/split_arguments.h"

#include <gtest/gtest.h>

namespace ajar::bench {
namespace {

using Texts = std::vector<std::string>;

TEST(SplitArguments, SplitAtTheFirstDashes) {
  const SplitArguments split = split_arguments({"a", "--", "b", "--", "c"});
  EXPECT_EQ(split.before, (Texts{"a"}));
  EXPECT_EQ(split.after, (Texts{"b", "--", "c"}));
}

TEST(SplitArguments, MayHaveNoDashes) {
  const SplitArguments split = split_arguments({"a", "b"});
  EXPECT_EQ(split.before, (Texts{"a", "b"}));
  EXPECT_TRUE(split.after.empty());
}

}  // namespace
}  // namespace ajar::bench
