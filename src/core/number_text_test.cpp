#include "core/number_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace ajar {
namespace {

TEST(NumberText, HasNoExponentForWholeNumbers) {
  EXPECT_EQ(number_text(1e8), "100000000");
  EXPECT_EQ(number_text(-2.0), "-2");
  EXPECT_EQ(number_text(0.05), "0.05");
  EXPECT_EQ(number_text(1e-9), "1e-09");
  EXPECT_EQ(number_text(1e30), "1e+30");
}

TEST(NumberOf, ParsesAWholeText) {
  EXPECT_EQ(number_of("-0.33"), -0.33);
  EXPECT_EQ(number_of("+2e3"), 2000.0);
  for (const char* const none : {"", "+", "0,5", "1 ", " 1", "1x", "+-1", "0x1p3"}) {
    EXPECT_EQ(number_of(none), std::nullopt) << none;
  }
}

TEST(NumberOf, DistinguishesOverflowFromUnderflow) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const char* const large : {"1.5e400", "1e+400", "123456.5e305", "1e99999999999999999999"}) {
    EXPECT_EQ(number_of(large), infinity) << large;
    EXPECT_EQ(number_of("-" + std::string(large)), -infinity) << large;
  }
  EXPECT_EQ(number_of("0." + std::string(100, '0') + "1e500"), infinity);
  for (const char* const small : {"1.5e-400", "0.0001e-330", "1e-99999999999999999999"}) {
    EXPECT_EQ(number_of(small), 0.0) << small;
  }
  EXPECT_EQ(number_of("1" + std::string(100, '0') + "e-500"), 0.0);
}

TEST(DecimalOf, IsTheShortestDecimal) {
  EXPECT_EQ(decimal_of(0.1F), 0.1);
  EXPECT_EQ(decimal_of(-3e20F), -3e20);
}

TEST(PercentText, HasTwoDigitsOrAllBeforeThePoint) {
  EXPECT_EQ(percent_text(0.00512), "0.51 %");
  EXPECT_EQ(percent_text(0.2134), "21 %");
  EXPECT_EQ(percent_text(0.999), "100 %");
  EXPECT_EQ(percent_text(1.5), "150 %");
}

}  // namespace
}  // namespace ajar
