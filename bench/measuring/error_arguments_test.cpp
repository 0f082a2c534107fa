#include "measuring/error_arguments.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace ajar::bench {
namespace {

using Texts = std::vector<std::string>;

TEST(ErrorArguments, HaveDefaults) {
  const auto arguments = parse_error_arguments({});
  ASSERT_TRUE(arguments);
  EXPECT_EQ(arguments->seconds, 8.0);
  EXPECT_EQ(arguments->repeats, 3);
  EXPECT_EQ(arguments->size, 256);
  EXPECT_FALSE(arguments->scale);
  EXPECT_FALSE(arguments->depth);
  EXPECT_TRUE(arguments->scenes.empty());
  EXPECT_EQ(arguments->variants, (Texts{"pt", "lt", "ibpt", "bdpt"}));
}

TEST(ErrorArguments, TakeScenesBeforeAndVariantsAfterTheDashes) {
  const auto arguments =
      parse_error_arguments({"--seconds", "60", "--repeats=2", "veach-bidir", "cornell", "--depth",
                             "8", "--", "ibpt", "bdpt:heuristic=balance"});
  ASSERT_TRUE(arguments);
  EXPECT_EQ(arguments->seconds, 60.0);
  EXPECT_EQ(arguments->repeats, 2);
  EXPECT_EQ(arguments->depth, 8);
  EXPECT_EQ(arguments->scenes, (Texts{"veach-bidir", "cornell"}));
  EXPECT_EQ(arguments->variants, (Texts{"ibpt", "bdpt:heuristic=balance"}));
}

TEST(ErrorArguments, InvalidOnesAreRefused) {
  for (const Texts& texts :
       {Texts{"--seconds", "0"}, Texts{"--seconds", "soon"}, Texts{"--repeats", "0"},
        Texts{"--no-such-option"}, Texts{"--size", "64", "--scale", "2"}, Texts{"--filter", "tent"},
        Texts{"--depth", "-3"}, Texts{"--seconds"},
        Texts{"--shared-reference", "--filter", "scene"}}) {
    EXPECT_THROW(parse_error_arguments(texts), UsageError) << texts.front();
  }
}

}  // namespace
}  // namespace ajar::bench
