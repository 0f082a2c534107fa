#include "core/number_text.h"

#include <gtest/gtest.h>

namespace ajar {
namespace {

TEST(NumberText, HasNoExponentForWholeNumbers) {
  EXPECT_EQ(number_text(1e8), "100000000");
  EXPECT_EQ(number_text(-2.0), "-2");
  EXPECT_EQ(number_text(0.05), "0.05");
  EXPECT_EQ(number_text(1e-9), "1e-09");
  EXPECT_EQ(number_text(1e30), "1e+30");
}

TEST(PercentText, HasTwoDigitsOrAllBeforeThePoint) {
  EXPECT_EQ(percent_text(0.00512), "0.51 %");
  EXPECT_EQ(percent_text(0.2134), "21 %");
  EXPECT_EQ(percent_text(0.999), "100 %");
  EXPECT_EQ(percent_text(1.5), "150 %");
}

}  // namespace
}  // namespace ajar
