#include "core/error.h"

#include <gtest/gtest.h>

namespace ajar {
namespace {

TEST(SourceLocation, PrintsOnlyWhatIsKnown) {
  const auto file = std::make_shared<const std::string>("room.pbrt");
  EXPECT_EQ((SourceLocation{file, 12, 3}).to_string(), "room.pbrt:12:3");
  EXPECT_EQ((SourceLocation{file, 12, 0}).to_string(), "room.pbrt:12");
  EXPECT_EQ((SourceLocation{file, 0, 5}).to_string(), "room.pbrt");
  EXPECT_EQ(SourceLocation{}.to_string(), "");
}

TEST(Errors, HaveTheExitCodesOfTheManual) {
  EXPECT_EQ(UsageError("x").exit_code(), 2);
  EXPECT_EQ(SceneError("x").exit_code(), 3);
  EXPECT_EQ(IoError("x").exit_code(), 4);
}

TEST(Errors, SceneErrorStartsWithItsPlace) {
  const SourceLocation where{std::make_shared<const std::string>("a.pbrt"), 2, 7};
  EXPECT_STREQ(SceneError(where, "no camera").what(), "a.pbrt:2:7: no camera");
}

TEST(NearestName, FindsSmallTypos) {
  const std::vector<std::string> names{"bdpt", "ibpt", "lt", "pt", "selective"};
  EXPECT_EQ(nearest_name("bpdt", names), "bdpt");
  EXPECT_EQ(nearest_name("selctive", names), "selective");
  EXPECT_EQ(nearest_name("pt", names), "pt");
  const std::vector<std::string> chains{"lt", "mlt", "mmlt"};
  EXPECT_EQ(nearest_name("mtl", chains), "mlt");
  EXPECT_EQ(nearest_name("MLT", chains), "mlt");
}

TEST(NearestName, IsEmptyWithoutANearOne) {
  const std::vector<std::string> names{"selective", "path-space"};
  EXPECT_EQ(nearest_name("zzzzzzz", names), "");
}

TEST(UnknownName, ListsTheValidOnes) {
  const std::vector<std::string> names{"bdpt", "pt"};
  EXPECT_EQ(unknown_name_message("integrator", "bpdt", names),
            "unknown integrator \"bpdt\"; did you mean \"bdpt\"? Valid: bdpt, pt");
}

}  // namespace
}  // namespace ajar
