#include "study/comparison_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "core/number_text.h"
#include "study/comparison_output.h"
#include "study/report_image.h"

namespace ajar::study {

namespace {
std::string stem(const std::string& path) { return std::filesystem::path(path).stem().string(); }

/// File names without folder and extension, if these are distinct; else the paths.
std::vector<std::string> short_names(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  for (const std::string& path : paths) {
    const auto same = std::count_if(paths.begin(), paths.end(), [&](const std::string& other) {
      return stem(other) == stem(path);
    });
    names.push_back(same == 1 ? stem(path) : path);
  }
  return names;
}

std::vector<std::string> paths_of(const Comparison& comparison) {
  std::vector<std::string> paths{comparison.reference.path};
  for (const ComparedPicture& compared : comparison.pictures)
    paths.push_back(compared.picture.path);
  return paths;
}

std::vector<std::string> bias_row(const std::string& name, const std::optional<BiasTest>& bias) {
  if (!bias) return {name, "not tested: the file says nothing of its error", "-", "-", "-", "-"};
  const BlockComparison& r = bias->result;
  return {name,
          bias->differs ? "differs by more than noise" : "no bias found",
          fmt::format("{:+.3g} %", 100 * r.mean_relative_difference),
          fmt::format("{:+.2f}", r.mean_z),
          fmt::format("{:.2g}", r.family_p),
          percent_text(bias->detectable_mean)};
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}
}  // namespace

Report to_report(const Comparison& comparison) {
  const std::vector<std::string> names = short_names(paths_of(comparison));
  Report report;
  report.title = "Compared with " + names[0];
  report.images.push_back(report_image(names[0], comparison.reference));
  report.reference = 0;
  report.metrics = report_metrics(comparison.metrics);
  ReportTable bias{
      "Tests for bias",
      {"picture", "verdict", "mean difference", "z", "family p", "detectable mean difference"},
      {}};
  for (std::size_t i = 0; i < comparison.pictures.size(); ++i) {
    const ComparedPicture& compared = comparison.pictures[i];
    ReportImage image = report_image(names[i + 1], compared.picture);
    for (std::size_t m = 0; m < comparison.metrics.size(); ++m) {
      if (compared.values[m]) image.metrics[comparison.metrics[m]->name] = *compared.values[m];
    }
    report.images.push_back(std::move(image));
    bias.rows.push_back(bias_row(names[i + 1], compared.bias));
  }
  report.tables.push_back(std::move(bias));
  report.notes = lines(conditions_text(comparison));
  for (const std::string& warning : comparison.warnings)
    report.notes.push_back("Warning: " + warning);
  return report;
}

}  // namespace ajar::study
