#include "study/study_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <numeric>
#include <set>

#include "core/located_json.h"
#include "os/regular_file.h"
#include "session/options/option_values.h"
#include "session/render/resolved_render.h"
#include "session/scenes/builtin_scenes.h"
#include "session/scenes/scene_file.h"

namespace ajar::study {

namespace {
namespace fs = std::filesystem;
using Kind = LocatedJson::Kind;

constexpr std::size_t kMostSeeds = 10000;
constexpr std::size_t kMostMethods = 10000;
constexpr auto kMostSamples = static_cast<std::uint64_t>(limits::kSamples.most);
/// A seed of its own, so that no run of the study repeats the reference's random numbers.
constexpr std::uint64_t kReferenceSeed = 1'000'003;

/// Not empty.
std::string text_of(const LocatedJson& node) {
  std::string text = node.text();
  if (text.empty()) node.fail_type("a text that is not empty");
  return text;
}

std::vector<LocatedJson> elements_of(const LocatedJson& node) {
  std::vector<LocatedJson> elements = node.items();
  if (elements.empty()) node.fail("must be an array of at least one element");
  return elements;
}

double positive(const LocatedJson& node) {
  if (!(node.number() > 0.0)) node.fail_type("a number above 0");
  return node.number();
}

/// Value as `--set` takes it.
std::string parameter_of(const LocatedJson& node) {
  const bool fits = node.is(Kind::Text) || node.is(Kind::Number) || node.is(Kind::Bool);
  if (!fits) node.fail_type("a text, a number, true or false");
  return node.plain();
}

/// A text stands for an object that has one member.
LocatedJson members_of(const LocatedJson& node) {
  return node.is(Kind::Text) ? node.without_members() : node;
}

/// Raises UsageError unless there is such a method with such parameters.
void check_method(const Method& method) {
  RenderSpec spec;
  spec.integrator = method.integrator;
  spec.parameters = method.parameters;
  desc::Film film;
  const ResolvedRender setup = resolve_render(spec, {}, film);
  setup.integrator->read(setup.parameters);
}

Method read_method(const LocatedJson& node) {
  Method method;
  method.integrator = node.is(Kind::Text) ? text_of(node) : text_of(node.at("integrator"));
  const LocatedJson given = members_of(node);
  method.name = given.has("name") ? text_of(given.at("name")) : method.integrator;
  if (const auto parameters = given.find("parameters")) {
    for (const auto& [name, key, value] : parameters->members()) {
      method.parameters[name] = parameter_of(value);
    }
  }
  return method;
}

double read_seconds(const LocatedJson& node) {
  if (!node.is(Kind::Text)) return positive(node);
  double seconds = 0.0;
  node.located([&] { seconds = parse_duration("time", text_of(node)); });
  return seconds;
}

RunBudget read_samples(const LocatedJson& node) {
  return {std::nullopt, node.whole<std::uint64_t>(1, kMostSamples)};
}

RunBudget read_budget(const LocatedJson& node) {
  node.check_members("member", {"time", "spp"});
  if (node.has("time") == node.has("spp")) node.fail("expects either \"time\" or \"spp\"");
  if (node.has("spp")) return read_samples(node.at("spp"));
  return {read_seconds(node.at("time")), std::nullopt};
}

/// A method, or all that its sweep expands to: the product of the values of its parameters.
std::vector<Method> read_methods(const LocatedJson& given) {
  const LocatedJson node = members_of(given);
  node.check_members("member", {"integrator", "name", "parameters", "sweep", "budgets"});
  std::vector<Method> methods{read_method(given)};
  methods.front().family = methods.front().name;
  if (node.has("budgets")) {
    for (const LocatedJson& budget : elements_of(node.at("budgets"))) {
      methods.front().budgets.push_back(read_budget(budget).name());
    }
  }
  if (node.has("sweep")) {
    for (const auto& [parameter, key, values] : node.at("sweep").members()) {
      std::vector<Method> expanded;
      for (const Method& method : methods) {
        if (expanded.size() > kMostMethods) break;
        for (const LocatedJson& value : elements_of(values)) {
          Method next = method;
          next.parameters[parameter] = parameter_of(value);
          next.swept[parameter] = parameter_of(value);
          next.name += " " + parameter + "=" + parameter_of(value);
          expanded.push_back(std::move(next));
        }
      }
      if (expanded.size() > kMostMethods) {
        node.at("sweep").fail(fmt::format("makes more than {} methods", kMostMethods));
      }
      methods = std::move(expanded);
    }
  }
  for (const Method& method : methods) node.located([&] { check_method(method); });
  return methods;
}

MadeReference read_made_reference(const LocatedJson& node) {
  node.check_members("member", {"integrator", "parameters", "spp", "time", "seed"});
  MadeReference made;
  made.method = read_method(node);
  node.located([&] { check_method(made.method); });
  made.seed = kReferenceSeed;
  if (node.has("seed")) {
    made.seed = node.at("seed").whole<std::uint64_t>(0, kMostSamples);
  }
  if (node.has("spp")) made.limits.push_back(read_samples(node.at("spp")));
  if (node.has("time")) made.limits.push_back({read_seconds(node.at("time")), std::nullopt});
  if (made.limits.empty()) node.fail("expects \"spp\" or \"time\", or both");
  return made;
}

/// An element, or the elements of an array: alternatives, of which the first that exists wins.
std::vector<LocatedJson> alternatives(const LocatedJson& node) {
  return node.is(Kind::Array) ? elements_of(node) : std::vector<LocatedJson>{node};
}

std::string from_folder(const fs::path& folder, const std::string& path) {
  return (folder / path).lexically_normal().string();
}

/// The first alternative that exists, or else the first, with a message.
struct SceneChoice {
  std::string scene;
  std::optional<std::string> absence;
};

SceneChoice choose_scene(const LocatedJson& node, const fs::path& folder) {
  std::vector<std::string> tried;
  for (const LocatedJson& candidate : alternatives(node)) {
    std::string text = text_of(candidate);
    constexpr std::string_view kBuiltin = "builtin:";
    if (text.starts_with(kBuiltin)) {
      const std::vector<std::string> names = builtin_scene_names();
      const std::string name = text.substr(kBuiltin.size());
      if (std::find(names.begin(), names.end(), name) == names.end()) {
        candidate.fail(unknown_name_message("built-in scene", name, names));
      }
      return {text, std::nullopt};
    }
    std::string path = from_folder(folder, text);
    std::error_code ignored;
    if (fs::is_regular_file(path, ignored)) return {path, std::nullopt};
    tried.push_back(std::move(path));
  }
  return {tried.front(), fmt::format("no such scene file: {}", fmt::join(tried, ", "))};
}

/// Raises UsageError if there is none, unless the reference of an absent scene may be absent, too.
void choose_reference(const LocatedJson& node, const fs::path& folder, bool may_be_absent,
                      StudyScene& scene) {
  std::vector<std::string> tried;
  for (const LocatedJson& candidate : alternatives(node)) {
    if (candidate.is(Kind::Object)) {
      scene.made_reference = read_made_reference(candidate);
      return;
    }
    std::string path = from_folder(folder, text_of(candidate));
    std::error_code ignored;
    if (fs::is_regular_file(path, ignored)) {
      scene.reference_file = path;
      return;
    }
    tried.push_back(std::move(path));
  }
  if (may_be_absent) return;
  node.fail(fmt::format("no such reference picture: {}", fmt::join(tried, ", ")));
}

/// `--resolution` and so on, from the scene or else from the whole study.
std::vector<std::string> read_options(const LocatedJson& study, const LocatedJson& scene) {
  std::vector<std::string> options;
  // A scene that says one of these is not meant to get the other from the study.
  const bool has_size = scene.has("resolution") || scene.has("scale");
  const LocatedJson& size = has_size ? scene : study;
  if (size.has("resolution") && size.has("scale")) {
    size.fail("expects \"resolution\" or \"scale\", not both");
  }
  const auto add = [&](const std::string& name,
                       const std::function<void(const LocatedJson&)>& test) {
    const bool from_scene =
        scene.has(name) || (has_size && (name == "resolution" || name == "scale"));
    const LocatedJson& source = from_scene ? scene : study;
    if (!source.has(name)) return;
    const LocatedJson node = source.at(name);
    node.located([&] { test(node); });
    options.push_back("--" + name);
    options.push_back(parameter_of(node));
  };
  add("resolution", [](const LocatedJson& n) { parse_resolution("resolution", text_of(n)); });
  add("scale", [](const LocatedJson& n) { positive(n); });
  add("crop", [](const LocatedJson& n) { parse_crop("crop", text_of(n)); });
  add("depth", [](const LocatedJson& n) { parse_depth("depth", parameter_of(n)); });
  return options;
}

/// `absence` says so if this is an optional scene whose file is not there.
StudyScene read_scene(const LocatedJson& study, const LocatedJson& given, const fs::path& folder,
                      std::optional<std::string>& absence) {
  StudyScene scene;
  const LocatedJson node = members_of(given);
  node.check_members(
      "member", {"scene", "name", "optional", "reference", "resolution", "scale", "crop", "depth"});
  const LocatedJson file = given.is(Kind::Text) ? given : node.at("scene");
  const bool is_optional = node.value_or("optional", false);
  const SceneChoice choice = choose_scene(file, folder);
  scene.scene = choice.scene;
  if (choice.absence) {
    if (!is_optional) file.fail(*choice.absence);
    absence = file.where().to_string() + ": " + *choice.absence + "; this scene is left out";
  }
  scene.name = node.has("name") ? text_of(node.at("name")) : scene_stem(scene.scene);
  scene.options = read_options(study, node);
  if (!node.has("reference") && !study.has("reference")) {
    node.fail("there is no \"reference\", neither here nor for the whole study");
  }
  choose_reference((node.has("reference") ? node : study).at("reference"), folder,
                   absence.has_value(), scene);
  return scene;
}

std::vector<std::uint64_t> read_seeds(const LocatedJson& study) {
  std::vector<std::uint64_t> seeds;
  if (!study.has("seeds")) return {1};
  const LocatedJson node = study.at("seeds");
  if (!node.is(Kind::Array)) {
    seeds.resize(node.whole<std::size_t>(1, kMostSeeds));
    std::iota(seeds.begin(), seeds.end(), std::uint64_t{1});
    return seeds;
  }
  for (const LocatedJson& element : elements_of(node)) {
    const auto seed = element.whole<std::uint64_t>(0, kMostSamples);
    if (std::find(seeds.begin(), seeds.end(), seed) != seeds.end()) {
      element.fail("this seed is there twice: the same random numbers prove nothing twice");
    }
    seeds.push_back(seed);
  }
  return seeds;
}

/// Lower-case folder name: some file systems take "Pool" for "pool".
std::string folder_of(const std::string& name) {
  std::string folder = file_name(name);
  for (char& c : folder) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return folder;
}

/// Names become folders; equal folders would mix up files.
void check_unique(const LocatedJson& node, const std::vector<std::string>& names) {
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (!seen.insert(folder_of(name)).second) {
      node.fail("the name \"" + name + "\" is there twice; set \"name\"");
    }
  }
}

/// Scenes that are named after their files get as many parent folders before their name as make it
/// unique.
void tell_apart(const std::vector<LocatedJson>& nodes, std::vector<StudyScene>& scenes) {
  std::vector<fs::path> above;  // folders that the names do not have yet
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const bool is_chosen = members_of(nodes[i]).has("name");
    const bool is_file = fs::path(scenes[i].scene).has_parent_path();
    above.push_back(is_chosen || !is_file
                        ? fs::path()
                        : fs::absolute(scenes[i].scene).lexically_normal().parent_path());
    // The stem of a file "scene" is its folder.
    if (above[i].filename() == scenes[i].name) above[i] = above[i].parent_path();
  }
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    std::map<std::string, int> count;
    for (const StudyScene& scene : scenes) ++count[folder_of(scene.name)];
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      if (count[folder_of(scenes[i].name)] == 1 || !above[i].has_filename()) continue;
      scenes[i].name = (above[i].filename() / scenes[i].name).string();
      above[i] = above[i].parent_path();
      is_changed = true;
    }
  }
}

