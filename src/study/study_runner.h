#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "study/study_run.h"

namespace ajar::study {

/// A run and its result.
struct FinishedRun {  // NOLINT(bugprone-exception-escape): moving JSON throws nothing
  StudyRun run;
  RunRecord record;
};

struct StudyResult {
  std::vector<FinishedRun> runs;        ///< finished runs, references not included
  std::vector<std::string> references;  ///< picture file per scene; empty if there is none
  /// Contribution of the reference's noise to the metric of efficiency, per scene; empty if the
  /// reference does not know its error.
  std::vector<std::optional<double>> noise;
  std::vector<std::string> failures;  ///< one sentence each
  std::vector<std::string> warnings;  ///< one sentence each
  std::size_t planned = 0;            ///< runs of the plan, references not included
  bool interrupted = false;
};

struct StudyOptions {
  std::filesystem::path folder;  ///< folder of the study file: renders run there
  std::filesystem::path out;     ///< absolute
  std::string program;           ///< the `ajar` that renders
  /// A line for people: finished and remaining runs.
  std::function<void(const std::string&)> report;
};

/// Makes the missing runs of a study, one render after the other, each in a process of its own, and
/// measures every picture against its reference. A run that fails is noted and the others go on;
/// after a signal the results so far are returned. Raises Error for errors of the whole study:
/// scenes that cannot be used, references that cannot be read or do not fit, a full disk.
StudyResult run_study(const StudyPlan& plan, const StudyOptions& options);

}  // namespace ajar::study
