#pragma once
#include <vector>

#include "study/report/log_plot.h"
#include "study/study_summary.h"

namespace ajar::study {

/// Plots of a scene, for its report and the files `curves/SCENE-METRIC.svg` and
/// `sweeps/SCENE-PARAMETER-METRIC.svg`.
///
/// Errors are plotted over seconds; a method of a sweep with a single budget is left out there,
/// where it would be a lone point. Every metric is plotted over the values of every parameter that
/// was swept over at least two numbers with results; the last curves are level: the baseline at the
/// same budgets. Bars are one standard deviation of a run to either side.
std::vector<LogPlot> scene_plots(const StudyPlan& plan, const std::vector<SummaryRow>& rows,
                                 std::size_t scene);

}  // namespace ajar::study
