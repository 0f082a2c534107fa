#include "study/study_report.h"

#include <fmt/format.h>

#include "core/error.h"
#include "study/report_image.h"
#include "study/study_plots.h"
#include "study/study_table.h"

namespace ajar::study {

namespace {
/// Adds the picture and returns whether it is there.
bool add_image(Report& report, const std::string& name, const std::string& path) {
  try {
    report.images.push_back(report_image(name, load_picture(path)));
    return true;
  } catch (const IoError& error) {
    report.notes.push_back(fmt::format("{} is not shown: {}", name, error.what()));
    return false;
  }
}

/// One seed of one budget, so that the pictures can be compared with each other.
void add_pictures(Report& report, const StudyPlan& plan, const StudyResult& result,
                  std::size_t scene) {
  for (const FinishedRun& finished : result.runs) {
    const StudyRun& run = finished.run;
    if (run.scene != scene || run.budget + 1 != plan.budgets.size() ||
        run.seed != plan.seeds.front()) {
      continue;
    }
    const std::string& method = plan.methods[run.method].name;
    if (!add_image(report, method, run.stem.string() + ".exr")) continue;
    for (const Metric* metric : plan.metrics) {
      const std::optional<double> value = finished.record.metric(metric->name);
      if (value) report.images.back().metrics[metric->name] = *value;
    }
  }
}

void add_tables(Report& report, const StudyPlan& plan, const StudyResult& result,
                const std::vector<SummaryRow>& rows, std::size_t scene) {
  for (std::size_t budget = 0; budget < plan.budgets.size(); ++budget) {
    const RunBudget& given = plan.budgets[budget];
    ReportTable table{(given.seconds ? "Equal time: " : "Equal samples: ") + given.name(),
                      table_header(plan),
                      {}};
    for (const SummaryRow& row : rows) {
      if (row.scene != scene || row.budget != budget) continue;
      table.rows.push_back(table_cells(plan, result, row));
    }
    if (!table.rows.empty()) report.tables.push_back(std::move(table));
  }
}

/// Emphasis in Markdown is nothing to a report.
std::string plain(const std::string& markdown) {
  std::string text;
  for (std::size_t i = 0; i < markdown.size(); ++i) {
    const bool is_escape = markdown[i] == '\\' && i + 1 < markdown.size();
    if (is_escape) ++i;
    if (is_escape || markdown[i] != '*') text += markdown[i];
  }
  return text;
}
}  // namespace

Report scene_report(const StudyPlan& plan, const StudyResult& result,
                    const std::vector<SummaryRow>& rows, std::size_t scene) {
  Report report;
  report.title = plan.name + ": " + plan.scenes[scene].name;
  report.metrics = report_metrics(plan.metrics);
  const std::string& reference = result.references[scene];
  if (!reference.empty() && add_image(report, "reference", reference)) report.reference = 0;
  add_pictures(report, plan, result, scene);
  add_tables(report, plan, result, rows, scene);
  report.plots = scene_plots(plan, rows, scene);
  report.notes.push_back(fmt::format("{} of {} renders of the study are finished.",
                                     result.runs.size(), result.planned));
  report.notes.push_back(fmt::format(
      "Pictures, and the metrics of each, are those of {} with seed {}; tables and curves are of "
      "all seeds, bands one standard deviation of a run to either side.",
      plan.budgets.back().name(), plan.seeds.front()));
  report.notes.push_back(plain(table_explanation(plan)));
  for (const std::string& left : plan.left_out) report.notes.push_back("Warning: " + left);
  for (const std::string& warning : result.warnings) report.notes.push_back("Warning: " + warning);
  for (const std::string& failure : result.failures) report.notes.push_back("Failed: " + failure);
  return report;
}

}  // namespace ajar::study
