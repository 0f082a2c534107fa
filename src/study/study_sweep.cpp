#include "study/study_sweep.h"

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

/// The rows that have a value of the metric in one scene.
std::vector<const SummaryRow*> rows_with(const std::vector<SummaryRow>& rows, std::size_t scene,
                                         std::size_t metric) {
  std::vector<const SummaryRow*> found;
  for (const SummaryRow& row : rows) {
    if (row.scene == scene && row.metrics[metric].count > 0) found.push_back(&row);
  }
  return found;
}

SweepPlot plot_of(const StudyPlan& plan, const std::vector<const SummaryRow*>& rows,
                  SweepPlot plot) {
  std::set<std::size_t> budgets;
  std::set<double> values;
  for (const SummaryRow* row : rows) {
    const std::optional<double> value = value_of(plan, *row, plot.parameter);
    if (!value) continue;
    budgets.insert(row->budget);
    values.insert(*value);
  }
  if (values.size() < 2) return plot;
  if (budgets.size() == 1) plot.budget = plan.budgets[*budgets.begin()].name();
  const auto full_name = [&](const std::string& name, const SummaryRow& row) {
    return budgets.size() == 1 ? name : name + ", " + plan.budgets[row.budget].name();
  };
  std::map<std::string, std::vector<SweepPoint>> curves;
  for (const SummaryRow* row : rows) {
    const std::optional<double> value = value_of(plan, *row, plot.parameter);
    if (!value) continue;
    curves[full_name(curve_name(plan, *row, plot.parameter), *row)].push_back(
        {*value, row->metrics[plot.metric]});
  }
  for (auto& [name, points] : curves) {
    std::sort(points.begin(), points.end(),
              [](const SweepPoint& a, const SweepPoint& b) { return a.value < b.value; });
    plot.curves.push_back({name, std::move(points)});
  }
  for (const SummaryRow* row : rows) {
    if (plan.methods[row->method].name != plan.baseline || !budgets.contains(row->budget)) continue;
    const Mean& level = row->metrics[plot.metric];
    plot.curves.push_back(
        {full_name(plan.baseline, *row), {{*values.begin(), level}, {*values.rbegin(), level}}});
  }
  return plot;
}
}  // namespace

std::vector<SweepPlot> sweep_plots(const StudyPlan& plan, const std::vector<SummaryRow>& rows) {
  std::vector<SweepPlot> plots;
  for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
    for (const std::string& parameter : swept_parameters(plan)) {
      for (std::size_t metric = 0; metric < plan.metrics.size(); ++metric) {
        SweepPlot plot =
            plot_of(plan, rows_with(rows, scene, metric), {scene, parameter, "", metric, {}});
        if (!plot.curves.empty()) plots.push_back(std::move(plot));
      }
    }
  }
  return plots;
}

bool is_in_time_curves(const StudyPlan& plan, const Method& method) {
  const auto budgets =
      std::count_if(plan.budgets.begin(), plan.budgets.end(),
                    [&](const RunBudget& budget) { return method.is_for(budget); });
  return method.swept.empty() || budgets > 1;
}

}  // namespace ajar::study
