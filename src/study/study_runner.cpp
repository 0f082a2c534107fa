#include "study/study_runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include "core/error.h"
#include "core/warnings.h"
#include "image/metrics.h"
#include "session/job/interrupts.h"
#include "session/job/progress.h"
#include "session/job/resources.h"
#include "session/scenes/scene_file.h"
#include "study/child_process.h"
#include "study/comparison.h"
#include "study/machine.h"
#include "study/time_left.h"

namespace ajar::study {

namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kExitInterrupted = 130;

std::string last_lines(const fs::path& log) {
  std::ifstream file(log);
  std::string last;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("ajar: error")) last = line;
  }
  return last;
}

/// Carries a study out; the names of its files hang on the runs' stems.
class Runner {
 public:
  Runner(const StudyPlan& plan, const StudyOptions& options)
      : plan_(plan), options_(options), machine_(machine_json()) {
    std::vector<std::string> hashes;
    for (const StudyScene& scene : plan.scenes) hashes.push_back(hash_of_scene(scene.scene));
    runs_ = expand(plan, hashes, options.out);
    for (const StudyScene& scene : plan.scenes) result_.references.push_back(scene.reference_file);
    for (const StudyRun& run : runs_) result_.planned += run.is_reference ? 0U : 1U;
  }

  StudyResult run() {
    for (const StudyRun& run : runs_) records_.push_back(finished_record(run));
    const auto done = static_cast<std::size_t>(std::count_if(
        records_.begin(), records_.end(), [](const auto& record) { return record.has_value(); }));
    if (done > 0) {
      options_.report(fmt::format("{} of {} renders are there already", done, runs_.size()));
    }
    warn_of_other_builds();
    // After a signal nothing more is rendered, but finished runs belong into the results.
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      if (interrupt_count() > 0) result_.interrupted = true;
      const bool is_new = !records_[i];
      if (is_new && !result_.interrupted) render_undisturbed(i);
      if (!records_[i]) continue;
      keep(i);
      if (is_new && !runs_[i].is_reference) report_quality(*records_[i]);
    }
    warn_of_disturbed_runs();
    for (const std::string& reference : result_.references) {
      result_.noise.push_back(reference_noise(reference));
    }
    return std::move(result_);
  }

 private:
  static std::string file(const StudyRun& run, const char* suffix) {
    return run.stem.string() + suffix;
  }

  /// Once more if others had a good part of the processors meanwhile; the second run counts.
  void render_undisturbed(std::size_t i) {
    render(i, 1);
    const std::optional<RunRecord>& record = records_[i];
    if (runs_[i].is_reference || !record || !record->is_disturbed() || interrupt_count() > 0) {
      return;
    }
    options_.report(
        fmt::format("    had {:.0f} % of its CPU time: repeated", 100.0 * *record->cpu_share()));
    records_[i].reset();
    render(i, 2);
  }

  void render(std::size_t i, int attempt) {
    const StudyRun& run = runs_[i];
    fs::create_directories(run.stem.parent_path());
    // A picture without a record is not finished, and neither is one with an older record.
    for (const char* suffix : {".record.json", ".exr", ".stats.json"}) {
      fs::remove(file(run, suffix));
    }
    // A process of its own, not a `Render` in this one: its memory and processor time are its own
    // then, no render finds caches and threads warm from another, one that crashes or runs out of
    // memory ends alone, and the measurement is that of the program.
    ChildCommand command{options_.program, {"render"}, options_.folder.string(), file(run, ".log")};
    const std::string& scene = plan_.scenes[run.scene].scene;
    command.arguments.push_back(scene.starts_with("builtin:") ? scene
                                                              : fs::absolute(scene).string());
    command.arguments.insert(command.arguments.end(), run.arguments.begin(), run.arguments.end());
    command.arguments.insert(command.arguments.end(),
                             {"--progress", "none", "--stats", file(run, ".stats.json"), "-o",
                              file(run, ".exr"), "--denoise", wants_denoised() ? "auto" : "none"});
    const std::optional<double> left = seconds_left(plan_, runs_, records_, i);
    options_.report(fmt::format("{}/{}  {}{}", i + 1, runs_.size(), run.title,
                                left ? "  (" + clock_text(*left) + " left)" : ""));
    const double load = load_average();
    const Stopwatch clock;
    const ChildResult child = run_child(command, interrupt_count());
    if (child.interrupted || child.exit_code == kExitInterrupted) {
      result_.interrupted = true;
      return;
    }
    if (child.exit_code != 0) {
      note_failure(run, child.exit_code);
      return;
    }
    std::ifstream statistics(file(run, ".stats.json"));
    RunRecord record{{{"key", run.key},
                      {"title", run.title},
                      {"arguments", command.arguments},
                      {"seconds", clock.seconds()},
                      {"attempt", attempt},
                      {"load_average", load},
                      {"machine", machine_},
                      {"statistics", Json::parse(statistics)}}};
    write_record(run, record);
    records_[i] = std::move(record);
  }

  /// Layers without a metric take no time.
  bool wants_denoised() const {
    return std::any_of(plan_.metrics.begin(), plan_.metrics.end(),
                       [](const Metric* metric) { return metric->of_denoised; });
  }

  void note_failure(const StudyRun& run, int exit_code) {
    const std::string reason = last_lines(file(run, ".log"));
    result_.failures.push_back(fmt::format("{}: {}; see {}", run.title,
                                           !reason.empty() ? reason
                                           : exit_code < 0
                                               ? fmt::format("ended by signal {}", -exit_code)
                                               : fmt::format("ended with {}", exit_code),
                                           file(run, ".log")));
    options_.report(result_.failures.back());
  }

  /// Takes a finished run into the results, measured.
  void keep(std::size_t i) {
    const StudyRun& run = runs_[i];
    if (run.is_reference) {
      result_.references[run.scene] = file(run, ".exr");
      return;
    }
    const std::string& reference = result_.references[run.scene];
    try {
      if (reference.empty()) {
        records_[i]->json.erase("metrics");  // metrics of an older reference
      } else {
        measure(run, reference, *records_[i]);
      }
    } catch (const UsageError& error) {
      // If no picture of the scene can be compared, it is the reference that does not fit.
      if (!measured_.contains(run.scene)) throw;
      result_.failures.emplace_back(error.what());
      return;
    }
    measured_.insert(run.scene);
    result_.runs.push_back({run, *records_[i]});
  }

  /// One number of a finished run, for people that watch.
  void report_quality(const RunRecord& record) {
    const std::string& metric = plan_.metrics.front()->name;
    const std::optional<double> value = record.metric(metric);
    if (value) {
      const double cpu = record.number("cpu_seconds").value_or(0.0);
      options_.report(fmt::format("    {:.3g} s, {:.3g} s of CPU, {} {:.4g}", record.seconds(), cpu,
                                  metric, *value));
    }
  }

  /// Contribution of the reference's own noise to the metric of efficiency, from its standard
  /// error.
  std::optional<double> reference_noise(const std::string& path) const {
    if (path.empty()) return std::nullopt;
    const LoadedPicture reference = load_picture(path);
    const std::vector<float>& errors = reference.standard_error;
    if (errors.empty()) return std::nullopt;
    const bool relative = plan_.efficiency_metric != "mse";
    double sum = 0.0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const double value = reference.linear[i];
      const double scale = relative ? value * value + kRelativeMseEpsilon : 1.0;
      sum += double{errors[i]} * errors[i] / scale;
    }
    return sum / static_cast<double>(errors.size());
  }

  /// Adds the metrics to the record, unless it has them of this very reference.
  void measure(const StudyRun& run, const std::string& reference, RunRecord& record) {
    const std::string mark = reference_mark(reference);
    const bool measured = record.json.contains("metrics") && record.json.at("reference") == mark;
    Json values = measured ? record.json.at("metrics") : Json::object();
    std::vector<const Metric*> missing;
    // The last is for the estimate of it, wanted or not.
    std::vector<const Metric*> wanted = plan_.metrics;
    wanted.push_back(metrics_by_name({kRelativeErrorMetric}).front());
    for (const Metric* metric : wanted) {
      const bool is_new = std::find(missing.begin(), missing.end(), metric) == missing.end();
      if (is_new && !values.contains(metric->name)) missing.push_back(metric);
    }
    if (missing.empty()) return;
    const Comparison comparison =
        compare_files(reference, {file(run, ".exr")}, missing, kFlipPixelsPerDegree);
    for (std::size_t i = 0; i < missing.size(); ++i) {
      const std::optional<double> value = comparison.pictures.at(0).values.at(i);
      values[missing[i]->name] = value && std::isfinite(*value) ? Json(*value) : Json();
    }
    record.json["reference"] = mark;
    record.json["metrics"] = values;
    write_record(run, record);
  }

  /// Changes when the file of a reference does.
  static std::string reference_mark(const std::string& reference) {
    return fmt::format("{} {} {}", fs::path(reference).filename().string(),
                       fs::file_size(reference),
                       fs::last_write_time(reference).time_since_epoch().count());
  }

  void warn_of_disturbed_runs() {
    const auto disturbed =
        std::count_if(result_.runs.begin(), result_.runs.end(),
                      [](const FinishedRun& finished) { return finished.record.is_disturbed(); });
    if (disturbed == 0) return;
    result_.warnings.push_back(fmt::format(
        "{} of {} renders had less than {:.0f} % of their CPU time, also when they were "
        "repeated: something else ran on this machine, and what is said of their time "
        "misleads (remove seed-N.record.json of those marked in {} to repeat them)",
        disturbed, result_.runs.size(), 100.0 * kFairCpuShare, (options_.out / "runs").string()));
  }

  void warn_of_other_builds() {
    std::size_t others = 0;
    for (const auto& record : records_) {
      others += record && record->json.value("machine", Json::object()) != machine_ ? 1U : 0U;
    }
    if (others == 0) return;
    result_.warnings.push_back(
        fmt::format("{} finished renders are of another machine or another build of this program; "
                    "their times may not be comparable (remove {} to repeat them)",
                    others, (options_.out / "runs").string()));
  }

  const StudyPlan& plan_;
  const StudyOptions& options_;
  Json machine_;
  std::vector<StudyRun> runs_;
  std::vector<std::optional<RunRecord>> records_;
  std::set<std::size_t> measured_;  ///< scenes of which a picture could be compared
  StudyResult result_;
};
}  // namespace

StudyResult run_study(const StudyPlan& plan, const StudyOptions& options) {
  return Runner(plan, options).run();
}

}  // namespace ajar::study
