#include "study/study_output.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "os/atomic_file.h"
#include "session/output/stats_json.h"
#include "study/machine.h"
#include "study/study_plots.h"
#include "study/study_report.h"
#include "study/study_table.h"
#include "study/text_formats.h"

namespace ajar::study {

namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A row of a Markdown table; no cell is read as markup. The first is a name, the others are ours.
std::string markdown_row(const std::vector<std::string>& cells) {
  std::string text = "| " + markdown_text(cells.front()) + " |";
  for (std::size_t i = 1; i < cells.size(); ++i) {
    text += ' ';
    for (const char c : cells[i])
      text += c == '*' || c == '|' ? fmt::format("\\{}", c) : std::string(1, c);
    text += " |";
  }
  return text + "\n";
}

std::string table_head(const StudyPlan& plan) {
  const std::vector<std::string> header = table_header(plan);
  std::string rule = "|";
  for (std::size_t i = 0; i < header.size(); ++i) rule += "---|";
  return markdown_row(header) + rule + "\n";
}

std::string csv_mean(const Mean& mean) {
  if (mean.count == 0) return ",,";
  return fmt::format(",{:.9g},{:.9g}", mean.mean, mean.standard_error);
}

std::string csv_number(std::optional<double> value) {
  return value ? fmt::format(",{:.9g}", *value) : ",";
}

Json mean_json(const Mean& mean) {
  if (mean.count == 0) return {};
  Json json{{"count", mean.count}, {"mean", mean.mean}};
  json["standard_error"] = mean.count > 1 ? Json(mean.standard_error) : Json();
  json["standard_deviation"] = mean.count > 1 ? Json(mean.deviation) : Json();
  return json;
}

Json optional_json(std::optional<double> value) { return value ? Json(*value) : Json(); }

Json row_json(const StudyPlan& plan, const SummaryRow& row) {
  Json metrics = Json::object();
  for (std::size_t i = 0; i < plan.metrics.size(); ++i) {
    metrics[plan.metrics[i]->name] = mean_json(row.metrics[i]);
  }
  Json json{{"scene", plan.scenes[row.scene].name},
            {"method", plan.methods[row.method].name},
            {"budget", plan.budgets[row.budget].name()},
            {"seconds", mean_json(row.seconds)},
            {"cpu_seconds", mean_json(row.cpu_seconds)},
            {"disturbed", row.disturbed},
            {"samples_per_pixel", mean_json(row.samples)},
            {"acceptance",
             {{"all", optional_json(row.acceptance)},
              {"small", optional_json(row.small_acceptance)},
              {"large", optional_json(row.large_acceptance)}}},
            {"metrics", metrics},
            {"estimated_error", mean_json(row.estimated_error)},
            {"estimated_over_true", mean_json(row.estimate_ratio)},
            {"lower_bounds", row.lower_bounds},
            {"efficiency", nullptr}};
  if (row.efficiency) {
    json["efficiency"] = {{"ratio", row.efficiency->value},
                          {"low", optional_json(row.efficiency->low)},
                          {"high", optional_json(row.efficiency->high)}};
  }
  return json;
}

Json run_json(const StudyPlan& plan, const FinishedRun& finished) {
  const StudyRun& run = finished.run;
  const Json& record = finished.record.json;
  return {{"scene", plan.scenes[run.scene].name},
          {"method", plan.methods[run.method].name},
          {"budget", plan.budgets[run.budget].name()},
          {"seed", run.seed},
          {"picture", run.stem.string() + ".exr"},
          {"seconds", finished.record.seconds()},
          {"cpu_seconds", optional_json(finished.record.number("cpu_seconds"))},
          {"cpu_share", optional_json(finished.record.cpu_share())},
          {"disturbed", finished.record.is_disturbed()},
          {"attempt", record.value("attempt", 1)},
          {"metrics", record.value("metrics", Json::object())},
          {"load_average", record.value("load_average", Json())},
          {"machine", record.value("machine", Json())},
          {"statistics", record.at("statistics")}};
}

std::string curves_csv(const StudyPlan& plan, const std::vector<SummaryRow>& rows) {
  std::string text = "scene,method,budget,metric,seconds,mean,standard_deviation,runs\n";
  for (const SummaryRow& row : rows) {
    for (std::size_t i = 0; i < plan.metrics.size(); ++i) {
      const Mean& value = row.metrics[i];
      if (value.count == 0) continue;
      text += fmt::format(
          "{},{},{},{},{:.9g},{:.9g},{:.9g},{}\n", csv_cell(plan.scenes[row.scene].name),
          csv_cell(plan.methods[row.method].name), plan.budgets[row.budget].name(),
          plan.metrics[i]->name, row.seconds.mean, value.mean, value.deviation, value.count);
    }
  }
  return text;
}

void write_text(const fs::path& path, const std::string& text) {
  write_file_atomically(path, text);
}
}  // namespace

std::string to_markdown(const StudyPlan& plan, const StudyResult& result,
                        const std::vector<SummaryRow>& rows) {
  const Json machine = machine_json();
  std::string text =
      fmt::format("# {}\n\n{} of {} renders. {}, {} cores; ajar {}.\n\n{}",
                  markdown_text(plan.name), result.runs.size(), result.planned,
                  machine.at("processor").get<std::string>(), machine.at("cores").get<int>(),
                  machine.at("version").get<std::string>(), table_explanation(plan) + "\n");
  for (const std::string& scene : plan.left_out)
    text += "\nWarning: " + markdown_text(scene) + "\n";
  for (const std::string& warning : result.warnings)
    text += "\nWarning: " + markdown_text(warning) + "\n";
  for (const std::string& failure : result.failures)
    text += "\nFailed: " + markdown_text(failure) + "\n";
  const SummaryRow* previous = nullptr;
  for (const SummaryRow& row : rows) {
    const bool new_scene = previous == nullptr || previous->scene != row.scene;
    if (new_scene) text += "\n## " + markdown_text(plan.scenes[row.scene].name) + "\n";
    if (new_scene || previous->budget != row.budget) {
      text += "\n### " + plan.budgets[row.budget].name() + "\n\n" + table_head(plan);
    }
    text += markdown_row(table_cells(plan, result, row));
    previous = &row;
  }
  return text;
}

