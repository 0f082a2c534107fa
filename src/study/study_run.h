#pragma once
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "study/study_plan.h"

/// The single renders of a study and their records.
namespace ajar::study {

/// One render: of a scene by a method with a seed and a budget, or of a reference.
struct StudyRun {
  std::size_t scene = 0;  ///< indices into the plan; those of a reference are not used
  std::size_t method = 0;
  std::size_t budget = 0;
  std::uint64_t seed = 0;
  bool is_reference = false;
  std::string title;                   ///< for people
  std::vector<std::string> arguments;  ///< arguments of `ajar render`, without the scene and output
                                       ///< files
  /// Files are `stem` + ".exr", ".stats.json", ".record.json", ".log".
  std::filesystem::path stem;
  /// Changes with everything that decides the picture: scene, arguments, version.
  std::string key;
  std::optional<double> seconds;  ///< its time limit
};

/// The runs in the order in which they are made: references first, then, for each scene and budget,
/// seed by seed all methods in turn, so that disturbances of the machine affect all of them.
/// `scene_hashes`: of the content, one per scene. `out`: absolute.
std::vector<StudyRun> expand(const StudyPlan& plan, const std::vector<std::string>& scene_hashes,
                             const std::filesystem::path& out);

/// Runs that had less of the processors were disturbed: their times mislead.
inline constexpr double kFairCpuShare = 0.75;

/// Record of a finished run: the JSON file beside its picture.
struct RunRecord {  // NOLINT(bugprone-exception-escape): moving JSON throws nothing
  nlohmann::ordered_json json;

  /// Wall clock of `prepare` and `render`, seconds: the time of a method once a scene is loaded.
  double seconds() const;
  std::optional<double> metric(const std::string& name) const;
  std::optional<double> number(const std::string& statistic) const;
  /// CPU time of the rendering over that available to its threads on this machine: near 1 where
  /// nothing else runs. Empty if unknown, or for less than half a second, which is too short.
  std::optional<double> cpu_share() const;
  /// True if the CPU share is less than `kFairCpuShare`.
  bool is_disturbed() const;
  /// True if it has an estimate of its error that is no lower bound.
  bool knows_error() const;
};

/// The record of a run that finished with the same key and still has its picture; else empty.
std::optional<RunRecord> finished_record(const StudyRun& run);
void write_record(const StudyRun& run, const RunRecord& record);

}  // namespace ajar::study
