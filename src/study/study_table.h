#pragma once
#include <string>
#include <vector>

#include "study/study_summary.h"

/// The table of a study's methods, as texts: for Markdown and for reports.
namespace ajar::study {

std::vector<std::string> table_header(const StudyPlan& plan);
/// Cells, one for each of the header.
std::vector<std::string> table_cells(const StudyPlan& plan, const StudyResult& result,
                                     const SummaryRow& row);
/// Legend of the columns: Markdown, one paragraph.
std::string table_explanation(const StudyPlan& plan);

}  // namespace ajar::study
