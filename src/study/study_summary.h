#pragma once
#include <optional>
#include <span>
#include <vector>

#include "study/study_runner.h"

/// Statistics over the runs of a study.
namespace ajar::study {

/// Mean over seeds.
struct Mean {
  std::size_t count = 0;
  double mean = 0;
  double deviation = 0;  ///< standard deviation of one run (Bessel's correction); 0 for one run
  double standard_error = 0;  ///< standard error of the mean; 0 for one run
};
Mean mean_of(std::span<const double> values);

/// A ratio with its 95 % confidence interval; without one if a side has a single run.
struct Ratio {
  double value = 1;
  std::optional<double> low;
  std::optional<double> high;
};
/// Efficiency of `runs` relative to `baseline`. Both hold error · seconds of each run, an estimate
/// of variance · time (so 1/mean is the efficiency): the ratio is mean(baseline) / mean(runs). Its
/// logarithm is taken as normal with the variance Σ s²/(n·mean²) of both sides (delta method), and
/// Student's t with Welch and Satterthwaite's degrees of freedom. Source: Welch 1947; L'Ecuyer 1994
/// for the efficiency.
Ratio efficiency_ratio(std::span<const double> runs, std::span<const double> baseline);

/// All seeds of a scene, method and budget.
struct SummaryRow {
  std::size_t scene = 0;
  std::size_t method = 0;
  std::size_t budget = 0;
  Mean seconds;                      ///< preparing and rendering
  Mean cpu_seconds;                  ///< rendering time of all threads
  std::size_t disturbed = 0;         ///< runs that had too little of the processors
  Mean samples;                      ///< per pixel, as `--spp` counts them
  std::optional<double> acceptance;  ///< acceptance of all mutations; mean over seeds, as the next
                                     ///< two
  std::optional<double> small_acceptance;
  std::optional<double> large_acceptance;
  std::vector<Mean> metrics;  ///< in the plan's order; count 0 where there is no value
  /// Runs that know their error.
  Mean estimated_error;
  Mean estimate_ratio;              ///< over the true one: means of ratios, of bounds none
  std::size_t lower_bounds = 0;     ///< runs that say that theirs is one, or unknown
  std::optional<Ratio> efficiency;  ///< against the baseline with the same scene and budget
};

/// Rows in the order of scenes, budgets, methods; without those that have no run.
std::vector<SummaryRow> summarise(const StudyPlan& plan, const StudyResult& result);

}  // namespace ajar::study
