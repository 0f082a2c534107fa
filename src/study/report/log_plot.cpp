#include "study/report/log_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/printable_text.h"

namespace ajar {

namespace {
constexpr std::array<const char*, 6> kColors = {"#0072b2", "#d55e00", "#009e73",
                                                "#cc79a7", "#e69f00", "#56b4e9"};
/// Dashes and marks, one pair for each round of the colours.
constexpr std::array<std::array<const char*, 2>, 4> kRounds = {
    {{"none", "m-3 0a3 3 0 1 0 6 0a3 3 0 1 0-6 0"},
     {"7 4", "m-3-3h6v6h-6z"},
     {"2 3", "m0-4.5l4.5 4.5-4.5 4.5-4.5-4.5z"},
     {"9 3 2 3", "m0-4l4 7h-8z"}}};
constexpr double kLeft = 76;
constexpr double kTop = 32;
constexpr double kRight = 520;
constexpr double kBottom = 370;
constexpr double kLineHeight = 16;
/// More points than these have no marks.
constexpr std::size_t kMostMarks = 40;

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

/// 0.002, 20000, 2·10⁻⁵.
std::string tick_text(double value) {
  constexpr std::array<const char*, 10> kRaised = {"⁰", "¹", "²", "³", "⁴",
                                                   "⁵", "⁶", "⁷", "⁸", "⁹"};
  const int power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  if (power >= -3 && power <= 4) return fmt::format("{:g}", value);
  const std::string factor = fmt::format("{:.4g}·", value / std::pow(10.0, power));
  std::string text = (factor == "1·" ? "10" : factor + "10") + (power < 0 ? "⁻" : "");
  for (const char digit : std::to_string(std::abs(power))) text += kRaised[digit - '0'];
  return text;
}

/// Text for HTML and XML; control characters are none of XML's.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : printable_line(text)) {
    result += c == '&'   ? "&amp;"
              : c == '<' ? "&lt;"
              : c == '>' ? "&gt;"
              : c == '"' ? "&quot;"
                         : std::string(1, c);
  }
  return result;
}

/// `attributes`: any more than the class, the place and the side at it.
std::string text_at(double x, double y, const char* name, const char* anchor,
                    const std::string& text, const std::string& attributes = "") {
  return fmt::format(
      "<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", name, x, y,
      anchor, attributes, escaped(text));
}

std::string path(const char* name, const std::string& d, const std::string& attributes) {
  return fmt::format("<path class=\"{}\" d=\"{}\" {}/>\n", name, d, attributes);
}

/// Lines as part of a path: M1.0 2.0L3.0 4.0.
class Line {
 public:
  void add(double x, double y) {
    d_ += fmt::format("{}{:.1f} {:.1f}", d_.empty() ? 'M' : 'L', x, y);
  }
  const std::string& d() const { return d_; }

 private:
  std::string d_;
};

class Drawing {
 public:
  explicit Drawing(const LogPlot& plot) : plot_(plot), ends_(plot.curves.size(), kBottom) {
    double lowest = HUGE_VAL;
    for (PlotCurve& curve : plot_.curves) {
      left_out_ += std::erase_if(curve.points, [](const PlotPoint& p) {
        return !(p.x > 0 && p.y > 0 && std::isfinite(p.x) && std::isfinite(p.y));
      });
      std::sort(curve.points.begin(), curve.points.end(),
                [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
      for (PlotPoint& p : curve.points) {
        p.low = std::isfinite(p.low) ? std::min(p.low, p.y) : p.y;
        p.high = std::isfinite(p.high) ? std::max(p.high, p.y) : p.y;
        x_.include(p.x);
        y_.include(p.y);
        y_.include(p.high);
        lowest = std::min(lowest, p.y);
      }
    }
    // A bar that reaches almost to zero is cut, a decade under the lowest point.
    for (const PlotCurve& curve : plot_.curves) {
      for (const PlotPoint& p : curve.points) {
        if (p.low > 0) y_.include(std::max(p.low, lowest / 10.0));
      }
    }
    x_.widen(2.0);
    // Differences of a few per cent between methods are shown, but not noise of less.
    y_.widen(1.1);
    place_names();
  }

  std::string svg() const {
    std::size_t longest = 20;
    for (const PlotCurve& curve : plot_.curves) longest = std::max(longest, curve.name.size());
    const double width =
        kRight + 60 + 7.5 * static_cast<double>(std::min<std::size_t>(longest, 48));
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" aria-label=\"{2}\" "
        "font-family=\"sans-serif\" font-size=\"13\">\n"
        "<rect class=\"background\" width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        width, std::max(kBottom + (left_out_ > 0 ? 72 : 52), last_name_ + kLineHeight),
        escaped(plot_.y_label + " over " + plot_.x_label + ", both logarithmic"));
    text += frame();
    // Behind all curves, so that none is dimmed.
    for (const PlotCurve& curve : plot_.curves) text += spread(curve);
    for (std::size_t i = 0; i < ends_.size(); ++i) text += means(plot_.curves[i], ends_[i]);
    return text + "</svg>\n";
  }

 private:
  double at_x(double value) const { return kLeft + (kRight - kLeft) * x_.position(value); }
  double at_y(double value) const { return kBottom - (kBottom - kTop) * y_.position(value); }

  /// Names stand at the ends of their curves, moved apart where they would overlap.
  void place_names() {
    std::vector<double*> order;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const std::vector<PlotPoint>& points = plot_.curves[i].points;
      if (!points.empty()) ends_[i] = at_y(points.back().y);
      order.push_back(&ends_[i]);
    }
    std::stable_sort(order.begin(), order.end(), [](double* a, double* b) { return *a < *b; });
    double above = kTop - kLineHeight;
    for (double* y : order) above = *y = std::max(*y, above + kLineHeight);
    last_name_ = std::max(kBottom, kTop + kLineHeight * static_cast<double>(order.size()));
    double below = last_name_ + kLineHeight;
    for (auto y = order.rbegin(); y != order.rend(); ++y)
      below = ** y = std::min(**y, below - kLineHeight);
  }

