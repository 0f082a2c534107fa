#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "study/study_summary.h"

namespace ajar::study {

/// The tables of a study as text with a heading per scene and budget.
std::string to_markdown(const StudyPlan& plan, const StudyResult& result,
                        const std::vector<SummaryRow>& rows);
/// A line per row, with a line of column names.
std::string to_csv(const StudyPlan& plan, const std::vector<SummaryRow>& rows);
/// Everything: plan, machine, rows, runs.
nlohmann::ordered_json to_json(const StudyPlan& plan, const StudyResult& result,
                               const std::vector<SummaryRow>& rows);

/// Writes `study.md`, `study.csv`, `study.json`, `curves.csv`, a plot per scene and error,
/// `curves/SCENE-METRIC.svg`, one per sweep, `sweeps/SCENE-PARAMETER-METRIC.svg`, and a report per
/// scene, `report/SCENE/index.html`. Returns the paths of the first three and of the reports.
/// Raises IoError.
std::vector<std::string> write_study(const StudyPlan& plan, const StudyResult& result,
                                     const std::filesystem::path& out);

}  // namespace ajar::study
