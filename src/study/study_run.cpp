#include "study/study_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "os/regular_file.h"
#include "session/output/stats_json.h"
#include "session/version.h"
#include "study/machine.h"

namespace ajar::study {

namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void add_method(const Method& method, std::vector<std::string>& arguments) {
  arguments.insert(arguments.end(), {"--integrator", method.integrator});
  for (const auto& [name, value] : method.parameters) {
    arguments.insert(arguments.end(), {"--set", fmt::format("{}={}", name, value)});
  }
}

void add_budget(const RunBudget& budget, StudyRun& run) {
  if (budget.seconds) {
    run.arguments.insert(run.arguments.end(), {"--time", fmt::format("{}", *budget.seconds)});
    run.seconds = budget.seconds;
  } else {
    run.arguments.insert(run.arguments.end(), {"--spp", std::to_string(*budget.samples_per_pixel)});
  }
}

std::string key_of(const std::string& scene_hash, const std::vector<std::string>& arguments) {
  std::string text = version() + '\n' + scene_hash;
  for (const std::string& argument : arguments) text += '\n' + argument;
  return hash_text(text);
}

StudyRun reference_run(const StudyPlan& plan, std::size_t scene, const std::string& scene_hash,
                       const fs::path& out) {
  const StudyScene& place = plan.scenes[scene];
  const MadeReference& made = *place.made_reference;
  StudyRun run;
  run.scene = scene;
  run.is_reference = true;
  run.seed = made.seed;
  run.title = place.name + ", reference";
  run.arguments = place.options;
  add_method(made.method, run.arguments);
  for (const RunBudget& limit : made.limits) add_budget(limit, run);
  run.arguments.insert(run.arguments.end(),
                       {"--seed", std::to_string(made.seed), "--aov", "standard-error,replicates"});
  run.key = key_of(scene_hash, run.arguments);
  // Under its hash, so that going back to older settings finds the older reference again.
  run.stem = out / "references" / (file_name(place.name) + "-" + run.key);
  return run;
}

StudyRun method_run(const StudyPlan& plan, const StudyRun& indices, const std::string& scene_hash,
                    const fs::path& out) {
  const StudyScene& scene = plan.scenes[indices.scene];
  const Method& method = plan.methods[indices.method];
  const RunBudget& budget = plan.budgets[indices.budget];
  StudyRun run = indices;
  run.title = fmt::format("{}, {}, {}, seed {}", scene.name, method.name, budget.name(), run.seed);
  run.arguments = scene.options;
  add_method(method, run.arguments);
  add_budget(budget, run);
  run.arguments.insert(run.arguments.end(), {"--seed", std::to_string(run.seed), "--threads",
                                             std::to_string(plan.threads)});
  run.key = key_of(scene_hash, run.arguments);
  run.stem = out / "runs" / file_name(scene.name) / file_name(method.name) / budget.name() /
             fmt::format("seed-{}", run.seed);
  return run;
}

fs::path with_suffix(const fs::path& stem, const char* suffix) { return stem.string() + suffix; }
}  // namespace

std::vector<StudyRun> expand(const StudyPlan& plan, const std::vector<std::string>& scene_hashes,
                             const fs::path& out) {
  std::vector<StudyRun> runs;
  for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
    if (!plan.scenes[scene].made_reference) continue;
    runs.push_back(reference_run(plan, scene, scene_hashes[scene], out));
  }
  for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
    for (std::size_t budget = 0; budget < plan.budgets.size(); ++budget) {
      for (const std::uint64_t seed : plan.seeds) {
        for (std::size_t method = 0; method < plan.methods.size(); ++method) {
          if (!plan.methods[method].is_for(plan.budgets[budget])) continue;
          StudyRun indices;
          indices.scene = scene;
          indices.method = method;
          indices.budget = budget;
          indices.seed = seed;
          runs.push_back(method_run(plan, indices, scene_hashes[scene], out));
        }
      }
    }
  }
  return runs;
}

namespace {

/// True if all members that are read are there.
bool is_record(const Json& json) {
  const auto has = [](const Json& part, const char* name, auto&& is_right) {
    return part.is_object() && part.contains(name) && is_right(part.at(name));
  };
  const auto is_number = [](const Json& value) { return value.is_number(); };
  const auto has_times = [&](const Json& seconds) {
    return has(seconds, "prepare", is_number) && has(seconds, "render", is_number);
  };
  const auto has_statistics = [&](const Json& statistics) {
    return has(statistics, "seconds", has_times);
  };
  const auto is_text = [](const Json& value) { return value.is_string(); };
  const auto is_object = [](const Json& value) { return value.is_object(); };
  return has(json, "key", [](const Json&) { return true; }) &&
         has(json, "statistics", has_statistics) &&
         (!json.contains("metrics") ||
          (has(json, "metrics", is_object) && has(json, "reference", is_text))) &&
         (!json.contains("attempt") || has(json, "attempt", is_number)) &&
         (!json.contains("machine") || has(json, "machine", is_object));
}

}  // namespace

double RunRecord::seconds() const {
  const Json& seconds = json.at("statistics").at("seconds");
  return seconds.at("prepare").get<double>() + seconds.at("render").get<double>();
}

std::optional<double> RunRecord::metric(const std::string& name) const {
  const auto metrics = json.find("metrics");
  if (metrics == json.end() || !metrics->contains(name) || !metrics->at(name).is_number()) {
    return std::nullopt;
  }
  return metrics->at(name).get<double>();
}

std::optional<double> RunRecord::number(const std::string& statistic) const {
  const Json& statistics = json.at("statistics");
  if (!statistics.contains(statistic) || !statistics.at(statistic).is_number()) return std::nullopt;
  return statistics.at(statistic).get<double>();
}

std::optional<double> RunRecord::cpu_share() const {
  constexpr double kShortest = 0.5;  // seconds
  const double seconds = json.at("statistics").at("seconds").at("render").get<double>();
  const std::optional<double> used = number("cpu_seconds");
  double processors = number("threads").value_or(0.0);
  const auto machine = json.find("machine");
  if (machine != json.end() && machine->contains("cores") && machine->at("cores").is_number()) {
    processors = std::min(processors, machine->at("cores").get<double>());
  }
  if (!used || seconds < kShortest || !(processors > 0.0)) return std::nullopt;
  return *used / (processors * seconds);
}

bool RunRecord::knows_error() const {
  const Json& statistics = json.at("statistics");
  const auto is_bound = statistics.find("estimated_error_is_lower_bound");
  return number("estimated_relative_error").has_value() &&
         (is_bound == statistics.end() || *is_bound != Json(true));
}

bool RunRecord::is_disturbed() const { return cpu_share().value_or(1.0) < kFairCpuShare; }

std::optional<RunRecord> finished_record(const StudyRun& run) {
  std::error_code ignored;
  if (!fs::exists(with_suffix(run.stem, ".exr"), ignored)) return std::nullopt;
  // Any error in the file makes the run start anew.
  Json json;
  try {
    const FileBytes file = read_file(with_suffix(run.stem, ".record.json").string());
    json = Json::parse(file.view(), nullptr, false);
  } catch (const Error&) {
    return std::nullopt;
  }
  if (!is_record(json) || json.at("key") != run.key) return std::nullopt;
  return RunRecord{std::move(json)};
}

void write_record(const StudyRun& run, const RunRecord& record) {
  write_json(record.json, with_suffix(run.stem, ".record.json").string());
}

}  // namespace ajar::study
