#include "study/study_table.h"

#include <fmt/format.h>

#include "study/text_formats.h"

namespace ajar::study {

namespace {
/// Noise of the reference is marked if it is more than this part of an error.
constexpr double kLoudReference = 0.1;

std::string with_error(const Mean& mean) {
  if (mean.count == 0) return "-";
  if (mean.count == 1) return fmt::format("{:.4g}", mean.mean);
  return fmt::format("{:.4g} ± {:.2g}", mean.mean, mean.standard_error);
}

std::string cpu_text(const SummaryRow& row) {
  return with_error(row.cpu_seconds) +
         (row.disturbed > 0 ? fmt::format(" († {}/{})", row.disturbed, row.seconds.count) : "");
}

std::string estimate_text(const SummaryRow& row) {
  std::string text = with_error(row.estimated_error);
  if (row.estimate_ratio.count > 0) text += fmt::format(" ({:.2f}×)", row.estimate_ratio.mean);
  if (row.lower_bounds > 0) text += fmt::format(" (≥ {}/{})", row.lower_bounds, row.seconds.count);
  return text;
}

std::string ratio_text(const std::optional<Ratio>& ratio) {
  if (!ratio) return "-";
  if (!ratio->low) return fmt::format("{:.3g}", ratio->value);
  return fmt::format("{:.3g} [{:.3g}, {:.3g}]", ratio->value, *ratio->low, *ratio->high);
}

std::string acceptance_text(const SummaryRow& row) {
  const auto number = [](std::optional<double> v) { return v ? fmt::format("{:.2f}", *v) : "-"; };
  if (!row.acceptance && !row.small_acceptance && !row.large_acceptance) return "-";
  return fmt::format("{} ({} / {})", number(row.acceptance), number(row.small_acceptance),
                     number(row.large_acceptance));
}

/// True if a large part of a row's error is the reference's.
bool is_loud(const StudyPlan& plan, const StudyResult& result, const SummaryRow& row) {
  const std::optional<double>& noise = result.noise.at(row.scene);
  if (!noise) return false;
  for (std::size_t i = 0; i < plan.metrics.size(); ++i) {
    const bool decides = plan.metrics[i]->name == plan.efficiency_metric;
    if (decides && row.metrics[i].count > 0) return *noise > kLoudReference * row.metrics[i].mean;
  }
  return false;
}
}  // namespace

std::vector<std::string> table_header(const StudyPlan& plan) {
  std::vector<std::string> header{"method",
                                  "runs",
                                  "seconds",
                                  "CPU seconds",
                                  "samples per pixel",
                                  "acceptance (small / large steps)"};
  for (const Metric* metric : plan.metrics) {
    header.push_back(metric->name + (metric->unit.empty() ? "" : " [" + metric->unit + "]"));
  }
  header.insert(header.end(), {"estimated error", "efficiency"});
  return header;
}

std::vector<std::string> table_cells(const StudyPlan& plan, const StudyResult& result,
                                     const SummaryRow& row) {
  std::vector<std::string> cells{
      plan.methods[row.method].name, fmt::format("{}", row.seconds.count),
      with_error(row.seconds),       cpu_text(row),
      with_error(row.samples),       acceptance_text(row)};
  for (const Mean& metric : row.metrics) cells.push_back(with_error(metric));
  cells.push_back(estimate_text(row));
  cells.push_back(ratio_text(row.efficiency) + (is_loud(plan, result, row) ? " *" : ""));
  return cells;
}

std::string table_explanation(const StudyPlan& plan) {
  std::string text =
      "Means over seeds ± their standard error. *seconds*: preparing and rendering, wall clock. "
      "*CPU seconds*: of all threads, rendering; †: of so many runs, less than 75 % of what their "
      "threads could have had, so that their times mislead. "
      "*samples per pixel*: as `--spp` counts them. *acceptance*: of all mutations, and of "
      "small and large steps; a proposal counts with its probability. "
      "*estimated error*: what the renders say of their relative-error; ×: over the true one, mean "
      "of the renders that know it; ≥: so many say that it is at least that.";
  if (!plan.efficiency_metric.empty()) {
    text += fmt::format(
        " *efficiency*: 1/({0} · seconds) relative to {1}, with its 95 % interval (log-normal, "
        "Student's t with Welch's degrees of freedom, over seeds); {0} is variance where the "
        "method "
        "is unbiased and the reference exact. \\*: more than 10 % of the {0} may be noise of the "
        "reference.",
        plan.efficiency_metric, markdown_text(plan.baseline));
  }
  return text;
}

}  // namespace ajar::study
