#include "study/study_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

namespace ajar::study {

namespace {
std::optional<double> number(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end ? std::optional(value) : std::nullopt;
}

std::set<std::string> swept_parameters(const StudyPlan& plan) {
  std::set<std::string> names;
  for (const Method& method : plan.methods) {
    for (const auto& [name, value] : method.swept) names.insert(name);
  }
  return names;
}

/// The value of `parameter` that a row is of; empty if it is of no sweep over numbers.
std::optional<double> value_of(const StudyPlan& plan, const SummaryRow& row,
                               const std::string& parameter) {
  const auto& swept = plan.methods[row.method].swept;
  const auto found = swept.find(parameter);
  return found == swept.end() ? std::nullopt : number(found->second);
}

/// Key of the rows of a curve: everything but the value on the axis.
std::string curve_name(const StudyPlan& plan, const SummaryRow& row, const std::string& parameter) {
  const Method& method = plan.methods[row.method];
  std::string name = method.family;
  for (const auto& [other, value] : method.swept) {
    if (other != parameter) name.append(" ").append(other).append("=").append(value);
  }
  return name;
}

bool is_in_time_curves(const StudyPlan& plan, const Method& method) {
  const auto budgets =
      std::count_if(plan.budgets.begin(), plan.budgets.end(),
                    [&](const RunBudget& budget) { return method.is_for(budget); });
  return method.swept.empty() || budgets > 1;
}

PlotPoint point(double x, const Mean& value) {
  return {x, value.mean, value.mean - value.deviation, value.mean + value.deviation};
}

/// The plots of one scene and metric.
class Plots {
 public:
  Plots(const StudyPlan& plan, const std::vector<SummaryRow>& rows, std::size_t scene,
        std::size_t metric)
      : plan_(plan), scene_(scene), metric_(metric) {
    for (const SummaryRow& row : rows) {
      if (row.scene == scene && row.metrics[metric].count > 0) rows_.push_back(&row);
    }
  }

  LogPlot over_time() const {
    LogPlot plot = empty("curves/", "", "seconds");
    for (std::size_t method = 0; method < plan_.methods.size(); ++method) {
      if (!is_in_time_curves(plan_, plan_.methods[method])) continue;
      PlotCurve curve{plan_.methods[method].name, {}};
      for (const SummaryRow* row : rows_) {
        if (row->method == method)
          curve.points.push_back(point(row->seconds.mean, row->metrics[metric_]));
      }
      if (!curve.points.empty()) plot.curves.push_back(std::move(curve));
    }
    return plot;
  }

  /// Without curves if fewer than two values have results.
  LogPlot over(const std::string& parameter) const {
    LogPlot plot = empty("sweeps/", parameter + "-", parameter);
    std::set<std::size_t> budgets;
    std::set<double> values;
    for (const SummaryRow* row : rows_) {
      const std::optional<double> value = value_of(plan_, *row, parameter);
      if (!value) continue;
      budgets.insert(row->budget);
      values.insert(*value);
    }
    if (values.size() < 2) return plot;
    if (budgets.size() == 1) plot.title += ", " + plan_.budgets[*budgets.begin()].name();
    const auto full_name = [&](const std::string& name, const SummaryRow& row) {
      return budgets.size() == 1 ? name : name + ", " + plan_.budgets[row.budget].name();
    };
    std::map<std::string, std::vector<PlotPoint>> curves;
    for (const SummaryRow* row : rows_) {
      const std::optional<double> value = value_of(plan_, *row, parameter);
      if (!value) continue;
      curves[full_name(curve_name(plan_, *row, parameter), *row)].push_back(
          point(*value, row->metrics[metric_]));
    }
    for (auto& [name, points] : curves) plot.curves.push_back({name, std::move(points)});
    for (const SummaryRow* row : rows_) {
      if (plan_.methods[row->method].name != plan_.baseline || !budgets.contains(row->budget))
        continue;
      const Mean& level = row->metrics[metric_];
      plot.curves.push_back({full_name(plan_.baseline, *row),
                             {point(*values.begin(), level), point(*values.rbegin(), level)}});
    }
    return plot;
  }

 private:
  LogPlot empty(const std::string& folder, const std::string& infix,
                const std::string& x_label) const {
    const Metric& metric = *plan_.metrics[metric_];
    const std::string& scene = plan_.scenes[scene_].name;
    return {scene,
            x_label,
            metric.name + (metric.unit.empty() ? "" : " [" + metric.unit + "]"),
            {},
            metric.summary + ".",
            folder + file_name(scene) + "-" + infix + metric.name + ".svg"};
  }

  const StudyPlan& plan_;
  std::size_t scene_, metric_;
  std::vector<const SummaryRow*> rows_;
};
}  // namespace

std::vector<LogPlot> scene_plots(const StudyPlan& plan, const std::vector<SummaryRow>& rows,
                                 std::size_t scene) {
  std::vector<LogPlot> plots;
  for (std::size_t metric = 0; metric < plan.metrics.size(); ++metric) {
    // The axes are logarithmic: for errors, not for decibels.
    if (plan.metrics[metric]->larger_is_better) continue;
    plots.push_back(Plots(plan, rows, scene, metric).over_time());
  }
  for (const std::string& parameter : swept_parameters(plan)) {
    for (std::size_t metric = 0; metric < plan.metrics.size(); ++metric) {
      plots.push_back(Plots(plan, rows, scene, metric).over(parameter));
    }
  }
  std::erase_if(plots, [](const LogPlot& plot) { return plot.curves.empty(); });
  number_styles(plots);
  return plots;
}

}  // namespace ajar::study
