#include "study/report/log_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/printable_text.h"

namespace ajar {

namespace {
constexpr std::array<const char*, 7> kColors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                "#e69f00", "#56b4e9", "#000000"};
constexpr double kLeft = 80;
constexpr double kTop = 40;
constexpr double kWidth = 480;
constexpr double kHeight = 360;
constexpr double kLegendWidth = 240;
constexpr double kBelow = 60;
constexpr double kLineHeight = 20;

/// A logarithmic axis; positions are 0…1 along it.
class Axis {
 public:
  void include(double value) {
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  /// Some air at both ends; at least a factor of `least` in all.
  void widen(double least) {
    if (!(low_ <= high_)) low_ = high_ = 1.0;
    const double range = high_ / low_;
    const double air = std::max(std::pow(range, 0.06), std::sqrt(least / range));
    low_ /= air;
    high_ *= air;
  }
  double position(double value) const {
    return std::log(std::max(value, low_) / low_) / std::log(high_ / low_);
  }
  /// Powers of ten, with 2 and 5 between them if there are few; equal steps if even those are few.
  std::vector<double> ticks() const {
    if (high_ / low_ < 5.0) return even_ticks();
    const bool few = std::log10(high_ / low_) < 3.0;
    const int last = static_cast<int>(std::floor(std::log10(high_)));
    std::vector<double> values;
    for (int power = static_cast<int>(std::floor(std::log10(low_))); power <= last; ++power) {
      for (const double step : {1.0, 2.0, 5.0}) {
        const double value = step * std::pow(10.0, power);
        if ((step == 1.0 || few) && value >= low_ && value <= high_) values.push_back(value);
      }
    }
    return values;
  }

 private:
  /// Four to ten multiples of 1, 2 or 5 times a power of ten.
  std::vector<double> even_ticks() const {
    const double rough = (high_ - low_) / 4.0;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double step = (rough / power >= 5.0 ? 5.0 : rough / power >= 2.0 ? 2.0 : 1.0) * power;
    std::vector<double> values;
    double multiple = std::ceil(low_ / step);
    while (multiple * step <= high_) values.push_back(multiple++ * step);
    return values;
  }

  double low_ = HUGE_VAL;
  double high_ = 0.0;
};

std::string escaped(const std::string& text) {
  std::string result;
  // Control characters are none of XML's.
  for (const char c : printable_line(text)) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     escaped(text));
}

std::string line(double x0, double y0, double x1, double y1, const char* color) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x0, y0, x1,
      y1, color);
}

/// The first round of colours has circles, the second squares.
std::string mark(double x, double y, std::size_t style) {
  const char* color = kColors[style % kColors.size()];
  if (style / kColors.size() % 2 == 0) {
    return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"/>\n", x, y,
                       color);
  }
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"7\" height=\"7\" fill=\"{}\"/>\n",
                     x - 3.5, y - 3.5, color);
}

class Drawing {
 public:
  explicit Drawing(const LogPlot& plot) : plot_(plot) {
    for (PlotCurve& curve : plot_.curves) {
      std::erase_if(curve.points, [](const PlotPoint& p) { return !(p.x > 0) || !(p.y > 0); });
      std::sort(curve.points.begin(), curve.points.end(),
                [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
      for (const PlotPoint& point : curve.points) {
        x_.include(point.x);
        for (const double y : {point.y, point.high, point.low}) {
          if (y > 0) y_.include(y);
        }
      }
    }
    x_.widen(2.0);
    // Differences of a few per cent between methods are shown, but not noise of less.
    y_.widen(1.1);
  }

  std::string svg() const {
    const double height = std::max(
        kTop + kHeight + kBelow, kTop + kLineHeight * static_cast<double>(plot_.curves.size() + 1));
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 "
        "0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" "
        "height=\"100%\" fill=\"white\"/>\n",
        kLeft + kWidth + kLegendWidth, height);
    text += frame();
    for (std::size_t i = 0; i < plot_.curves.size(); ++i) text += curve(i);
    return text + "</svg>\n";
  }

 private:
  double at_x(double value) const { return kLeft + kWidth * x_.position(value); }
  double at_y(double value) const { return kTop + kHeight * (1.0 - y_.position(value)); }

  std::string frame() const {
    const double bottom = kTop + kHeight;
    std::string text = text_at(kLeft + kWidth / 2, kTop - 16, "middle", plot_.title);
    for (const double value : x_.ticks()) {
      text += line(at_x(value), kTop, at_x(value), bottom, "#dddddd");
      text += text_at(at_x(value), bottom + 18, "middle", fmt::format("{:g}", value));
    }
    for (const double value : y_.ticks()) {
      text += line(kLeft, at_y(value), kLeft + kWidth, at_y(value), "#dddddd");
      text += text_at(kLeft - 6, at_y(value) + 4, "end", fmt::format("{:g}", value));
    }
    text += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"black\"/>\n",
        kLeft, kTop, kWidth, kHeight);
    text += text_at(kLeft + kWidth / 2, bottom + 42, "middle", plot_.x_label);
    return text + fmt::format(
                      "<text transform=\"translate(18 {:.1f}) rotate(-90)\" "
                      "text-anchor=\"middle\">{}</text>\n",
                      kTop + kHeight / 2, escaped(plot_.y_label));
  }

  std::string curve(std::size_t i) const {
    const std::size_t style = plot_.curves[i].style;
    const char* color = kColors[style % kColors.size()];
    std::string path;
    std::string text;
    for (const PlotPoint& p : plot_.curves[i].points) {
      path += fmt::format("{:.1f},{:.1f} ", at_x(p.x), at_y(p.y));
      text += line(at_x(p.x), at_y(p.low), at_x(p.x), at_y(p.high), color);
      text += mark(at_x(p.x), at_y(p.y), style);
    }
    text += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\"/>\n", path, color);
    const double y = kTop + kLineHeight * (static_cast<double>(i) + 0.5);
    text += line(kLeft + kWidth + 10, y, kLeft + kWidth + 34, y, color);
    text += mark(kLeft + kWidth + 22, y, style);
    return text + text_at(kLeft + kWidth + 40, y + 4, "start", plot_.curves[i].name);
  }

  LogPlot plot_;
  Axis x_, y_;
};
}  // namespace

void number_styles(std::vector<LogPlot>& plots) {
  std::map<std::string, std::size_t> styles;
  for (LogPlot& plot : plots) {
    for (PlotCurve& curve : plot.curves) {
      curve.style = styles.try_emplace(curve.name, styles.size()).first->second;
    }
  }
}

std::string to_svg(const LogPlot& plot) { return Drawing(plot).svg(); }

}  // namespace ajar
