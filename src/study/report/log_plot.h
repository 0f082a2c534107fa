#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace ajar {

/// A point of a curve with the spread of the runs behind it.
struct PlotPoint {
  double x = 1;
  double y = 1;
  double low = 1;  ///< ends of the bar; not above 0: the bar ends at the lower border
  double high = 1;
};
struct PlotCurve {
  std::string name;
  std::vector<PlotPoint> points;  ///< in any order
  std::size_t style = 0;          ///< see `number_styles`
};
struct LogPlot {
  std::string title, x_label, y_label;
  std::vector<PlotCurve> curves;
  std::string description;  ///< a sentence or a formula for y, may be empty; reports print it
  std::string file;         ///< relative path for those who store it
};

/// Gives each name a style of its own, the same in all plots.
void number_styles(std::vector<LogPlot>& plots);

/// A plot with logarithmic axes as SVG. A note says how many points are left out because they are
/// not finite or not above 0. Colours are those of Okabe and Ito (2008), which colour-blind people
/// can distinguish; with more curves than colours dashes and marks differ as well.
std::string to_svg(const LogPlot& plot);

/// Sections of HTML: the plots over seconds, and the others. Without plots it is empty.
std::string to_html(const std::vector<LogPlot>& plots);

}  // namespace ajar
