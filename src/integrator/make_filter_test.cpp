#include "integrator/make_filter.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace ajar {
namespace {

TEST(MakeFilter, FollowsTheDescription) {
  const auto same = [](const Filter& a, const Filter& b) {
    return a.radius() == b.radius() && a.eval({0.3F, -0.2F}) == b.eval({0.3F, -0.2F});
  };
  const Vec2 r(2.F, 1.5F);
  EXPECT_TRUE(same(make_filter({r, desc::BoxFilter{}}), Filter::box(r)));
  EXPECT_TRUE(same(make_filter({r, desc::TriangleFilter{}}), Filter::triangle(r)));
  EXPECT_TRUE(same(make_filter({r, desc::GaussianFilter{3.F}}), Filter::gaussian(r, 3.F)));
  EXPECT_TRUE(
      same(make_filter({r, desc::MitchellFilter{0.2F, 0.4F}}), Filter::mitchell(r, 0.2F, 0.4F)));
  EXPECT_TRUE(same(make_filter({r, desc::SincFilter{2.F}}), Filter::sinc(r, 2.F)));
}

TEST(MakeFilter, ErrorsNameTheirPlace) {
  const SourceLocation where{std::make_shared<const std::string>("a.pbrt"), 7, 1};
  try {
    make_filter({Vec2(2.F, 2.F), desc::GaussianFilter{-1.F}, where});
    FAIL();
  } catch (const SceneError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind("a.pbrt:7:1: ", 0), 0U) << message;
    EXPECT_NE(message.find("its falloff must be above 0"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace ajar
