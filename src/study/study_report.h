#pragma once
#include "study/report/report.h"
#include "study/study_summary.h"

namespace ajar::study {

/// Report of a study on one scene, with `rows` of all scenes (`summarise`): tables per budget,
/// curves of errors, and the pictures of the last budget with the plan's first seed, beside the
/// reference. Pictures that can no longer be read are named in a note.
Report scene_report(const StudyPlan& plan, const StudyResult& result,
                    const std::vector<SummaryRow>& rows, std::size_t scene);

}  // namespace ajar::study
