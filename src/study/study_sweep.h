#pragma once
#include <string>
#include <vector>

#include "study/study_summary.h"

/// Metrics against the values of a swept parameter.
namespace ajar::study {

/// The runs of a method with one value of the parameter.
struct SweepPoint {
  double value = 0;
  Mean metric;  ///< over seeds
};
struct SweepCurve {
  std::string name;                ///< name of the method, and other parts that distinguish curves
  std::vector<SweepPoint> points;  ///< points of rising value
};
/// One scene, parameter and metric. The last curves are level: the baseline at the same budgets.
struct SweepPlot {
  std::size_t scene = 0;
  std::string parameter;
  std::string budget;      ///< name; empty if there are several, which curves then name
  std::size_t metric = 0;  ///< index into the plan's
  std::vector<SweepCurve> curves;
};

/// A plot for every scene, metric and parameter that was swept over at least two numbers with
/// results.
std::vector<SweepPlot> sweep_plots(const StudyPlan& plan, const std::vector<SummaryRow>& rows);

/// True if a method belongs into curves over time: one of a sweep with a single budget is a lone
/// point there, and has its plot here.
bool is_in_time_curves(const StudyPlan& plan, const Method& method);

}  // namespace ajar::study
