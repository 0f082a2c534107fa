#pragma once
#include <string>
#include <vector>

namespace ajar::study {

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
};
struct LogPlot {
  std::string title, x_label, y_label;
  std::vector<PlotCurve> curves;
};

/// A plot with logarithmic axes as SVG; points that are not above 0 are left out. Colours are those
/// of Okabe and Ito (2008), which colour-blind people can distinguish; with more curves than
/// colours the marks differ as well.
std::string to_svg(const LogPlot& plot);

}  // namespace ajar::study
