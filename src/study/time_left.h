#pragma once
#include <optional>
#include <vector>

#include "study/study_run.h"

namespace ajar::study {

/// Seconds that the runs from number `next` on will take, those with a record left out. A run with
/// a time limit takes that long; one with a number of samples as long as finished ones of its scene
/// and method did per sample, else as the mean of all finished runs. Empty as long as nothing is
/// known.
std::optional<double> seconds_left(const StudyPlan& plan, const std::vector<StudyRun>& runs,
                                   const std::vector<std::optional<RunRecord>>& records,
                                   std::size_t next);

}  // namespace ajar::study
