#include "study/report/log_plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

namespace ajar {
namespace {

struct Mark {
  double x, y;
  std::string point;
};

/// Marks of points, without those of the legend.
std::vector<Mark> marks(const std::string& svg) {
  std::vector<Mark> found;
  const std::regex pattern("d=\"M([0-9.]+) ([0-9.]+)m[^>]*data-point=\"([^\"]*)\"");
  for (std::sregex_iterator i(svg.begin(), svg.end(), pattern), end; i != end; ++i) {
    found.push_back({std::stod((*i)[1]), std::stod((*i)[2]), (*i)[3]});
  }
  return found;
}

std::string svg_of(const std::vector<PlotPoint>& points) {
  return to_svg({"", "", "", {{"a", points}}, "", ""});
}

TEST(LogPlot, EqualFactorsAreEqualDistances) {
  const std::string svg = svg_of({{1, 8, 7, 9}, {4, 2, 1, 3}, {2, 4, 3, 5}});
  const std::vector<Mark> found = marks(svg);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_NEAR(found[1].x - found[0].x, found[2].x - found[1].x, 0.2);
  EXPECT_NEAR(found[1].y - found[0].y, found[2].y - found[1].y, 0.2);
  EXPECT_LT(found[0].x, found[1].x) << "in order";
  EXPECT_LT(found[0].y, found[1].y) << "downwards";
  EXPECT_EQ(found[1].point, "2 4 3 5") << "for the page";
}

TEST(LogPlot, SaysHowManyValuesHaveNoLogarithm) {
  const std::string svg = svg_of(
      {{1, 0, 0, 0}, {0, 1, 1, 1}, {1, NAN, 1, 1}, {HUGE_VAL, 1, 1, 1}, {1, 1, -1, HUGE_VAL}});
  EXPECT_EQ(marks(svg).size(), 1U);
  EXPECT_NE(svg.find(">4 points are not drawn"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_EQ(svg_of({{1, 1, 1, 1}}).find("not drawn"), std::string::npos);
}

TEST(LogPlot, ABarThatNearsZeroIsCut) {
  EXPECT_EQ(marks(svg_of({{1, 1, 1, 1}, {2, 1, 1e-9, 1}}))[0].y,
            marks(svg_of({{1, 1, 1, 1}, {2, 1, 0.1, 1}}))[0].y)
      << "a decade below the lowest point";
}

TEST(LogPlot, BandsAndBarsReachFromLowToHigh) {
  // The second curve shows where these are.
  const std::string svg =
      to_svg({"",
              "",
              "",
              {{"a", {{1, 8, 4, 16}, {2, 8, 4, 16}}}, {"b", {{1, 4, 4, 4}, {2, 16, 16, 16}}}},
              "",
              ""});
  const std::vector<Mark> found = marks(svg);
  ASSERT_EQ(found.size(), 4U);
  const double low = found[2].y;
  const double high = found[3].y;
  const auto heights_of = [&](const std::string& pattern) {
    std::smatch path;
    EXPECT_TRUE(std::regex_search(svg, path, std::regex(pattern)));
    const std::string d = path[1];
    const std::regex point("[ML][0-9.]+ ([0-9.]+)(V([0-9.]+))?");
    std::vector<double> heights;
    for (std::sregex_iterator k(d.begin(), d.end(), point), end; k != end; ++k) {
      heights.push_back(std::stod((*k)[1]));
      if ((*k)[3].matched) heights.push_back(std::stod((*k)[3]));
    }
    return heights;
  };
  EXPECT_EQ(heights_of("class=\"band\" d=\"([^\"]*)\""), (std::vector{high, high, low, low}));
  EXPECT_EQ(heights_of("class=\"bars\" d=\"([^\"]*)\""), (std::vector{low, high, low, high}));
}

TEST(LogPlot, NamesDoNotOverlap) {
  LogPlot plot{"", "", "", {}, "", ""};
  for (int i = 0; i < 40; ++i) plot.curves.push_back({"name", {{1, 1 + i % 3 * 0.01, 1, 1}}});
  const std::string svg = to_svg(plot);
  std::vector<double> heights;
  const std::regex name("class=\"name\" x=\"[0-9.]+\" y=\"([0-9.]+)\"");
  for (std::sregex_iterator i(svg.begin(), svg.end(), name), end; i != end; ++i) {
    heights.push_back(std::stod((*i)[1]));
  }
  ASSERT_EQ(heights.size(), 40U);
  std::sort(heights.begin(), heights.end());
  for (std::size_t i = 1; i < heights.size(); ++i) EXPECT_GE(heights[i] - heights[i - 1], 15.9);
  const std::regex size("viewBox=\"0 0 [0-9]+ ([0-9]+)\"");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(svg, match, size));
  EXPECT_LT(heights.back(), std::stod(match[1]));
}

TEST(LogPlot, LargeAndSmallTicksArePowersOfTen) {
  const std::string svg = svg_of({{1e-5, 2e6, 2e6, 2e6}, {1e5, 3e6, 3e6, 3e6}});
  for (const char* tick :
       {">10⁻⁵<", ">0.001<", ">1<", ">10000<", ">10⁵<", ">2·10⁶<", ">2.2·10⁶<"}) {
    EXPECT_NE(svg.find(tick), std::string::npos) << tick;
  }
}

TEST(LogPlot, EachNameHasItsOwnStyleInAllPlots) {
  std::vector<LogPlot> plots{{"", "", "", {{"a", {}}, {"b", {}}}, "", ""},
                             {"", "", "", {{"b", {}}, {"c", {}}}, "", ""}};
  number_styles(plots);
  EXPECT_EQ(plots[0].curves[1].style, plots[1].curves[0].style);
  EXPECT_EQ(plots[1].curves[1].style, 2U);
}

TEST(LogPlot, AfterAllColoursDashesAndMarksDiffer) {
  std::set<std::string> keys;
  for (std::size_t style = 0; style < 24; ++style) {
    const std::string svg = to_svg({"", "", "", {{"a", {}, style}}, "", ""});
    const std::size_t group = svg.find("class=\"series ");
    keys.insert(svg.substr(group, svg.find("</g>", group) - group));
  }
  EXPECT_EQ(keys.size(), 24U);
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