std::string to_csv(const StudyPlan& plan, const std::vector<SummaryRow>& rows) {
  std::string text =
      "scene,method,budget,runs,seconds,seconds_error,cpu_seconds,cpu_seconds_error,disturbed,"
      "samples_per_pixel,samples_per_pixel_error,"
      "acceptance,acceptance_small,acceptance_large";
  for (const Metric* metric : plan.metrics) {
    text += fmt::format(",{0},{0}_error", metric->name);
  }
  text += ",estimated_error,estimated_error_error,estimated_over_true,estimated_over_true_error";
  text += ",lower_bounds,efficiency,efficiency_low,efficiency_high\n";
  for (const SummaryRow& row : rows) {
    text += fmt::format("{},{},{},{}", csv_cell(plan.scenes[row.scene].name),
                        csv_cell(plan.methods[row.method].name), plan.budgets[row.budget].name(),
                        row.seconds.count);
    text += csv_mean(row.seconds) + csv_mean(row.cpu_seconds);
    text += fmt::format(",{}", row.disturbed) + csv_mean(row.samples);
    text += csv_number(row.acceptance) + csv_number(row.small_acceptance) +
            csv_number(row.large_acceptance);
    for (const Mean& metric : row.metrics) text += csv_mean(metric);
    text += csv_mean(row.estimated_error) + csv_mean(row.estimate_ratio);
    text += fmt::format(",{}", row.lower_bounds);
    const std::optional<Ratio>& ratio = row.efficiency;
    text += csv_number(ratio ? std::optional(ratio->value) : std::nullopt);
    text += csv_number(ratio ? ratio->low : std::nullopt);
    text += csv_number(ratio ? ratio->high : std::nullopt) + "\n";
  }
  return text;
}

Json to_json(const StudyPlan& plan, const StudyResult& result,
             const std::vector<SummaryRow>& rows) {
  Json scenes = Json::array();
  for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
    scenes.push_back({{"name", plan.scenes[i].name},
                      {"scene", plan.scenes[i].scene},
                      {"options", plan.scenes[i].options},
                      {"reference", result.references[i]},
                      {"reference_noise", optional_json(result.noise[i])}});
  }
  Json methods = Json::array();
  for (const Method& method : plan.methods) {
    methods.push_back({{"name", method.name},
                       {"integrator", method.integrator},
                       {"parameters", method.parameters}});
  }
  Json summary = Json::array();
  for (const SummaryRow& row : rows) summary.push_back(row_json(plan, row));
  Json runs = Json::array();
  for (const FinishedRun& run : result.runs) runs.push_back(run_json(plan, run));
  return {{"name", plan.name},
          {"machine", machine_json()},
          {"scenes", scenes},
          {"left_out", plan.left_out},
          {"methods", methods},
          {"seeds", plan.seeds},
          {"baseline", plan.baseline},
          {"efficiency_metric", plan.efficiency_metric},
          {"planned", result.planned},
          {"interrupted", result.interrupted},
          {"failures", result.failures},
          {"warnings", result.warnings},
          {"summary", summary},
          {"runs", runs}};
}

namespace {
/// Writes the plots; returns the Markdown that shows them.
std::string write_plots(const StudyPlan& plan, const std::vector<SummaryRow>& rows,
                        const fs::path& out) {
  std::string markdown;
  for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
    for (const LogPlot& plot : scene_plots(plan, rows, scene)) {
      fs::create_directories((out / plot.file).parent_path());
      write_text(out / plot.file, to_svg(plot));
      markdown += fmt::format("\n![{} of {} against {}]({})\n", markdown_text(plot.y_label),
                              markdown_text(plot.title), markdown_text(plot.x_label), plot.file);
    }
  }
  return markdown;
}

/// A report per scene, as each has a reference of its own. Returns their pages.
std::vector<std::string> write_reports(const StudyPlan& plan, const StudyResult& result,
                                       const std::vector<SummaryRow>& rows, const fs::path& out) {
  fs::create_directories(out / "report");
  std::vector<std::string> pages;
  for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
    const fs::path folder = out / "report" / file_name(plan.scenes[scene].name);
    write_report(scene_report(plan, result, rows, scene), folder);
    pages.push_back((folder / "index.html").string());
  }
  return pages;
}
}  // namespace

std::vector<std::string> write_study(const StudyPlan& plan, const StudyResult& result,
                                     const fs::path& out) {
  const std::vector<SummaryRow> rows = summarise(plan, result);
  const std::string plots = write_plots(plan, rows, out);
  write_text(out / "study.md", to_markdown(plan, result, rows) + plots);
  write_text(out / "study.csv", to_csv(plan, rows));
  write_text(out / "curves.csv", curves_csv(plan, rows));
  write_json(to_json(plan, result, rows), (out / "study.json").string());
  std::vector<std::string> written{(out / "study.md").string(), (out / "study.csv").string(),
                                   (out / "study.json").string()};
  for (std::string& page : write_reports(plan, result, rows, out)) {
    written.push_back(std::move(page));
  }
  return written;
}

}  // namespace ajar::study
