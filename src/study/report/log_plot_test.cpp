#include "study/report/log_plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

namespace ajar {
namespace {

/// Numbers that follow `attribute="` in the marks of a plot.
std::vector<double> circles(const std::string& svg, const std::string& attribute) {
  std::vector<double> values;
  const std::regex pattern("<circle[^>]*" + attribute + "=\"([-0-9.]+)\"");
  for (std::sregex_iterator i(svg.begin(), svg.end(), pattern), end; i != end; ++i) {
    values.push_back(std::stod((*i)[1]));
  }
  return values;
}

std::string svg_of(const std::vector<PlotPoint>& points) {
  return to_svg({"", "", "", {{"a", points}}, "", ""});
}

TEST(LogPlot, EqualFactorsAreEqualDistances) {
  const std::string svg = svg_of({{1, 8, 7, 9}, {4, 2, 1, 3}, {2, 4, 3, 5}});
  const std::vector<double> x = circles(svg, "cx");
  const std::vector<double> y = circles(svg, "cy");
  ASSERT_EQ(x.size(), 4U) << "three points, in order, and the legend";
  EXPECT_NEAR(x[1] - x[0], x[2] - x[1], 0.2);
  EXPECT_NEAR(y[1] - y[0], y[2] - y[1], 0.2);
  EXPECT_LT(x[0], x[1]);
  EXPECT_LT(y[0], y[1]) << "downwards";
}

TEST(LogPlot, LeavesOutValuesWithoutALogarithm) {
  const std::string svg = svg_of({{1, 0, 0, 0}, {0, 1, 1, 1}, {1, NAN, 1, 1}, {1, 1, -1, 3}});
  EXPECT_EQ(circles(svg, "cx").size(), 2U) << "one point and the legend";
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(LogPlot, AxesOfAFewPerCentHaveTicksToo) {
  for (const double high : {1.03, 1.3, 4.0, 30.0}) {
    const std::string svg = svg_of({{1, 2, 2, 2}, {100, 2 * high, 2, 2}});
    const std::regex label("text-anchor=\"end\"");
    const auto ticks = std::distance(std::sregex_iterator(svg.begin(), svg.end(), label), {});
    EXPECT_GE(ticks, 3) << high;
    EXPECT_LE(ticks, 10) << high;
  }
}

TEST(LogPlot, OfNothingIsAFrame) {
  const std::string svg = svg_of({});
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
}

TEST(LogPlot, EscapesNames) {
  const std::string svg = to_svg({"a<b & \"c\"", "", "", {}, "", ""});
  EXPECT_NE(svg.find("a&lt;b &amp; &quot;c&quot;"), std::string::npos);
}

}  // namespace
}  // namespace ajar
