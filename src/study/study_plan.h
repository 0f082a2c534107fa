#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/metric.h"

/// An experiment: every scene with every method, seed and budget (docs/studies.md).
namespace ajar::study {

/// When a render of the study ends; exactly one is given.
struct RunBudget {
  std::optional<double> seconds;
  std::optional<std::uint64_t> samples_per_pixel;
  /// "10s" or "64spp": in tables and file names.
  std::string name() const;
};

/// A rendering method with its parameters; one of a sweep has its own.
struct Method {
  std::string name;  ///< in tables; unique in a study
  std::string integrator;
  std::map<std::string, std::string> parameters;
  std::string family;                        ///< the name without the values of a sweep
  std::map<std::string, std::string> swept;  ///< swept values; empty without a sweep
  std::vector<std::string> budgets;          ///< names of those it is for; empty: all

  bool is_for(const RunBudget& budget) const;
};

/// A reference that the study renders itself.
struct MadeReference {
  Method method;
  std::vector<RunBudget> limits;  ///< one or both kinds; whichever is reached first
  std::uint64_t seed = 0;
};

struct StudyScene {
  std::string name;                  ///< in tables; unique in a study
  std::string scene;                 ///< as `ajar render` takes it; the alternative that exists
  std::vector<std::string> options;  ///< more arguments of `ajar render`, such as --resolution
  /// Exactly one of the two.
  std::string reference_file;
  std::optional<MadeReference> made_reference;
};

struct StudyPlan {
  std::string name;
  std::vector<StudyScene> scenes;
  std::vector<std::string> left_out;  ///< why, for each optional scene whose file is not there
  std::vector<Method> methods;
  std::vector<std::uint64_t> seeds;
  std::vector<RunBudget> budgets;
  std::vector<const Metric*> metrics;  ///< as listed; the first is shown while it runs
  std::string baseline;                ///< name of a method
  std::string efficiency_metric;       ///< name of one of `metrics`, a squared error
  int threads = 0;
};

/// A name as part of a path: letters, digits, '-', '=' and '.' stay, the rest become '_'.
std::string file_name(const std::string& name);

/// Reads a study. Paths in it count from its folder. Raises IoError if the file cannot be read, and
/// UsageError with the place for everything that is wrong in it, unknown names with the nearest.
/// Optional scenes whose files are not there are left out.
StudyPlan read_study(const std::string& path);

}  // namespace ajar::study