/// Names are given before scenes are left out: that one is absent must neither change the name of
/// another, by which its renders are found again, nor hide that a name is there twice.
void read_scenes(const LocatedJson& study, const fs::path& folder, StudyPlan& plan) {
  const std::vector<LocatedJson> nodes = elements_of(study.at("scenes"));
  std::vector<StudyScene> scenes;
  std::vector<std::optional<std::string>> absences(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    scenes.push_back(read_scene(study, nodes[i], folder, absences[i]));
  }
  tell_apart(nodes, scenes);
  std::vector<std::string> names;
  names.reserve(scenes.size());
  for (const StudyScene& scene : scenes) names.push_back(scene.name);
  check_unique(study.at("scenes"), names);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (absences[i]) {
      plan.left_out.push_back(std::move(*absences[i]));
    } else {
      plan.scenes.push_back(std::move(scenes[i]));
    }
  }
  if (plan.scenes.empty()) {
    study.at("scenes").fail(
        fmt::format("none of these scenes is there\n{}", fmt::join(plan.left_out, "\n")));
  }
}

/// Methods can only be for budgets of the study.
void check_method_budgets(const LocatedJson& integrators, const std::vector<std::string>& budgets) {
  for (const LocatedJson& node : elements_of(integrators)) {
    const auto own = members_of(node).find("budgets");
    if (!own) continue;
    for (const LocatedJson& budget : elements_of(*own)) {
      if (std::find(budgets.begin(), budgets.end(), read_budget(budget).name()) == budgets.end()) {
        budget.fail("this is none of the study's budgets");
      }
    }
  }
}