  std::string frame() const {
    constexpr double kMiddle = (kLeft + kRight) / 2;
    std::string grid;
    std::string text = text_at(kMiddle, kTop - 12, "title", "middle", plot_.title);
    for (const double value : x_.ticks()) {
      grid += fmt::format("M{:.1f} {}V{}", at_x(value), kTop, kBottom);
      text += text_at(at_x(value), kBottom + 18, "tick", "middle", tick_text(value));
    }
    for (const double value : y_.ticks()) {
      grid += fmt::format("M{} {:.1f}H{}", kLeft, at_y(value), kRight);
      text += text_at(kLeft - 8, at_y(value) + 4, "tick", "end", tick_text(value));
    }
    text += text_at(kMiddle, kBottom + 42, "axis-title", "middle", plot_.x_label);
    constexpr double kAcross = (kTop + kBottom) / 2;
    text += text_at(16, kAcross, "axis-title", "middle", plot_.y_label,
                    fmt::format(" transform=\"rotate(-90 16 {})\"", kAcross));
    if (left_out_ > 0) {
      text += text_at(
          kLeft, kBottom + 62, "note", "start",
          fmt::format("{} not drawn: zero, negative or not finite",
                      left_out_ == 1 ? "1 point is" : fmt::format("{} points are", left_out_)));
    }
    return path("grid", grid, R"(stroke="#dddddd")") +
           path("axis", fmt::format("M{} {}V{}H{}", kLeft, kTop, kBottom, kRight),
                R"(fill="none" stroke="#666666")") +
           text;
  }

  /// A curve's group, in the colour of its style.
  static std::string group(const char* name, std::size_t style, const std::string& content) {
    const std::size_t color = style % kColors.size();
    return fmt::format("<g class=\"{0} series-{1}\" fill=\"{2}\" stroke=\"{2}\">\n{3}</g>\n", name,
                       color, kColors[color], content);
  }

  std::string spread(const PlotCurve& curve) const {
    Line band;
    std::string bars;
    for (const PlotPoint& p : curve.points) {
      band.add(at_x(p.x), at_y(p.high));
      bars += fmt::format("M{:.1f} {:.1f}V{:.1f}", at_x(p.x), at_y(p.low), at_y(p.high));
    }
    for (auto p = curve.points.rbegin(); p != curve.points.rend(); ++p)
      band.add(at_x(p->x), at_y(p->low));
    return group("spread", curve.style,
                 path("band", band.d(), R"(stroke="none" opacity="0.15")") +
                     path("bars", bars, R"(opacity="0.6")"));
  }

  std::string means(const PlotCurve& curve, double end) const {
    const auto [dashes, mark] = kRounds[curve.style / kColors.size() % kRounds.size()];
    const std::string stroke = fmt::format(
        R"(fill="none" stroke-width="2" stroke-linejoin="round" stroke-dasharray="{}")", dashes);
    Line line;
    std::string marks;
    for (const PlotPoint& p : curve.points) {
      line.add(at_x(p.x), at_y(p.y));
      marks += path("mark", fmt::format("M{:.1f} {:.1f}{}", at_x(p.x), at_y(p.y), mark),
                    fmt::format(R"(stroke="none" data-point="{:.6g} {:.6g} {:.6g} {:.6g}")", p.x,
                                p.y, p.low, p.high));
    }
    std::string text = path("curve", line.d(), stroke);
    if (!curve.points.empty()) {
      const PlotPoint& last = curve.points.back();
      text += path(
          "leader",
          fmt::format("M{:.1f} {:.1f}L{} {:.1f}", at_x(last.x) + 5, at_y(last.y), kRight + 12, end),
          R"(opacity="0.5")");
    }
    text += fmt::format("<g{}>\n{}</g>\n",
                        curve.points.size() > kMostMarks ? R"( visibility="hidden")" : "", marks);
    text += fmt::format("<g transform=\"translate({} {:.1f})\"><g class=\"key\">\n{}{}</g></g>\n",
                        kRight + 16, end, path("curve", "M0 0H28", stroke),
                        path("mark", fmt::format("M14 0{}", mark), R"(stroke="none")"));
    text += text_at(kRight + 50, end + 4, "name", "start", curve.name,
                    R"( fill="black" stroke="none")");
    return group("series", curve.style, text);
  }

  LogPlot plot_;
  Axis x_, y_;
  std::vector<double> ends_;  ///< heights of the names
  double last_name_ = 0;
  std::size_t left_out_ = 0;
};

std::string section(const std::string& title, const std::string& figures) {
  if (figures.empty()) return "";
  return fmt::format("<section><h2>{}</h2><div class=\"charts\">\n{}</div></section>\n", title,
                     figures);
}
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

std::string to_html(const std::vector<LogPlot>& plots) {
  std::string over_time;
  std::string sweeps;
  for (const LogPlot& plot : plots) {
    (plot.x_label == "seconds" ? over_time : sweeps) += fmt::format(
        "<figure class=\"chart\"><figcaption><strong>{}</strong> {}</figcaption>\n{}</figure>\n",
        escaped(plot.y_label), escaped(plot.description), to_svg(plot));
  }
  return section("Convergence", over_time) + section("Sweeps", sweeps);
}

}  // namespace ajar
