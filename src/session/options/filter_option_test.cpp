#include "session/options/filter_option.h"

#include <gtest/gtest.h>

#include <variant>

#include "core/error.h"

namespace ajar {
namespace {

TEST(FilterOption, HasTheRadiusThatIsGivenOrThatOfItsKind) {
  const desc::Filter box = parse_filter("--filter", "box");
  EXPECT_TRUE(std::holds_alternative<desc::BoxFilter>(box.node));
  EXPECT_EQ(box.radius, Vec2(0.5F, 0.5F));
  const desc::Filter gaussian = parse_filter("--filter", "gaussian:1.5");
  EXPECT_TRUE(std::holds_alternative<desc::GaussianFilter>(gaussian.node));
  EXPECT_EQ(gaussian.radius, Vec2(1.5F, 1.5F));
  EXPECT_EQ(parse_filter("--filter", "sinc").radius, Vec2(4.F, 4.F));
}

TEST(FilterOption, SaysWhatCannotBe) {
  const auto error_of = [](const char* text) -> std::string {
    try {
      parse_filter("--filter", text);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_NE(error_of("gausian").find("did you mean \"gaussian\"?"), std::string::npos);
  for (const char* text : {"box:", "box:0", "box:-1", "box:65", "box:nan", "box:1:2", "box:wide"}) {
    EXPECT_NE(error_of(text).find("--filter"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace ajar