void read_metrics(const LocatedJson& study, StudyPlan& plan) {
  if (study.has("metrics")) {
    for (const LocatedJson& node : elements_of(study.at("metrics"))) {
      const Metric* metric = nullptr;
      node.located([&] { metric = metrics_by_name({text_of(node)}).front(); });
      const bool is_new =
          std::find(plan.metrics.begin(), plan.metrics.end(), metric) == plan.metrics.end();
      if (is_new) plan.metrics.push_back(metric);
    }
  }
  if (plan.metrics.empty()) plan.metrics = metrics_by_name({});
  std::vector<std::string> squared;
  for (const Metric* metric : plan.metrics) {
    for (const char* name : {"relmse", "relmse-trimmed", "mse"}) {
      if (metric->name == name) squared.emplace_back(name);
    }
  }
  if (!study.has("efficiency")) {
    const bool has_relative = std::find(squared.begin(), squared.end(), "relmse") != squared.end();
    plan.efficiency_metric = has_relative || squared.empty() ? "relmse" : squared.front();
    if (squared.empty()) plan.efficiency_metric.clear();
    return;
  }
  const LocatedJson node = study.at("efficiency");
  plan.efficiency_metric = text_of(node);
  if (std::find(squared.begin(), squared.end(), plan.efficiency_metric) == squared.end()) {
    node.fail(unknown_name_message("metric of efficiency", plan.efficiency_metric, squared));
  }
}

