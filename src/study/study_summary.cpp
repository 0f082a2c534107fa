#include "study/study_summary.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

namespace ajar::study {

namespace {
constexpr double kUpperTail = 0.025;  // tail of a 95 % interval

using Runs = std::vector<const FinishedRun*>;

Runs runs_of(const StudyResult& result, std::size_t scene, std::size_t method, std::size_t budget) {
  Runs found;
  for (const FinishedRun& finished : result.runs) {
    const StudyRun& run = finished.run;
    if (run.scene == scene && run.method == method && run.budget == budget) {
      found.push_back(&finished);
    }
  }
  return found;
}

/// The values that `read` finds in the runs.
template <typename Read>
std::vector<double> values_of(const Runs& runs, Read read) {
  std::vector<double> values;
  for (const FinishedRun* run : runs) {
    if (const std::optional<double> value = read(run->record)) values.push_back(*value);
  }
  return values;
}

std::optional<double> acceptance(const Runs& runs, const char* kind) {
  const std::vector<double> values = values_of(runs, [&](const RunRecord& record) {
    const auto& all = record.json.at("statistics").value("acceptance", nlohmann::ordered_json());
    const bool known = all.is_object() && all.contains(kind) && all.at(kind).is_number();
    return known ? std::optional(all.at(kind).get<double>()) : std::nullopt;
  });
  return values.empty() ? std::nullopt : std::optional(mean_of(values).mean);
}

/// Acceptance of all mutations, of any kind.
std::optional<double> whole_acceptance(const Runs& runs) {
  const std::vector<double> values = values_of(runs, [](const RunRecord& record) {
    const auto& statistics = record.json.at("statistics");
    const auto all = statistics.value("acceptance", nlohmann::ordered_json());
    std::optional<double> share;
    if (!all.is_object() || !all.contains("by_depth")) return share;
    double mutations = 0.0;
    double accepted = 0.0;
    for (const auto& depth : all.at("by_depth")) {
      mutations += depth.at("mutations").get<double>();
      accepted += depth.at("mutations").get<double>() * depth.at("acceptance").get<double>();
    }
    if (mutations > 0.0) share = accepted / mutations;
    return share;
  });
  return values.empty() ? std::nullopt : std::optional(mean_of(values).mean);
}

/// Error · seconds of each run.
std::vector<double> work(const Runs& runs, const std::string& metric) {
  return values_of(runs, [&](const RunRecord& record) -> std::optional<double> {
    const std::optional<double> error = record.metric(metric);
    return error ? std::optional(*error * record.seconds()) : std::nullopt;
  });
}

std::optional<double> estimate_over_truth(const RunRecord& record) {
  const std::optional<double> estimated = record.number("estimated_relative_error");
  const std::optional<double> truth = record.metric(kRelativeErrorMetric);
  if (!record.knows_error() || !estimated || !truth || *truth == 0.0) return std::nullopt;
  return *estimated / *truth;
}

SummaryRow row_of(const StudyPlan& plan, const Runs& runs) {
  const StudyRun& first = runs.front()->run;
  SummaryRow row;
  row.scene = first.scene;
  row.method = first.method;
  row.budget = first.budget;
  row.seconds = mean_of(
      values_of(runs, [](const RunRecord& record) { return std::optional(record.seconds()); }));
  row.cpu_seconds = mean_of(
      values_of(runs, [](const RunRecord& record) { return record.number("cpu_seconds"); }));
  row.disturbed = static_cast<std::size_t>(std::count_if(
      runs.begin(), runs.end(), [](const FinishedRun* run) { return run->record.is_disturbed(); }));
  row.samples = mean_of(
      values_of(runs, [](const RunRecord& record) { return record.number("samples_per_pixel"); }));
  row.acceptance = whole_acceptance(runs);
  row.small_acceptance = acceptance(runs, "small");
  row.large_acceptance = acceptance(runs, "large");
  for (const Metric* metric : plan.metrics) {
    row.metrics.push_back(mean_of(
        values_of(runs, [&](const RunRecord& record) { return record.metric(metric->name); })));
  }
  row.estimated_error =
      mean_of(values_of(runs, [](const RunRecord& record) -> std::optional<double> {
        return record.knows_error() ? record.number("estimated_relative_error") : std::nullopt;
      }));
  row.estimate_ratio = mean_of(values_of(runs, estimate_over_truth));
  row.lower_bounds = static_cast<std::size_t>(std::count_if(
      runs.begin(), runs.end(), [](const FinishedRun* run) { return !run->record.knows_error(); }));
  return row;
}
}  // namespace

Mean mean_of(std::span<const double> values) {
  Mean result;
  result.count = values.size();
  if (values.empty()) return result;
  const auto count = static_cast<double>(values.size());
  result.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  if (values.size() == 1) return result;
  double squares = 0.0;
  for (const double v : values) squares += (v - result.mean) * (v - result.mean);
  result.deviation = std::sqrt(squares / (count - 1));
  result.standard_error = result.deviation / std::sqrt(count);
  return result;
}

Ratio efficiency_ratio(std::span<const double> runs, std::span<const double> baseline) {
  const Mean a = mean_of(runs);
  const Mean b = mean_of(baseline);
  Ratio ratio;
  ratio.value = b.mean / a.mean;
  if (a.count < 2 || b.count < 2 || !(a.mean > 0) || !(b.mean > 0)) return ratio;
  const auto relative_variance = [](const Mean& m) {
    return m.standard_error * m.standard_error / (m.mean * m.mean);
  };
  const double of_a = relative_variance(a);
  const double of_b = relative_variance(b);
  const double variance = of_a + of_b;
  double factor = 1.0;
  if (variance > 0.0) {
    const double freedom = variance * variance /
                           (of_a * of_a / static_cast<double>(a.count - 1) +
                            of_b * of_b / static_cast<double>(b.count - 1));
    const double t = boost::math::quantile(
        boost::math::complement(boost::math::students_t(freedom), kUpperTail));
    factor = std::exp(t * std::sqrt(variance));
  }
  ratio.low = ratio.value / factor;
  ratio.high = ratio.value * factor;
  return ratio;
}

std::vector<SummaryRow> summarise(const StudyPlan& plan, const StudyResult& result) {
  std::vector<SummaryRow> rows;
  const auto baseline = static_cast<std::size_t>(
      std::find_if(plan.methods.begin(), plan.methods.end(),
                   [&](const Method& method) { return method.name == plan.baseline; }) -
      plan.methods.begin());
  for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
    for (std::size_t budget = 0; budget < plan.budgets.size(); ++budget) {
      const std::vector<double> base =
          work(runs_of(result, scene, baseline, budget), plan.efficiency_metric);
      for (std::size_t method = 0; method < plan.methods.size(); ++method) {
        const Runs runs = runs_of(result, scene, method, budget);
        if (runs.empty()) continue;
        SummaryRow row = row_of(plan, runs);
        const std::vector<double> own = work(runs, plan.efficiency_metric);
        // The baseline itself is 1 by definition, without an error.
        if (method == baseline && !base.empty()) row.efficiency = Ratio{};
        if (method != baseline && !own.empty() && !base.empty()) {
          row.efficiency = efficiency_ratio(own, base);
        }
        rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

}  // namespace ajar::study