void read_baseline(const LocatedJson& study, StudyPlan& plan) {
  plan.baseline = plan.methods.front().name;
  if (!study.has("baseline")) return;
  plan.baseline = text_of(study.at("baseline"));
  std::vector<std::string> names;
  for (const Method& method : plan.methods) names.push_back(method.name);
  if (std::find(names.begin(), names.end(), plan.baseline) == names.end()) {
    study.at("baseline").fail(unknown_name_message("method", plan.baseline, names));
  }
}
}  // namespace

std::string RunBudget::name() const {
  return seconds ? fmt::format("{:g}s", *seconds) : fmt::format("{}spp", *samples_per_pixel);
}

bool Method::is_for(const RunBudget& budget) const {
  return budgets.empty() ||
         std::find(budgets.begin(), budgets.end(), budget.name()) != budgets.end();
}

std::string file_name(const std::string& name) {
  std::string result = name;
  for (char& c : result) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '=' || c == '.';
    if (!plain) c = '_';
  }
  if (result.starts_with('.')) result.front() = '_';
  return result;
}

StudyPlan read_study(const std::string& path) {
  const FileBytes file = read_file(path);
  const LocatedJson study = LocatedJson::parse(
      std::string(file.view()), {.name = path, .raise = raise_error<UsageError>, .deepest = 64});
  for (const LocatedJson::Repeated& member : study.repeated(1)) {
    throw UsageError(located(member.where, "the member \"" + member.name + "\" is there twice"));
  }
  study.check_members(
      "member", {"name", "scenes", "integrators", "seeds", "budgets", "reference", "metrics",
                 "efficiency", "baseline", "threads", "resolution", "scale", "crop", "depth"});
  const fs::path folder = fs::path(path).parent_path();
  StudyPlan plan;
  plan.name = study.has("name") ? text_of(study.at("name")) : fs::path(path).stem().string();
  read_scenes(study, folder, plan);
  std::vector<std::string> names;
  for (const LocatedJson& node : elements_of(study.at("integrators"))) {
    for (Method& method : read_methods(node)) {
      names.push_back(method.name);
      plan.methods.push_back(std::move(method));
    }
  }
  check_unique(study.at("integrators"), names);
  plan.seeds = read_seeds(study);
  names.clear();
  for (const LocatedJson& node : elements_of(study.at("budgets"))) {
    plan.budgets.push_back(read_budget(node));
    names.push_back(plan.budgets.back().name());
  }
  check_unique(study.at("budgets"), names);
  check_method_budgets(study.at("integrators"), names);
  read_metrics(study, plan);
  read_baseline(study, plan);
  if (study.has("threads")) {
    plan.threads = study.at("threads").whole(limits::kThreads.least, limits::kThreads.most);
  }
  return plan;
}

}  // namespace ajar::study
