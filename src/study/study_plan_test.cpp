#include "study/study_plan.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "core/error.h"
#include "study/study_run.h"

namespace ajar::study {
namespace {

namespace fs = std::filesystem;

class StudyFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("ajar-study-plan-" + std::to_string(getpid()));
    fs::create_directories(folder_ / "scenes");
    std::ofstream(folder_ / "scenes" / "mine.pbrt") << "WorldBegin\nWorldEnd\n";
    std::ofstream(folder_ / "reference.pfm") << "not read here";
  }
  void TearDown() override { fs::remove_all(folder_); }

  StudyPlan read(const std::string& text) const {
    const fs::path path = folder_ / "study.json";
    std::ofstream(path) << text;
    return read_study(path.string());
  }
  /// The message of the error without the folder.
  std::string error_of(const std::string& text) const {
    try {
      read(text);
    } catch (const UsageError& error) {
      const std::string message = error.what();
      const std::string prefix = (folder_ / "study.json").string();
      EXPECT_TRUE(message.starts_with(prefix)) << message;
      return message.substr(std::min(prefix.size(), message.size()));
    }
    return "no error";
  }
  /// A study that is right, with more members or others.
  static std::string study(const std::string& more,
                           const std::string& scenes = R"(["builtin:cornell"])",
                           const std::string& integrators = R"(["pt", "bdpt"])") {
    return R"({"scenes": )" + scenes + R"(, "integrators": )" + integrators +
           (more.empty() ? "" : ", " + more) + "}";
  }
  static constexpr const char* kRest =
      R"("budgets": [{"spp": 4}], "reference": {"integrator": "pt", "spp": 16})";

  fs::path folder_;
};

TEST_F(StudyFile, HasDefaults) {
  const StudyPlan plan = read(study(kRest));
  EXPECT_EQ(plan.name, "study");
  EXPECT_EQ(plan.seeds, std::vector<std::uint64_t>{1});
  EXPECT_EQ(plan.baseline, "pt");
  EXPECT_EQ(plan.efficiency_metric, "relmse");
  EXPECT_EQ(plan.metrics.size(), metrics().size());
  ASSERT_EQ(plan.scenes.size(), 1U);
  EXPECT_EQ(plan.scenes[0].name, "cornell");
  EXPECT_TRUE(plan.scenes[0].options.empty());
  EXPECT_EQ(plan.scenes[0].made_reference.value().limits.at(0).name(), "16spp");
}

TEST_F(StudyFile, MetricsStayInTheirOrder) {
  const std::string rest = kRest;
  const StudyPlan plan = read(study(rest + R"(, "metrics": ["relmse", "flip", "mse", "flip"])"));
  std::string names;
  for (const Metric* metric : plan.metrics) names += metric->name + " ";
  EXPECT_EQ(names, "relmse flip mse ");
}

TEST_F(StudyFile, TheFirstSceneAndReferenceThatExistWin) {
  const StudyPlan plan =
      read(study(R"("budgets": [{"time": "90s"}], "reference": ["absent.exr", "reference.pfm"])",
                 R"([{"scene": ["absent.pbrt", "scenes/mine.pbrt", "builtin:cornell"], "name": "a"},
          {"scene": ["absent.pbrt", "builtin:cornell"], "reference": {"integrator": "pt", "time": 5}}])"));
  EXPECT_EQ(plan.scenes.at(0).scene, (folder_ / "scenes" / "mine.pbrt").string());
  EXPECT_EQ(plan.scenes.at(0).reference_file, (folder_ / "reference.pfm").string());
  EXPECT_EQ(plan.scenes.at(1).scene, "builtin:cornell");
  EXPECT_EQ(plan.scenes.at(1).made_reference.value().limits.at(0).seconds, 5.0);
  EXPECT_EQ(plan.budgets.at(0).name(), "90s");
}

TEST_F(StudyFile, ASweepIsTheProductOfItsValues) {
  const StudyPlan plan = read(study(kRest, R"(["builtin:cornell"])", R"([
      {"integrator": "mmlt", "name": "m", "parameters": {"bootstrap": 1000},
       "sweep": {"sigma": [0.01, 0.1], "mutation": ["gaussian", "kelemen"]}}])"));
  ASSERT_EQ(plan.methods.size(), 4U);
  EXPECT_EQ(plan.methods[1].name, "m sigma=0.01 mutation=kelemen");
  EXPECT_EQ(plan.methods[2].parameters.at("sigma"), "0.1");
  EXPECT_EQ(plan.methods[2].parameters.at("bootstrap"), "1000");
}

TEST_F(StudyFile, SweepsOfTooManyMethodsAreRefusedBeforeTheyAreMade) {
  std::string values;
  for (int i = 1; i <= 200; ++i) values += (i > 1 ? ", " : "") + std::to_string(i);
  std::string sweep;
  for (const char* name : {"bootstrap", "chains", "large-step", "sigma", "multi-try"}) {
    sweep += (sweep.empty() ? "\"" : ", \"") + std::string(name) + "\": [" + values + "]";
  }
  const std::string error = error_of(study(
      kRest, R"(["builtin:cornell"])", R"([{"integrator": "mmlt", "sweep": {)" + sweep + "}}]"));
  EXPECT_NE(error.find("sweep: makes more than 10000 methods"), std::string::npos) << error;
}

TEST_F(StudyFile, AMethodMayBeForSomeBudgetsOnly) {
  const StudyPlan plan = read(study(
      R"("budgets": [{"spp": 4}, {"time": 2}], "reference": {"integrator": "pt", "spp": 16})",
      R"(["builtin:cornell"])",
      R"(["pt", {"integrator": "bdpt", "budgets": [{"time": "2s"}], "sweep": {"cull": [0, 1]}}])"));
  ASSERT_EQ(plan.methods.size(), 3U);
  EXPECT_TRUE(plan.methods[0].is_for(plan.budgets[0]));
  EXPECT_FALSE(plan.methods[2].is_for(plan.budgets[0]));
  EXPECT_TRUE(plan.methods[2].is_for(plan.budgets[1]));
  EXPECT_EQ(plan.methods[2].family, "bdpt");
  EXPECT_EQ(plan.methods[2].swept.at("cull"), "1");
  std::vector<std::string> titles;
  for (const StudyRun& run : expand(plan, {"hash"}, "out")) titles.push_back(run.title);
  EXPECT_EQ(titles,
            (std::vector<std::string>{"cornell, reference", "cornell, pt, 4spp, seed 1",
                                      "cornell, pt, 2s, seed 1", "cornell, bdpt cull=0, 2s, seed 1",
                                      "cornell, bdpt cull=1, 2s, seed 1"}));
}

TEST_F(StudyFile, ScenesOfEqualFileNamesAreToldApartByTheirFolders) {
  fs::create_directories(folder_ / "other");
  fs::copy_file(folder_ / "scenes" / "mine.pbrt", folder_ / "other" / "Mine.pbrt");
  const StudyPlan plan =
      read(study(kRest, R"(["scenes/mine.pbrt", "other/Mine.pbrt", "builtin:cornell"])"));
  EXPECT_EQ(plan.scenes.at(0).name, "scenes/mine");
  EXPECT_EQ(plan.scenes.at(1).name, "other/Mine") << "also where file systems ignore the case";
  EXPECT_EQ(plan.scenes.at(2).name, "cornell");
  std::set<fs::path> folders;
  for (const StudyRun& run : expand(plan, {"1", "2", "3"}, "out")) {
    if (!run.is_reference) folders.insert(run.stem.parent_path());
  }
  EXPECT_EQ(folders.size(), 6U) << "two methods, three scenes";
  // A file "scene" is named after its folder, which may not be enough either.
  for (const char* place : {"pool", "stairs"}) {
    fs::create_directories(folder_ / place / "pbrt");
    fs::copy_file(folder_ / "scenes" / "mine.pbrt", folder_ / place / "pbrt" / "scene.pbrt");
  }
  const StudyPlan deep =
      read(study(kRest, R"(["pool/pbrt/scene.pbrt", "stairs/pbrt/scene.pbrt"])"));
  EXPECT_EQ(deep.scenes.at(0).name, "pool/pbrt");
  EXPECT_EQ(deep.scenes.at(1).name, "stairs/pbrt");
  EXPECT_NE(error_of(study(kRest, R"(["scenes/mine.pbrt", "scenes/mine.pbrt"])")).find("twice"),
            std::string::npos);
  // A name that was chosen stays.
  const StudyPlan named =
      read(study(kRest, R"([{"scene": "scenes/mine.pbrt", "name": "mine"}, "other/Mine.pbrt"])"));
  EXPECT_EQ(named.scenes.at(0).name, "mine");
  EXPECT_EQ(named.scenes.at(1).name, "other/Mine");
}

TEST_F(StudyFile, OptionalScenesMayBeAbsent) {
  const StudyPlan plan = read(study(kRest, R"([
      {"scene": ["absent.pbrt", "gone.pbrt"], "optional": true}, "builtin:pool",
      {"scene": "scenes/mine.pbrt", "optional": true}])"));
  ASSERT_EQ(plan.scenes.size(), 2U);
  EXPECT_EQ(plan.scenes.at(0).name, "pool");
  EXPECT_EQ(plan.scenes.at(1).name, "mine");
  ASSERT_EQ(plan.left_out.size(), 1U);
  for (const char* part :
       {"study.json:2:17#/scenes/0/scene: ", "absent.pbrt", "gone.pbrt", "left out"}) {
    EXPECT_NE(plan.left_out.at(0).find(part), std::string::npos) << plan.left_out.at(0);
  }
  EXPECT_NE(error_of(study(kRest, R"([{"scene": "absent.pbrt", "optional": false}])"))
                .find("#/scenes/0/scene: no such scene file"),
            std::string::npos);
}

TEST_F(StudyFile, NamesDoNotDependOnWhichScenesAreThere) {
  fs::create_directories(folder_ / "other");
  const std::string scenes = R"([{"scene": "absent.pbrt", "name": "absent", "optional": true},
      "scenes/mine.pbrt", {"scene": "other/mine.pbrt", "optional": true}])";
  const StudyPlan without = read(study(kRest, scenes));
  fs::copy_file(folder_ / "scenes" / "mine.pbrt", folder_ / "other" / "mine.pbrt");
  const StudyPlan with = read(study(kRest, scenes));
  ASSERT_EQ(without.scenes.size(), 1U);
  ASSERT_EQ(with.scenes.size(), 2U);
  EXPECT_EQ(without.scenes.at(0).name, "scenes/mine");
  EXPECT_EQ(with.scenes.at(0).name, "scenes/mine");
}

TEST_F(StudyFile, AbsentScenesMayHaveAbsentReferences) {
  const StudyPlan plan = read(study(kRest, R"(["builtin:pool",
      {"scene": "absent.pbrt", "reference": "absent.exr", "optional": true}])"));
  EXPECT_EQ(plan.scenes.size(), 1U);
  EXPECT_EQ(plan.left_out.size(), 1U);
}

TEST_F(StudyFile, ASceneMayHaveItsOwnSize) {
  const StudyPlan plan = read(
      study(std::string(kRest) + R"(, "resolution": "64x48", "depth": 5)",
            R"(["builtin:cornell", {"scene": "builtin:pool", "scale": 0.5, "depth": "2:3"}])"));
  EXPECT_EQ(plan.scenes.at(0).options,
            (std::vector<std::string>{"--resolution", "64x48", "--depth", "5"}));
  EXPECT_EQ(plan.scenes.at(1).options,
            (std::vector<std::string>{"--scale", "0.5", "--depth", "2:3"}));
}

TEST_F(StudyFile, ErrorsAreLocatedAndListValidValues) {
  struct Case {
    std::string text;
    std::vector<std::string> parts;
  };
  const std::string rest = kRest;
  const std::string cornell = R"(["builtin:cornell"])";
  const std::vector<Case> cases{
      {"{\n  \"scenes\": [,\n", {":2:14: "}},
      {"{\"scenes\": [\"a\"", {":1:"}},
      {"[]", {":1:1: must be an object"}},
      {"{\"name\": \"a\",\n  \"seeds\": 2,\n  \"name\": \"b\"}",
       {":3:3: the member \"name\" is there twice"}},
      {"{\"name\": " + std::string(64, '['), {"more than 64 deep"}},
      {"{\"scenes\": [\"a\"],\n \"budgets\": [{\"time\": 1e309}]}",
       {":2:23: the number 1e309 is too large; at most 1.7e308"}},
      {study(rest + R"(, "budgetts": 1)"), {":1:135: unknown member \"budgetts\"", "\"budgets\"?"}},
      {study(R"("budgets": [{"spp": 4}])"), {"#/scenes/0: ", "no \"reference\""}},
      {study(rest, R"(["builtin:cornel"])"), {"#/scenes/0: ", "did you mean \"cornell\"?"}},
      {study(rest, R"([{"scene": ["a.pbrt", "b.pbrt"]}])"), {"#/scenes/0/scene: ", "b.pbrt"}},
      {study(rest, R"([{"scen": "builtin:cornell"}])"), {"#/scenes/0: ", "\"scene\"?"}},
      {study(rest, R"([{"scene": "a.pbrt", "optional": 1}])"),
       {"#/scenes/0/optional: ", "true or false"}},
      {study(rest, R"([{"scene": "a.pbrt", "optional": true}])"), {"#/scenes: ", "none", "a.pbrt"}},
      {study(rest, R"(["builtin:pool", {"scene": "a.pbrt", "name": "Pool", "optional": true}])"),
       {"#/scenes: ", "twice"}},
      {study(rest, R"(["builtin:pool", {"scene": "a.pbrt", "depth": "x", "optional": true}])"),
       {"#/scenes/1/depth: "}},
      {study(rest, R"(["builtin:pool",
          {"scene": "a.pbrt", "reference": {"integrator": "ptt", "spp": 1}, "optional": true}])"),
       {"#/scenes/1/reference: ", "did you mean \"pt\"?"}},
      {study(rest, R"(["builtin:cornell", "builtin:cornell"])"), {"#/scenes: ", "twice"}},
      {study(rest, R"([{"scene": "builtin:pool", "name": "a"},
                       {"scene": "builtin:cornell", "name": "A"}])"),
       {"#/scenes: ", "twice"}},
      {study(rest, "[]"), {"#/scenes: ", "at least one"}},
      {study(rest, cornell, R"(["pt", {"integrator": "bdpt", "budgets": [{"spp": 5}]}])"),
       {"#/integrators/1/budgets/0: ", "none of the study's budgets"}},
      {study(rest, cornell, R"(["ptt"])"), {"#/integrators/0: ", "did you mean \"pt\"?"}},
      {study(rest, cornell, R"(["pt", {"integrator": "mmlt", "parameters": {"sigmma": 1}}])"),
       {"#/integrators/1: ", "\"sigma\"?"}},
      {study(rest, cornell, R"([{"integrator": "mmlt", "sweep": {"sigma": [0.1, "x"]}}])"),
       {"#/integrators/0: ", "sigma"}},
      {study(rest, cornell, R"([{"integrator": "mmlt", "sweep": {"sigma": 0.1}}])"),
       {"#/integrators/0/sweep/sigma: ", "array"}},
      {study(rest, cornell, R"([{"integrator": "pt"}, "pt"])"), {"#/integrators: ", "twice"}},
      {study(R"("reference": {"integrator": "pt", "spp": 1}, "budgets": [{"spp": 4, "time": 1}])"),
       {"#/budgets/0: ", "either"}},
      {study(R"("reference": {"integrator": "pt", "spp": 1}, "budgets": [{"spp": 1.5}])"),
       {"#/budgets/0/spp: ", "whole number"}},
      {study(R"("reference": {"integrator": "pt", "spp": 1}, "budgets": [{"time": "soon"}])"),
       {"#/budgets/0/time: ", "2m"}},
      {study(R"("reference": {"integrator": "pt"}, "budgets": [{"spp": 4}])"),
       {"#/reference: ", "\"spp\" or \"time\""}},
      {study(R"("reference": "absent.exr", "budgets": [{"spp": 4}])"),
       {"#/reference: ", "absent.exr"}},
      {study(rest + R"(, "metrics": ["relmse", "flop"])"), {"#/metrics/1: ", "\"flip\"?"}},
      {study(rest + R"(, "metrics": ["relmse"], "efficiency": "mse")"), {"#/efficiency: "}},
      {study(rest + R"(, "baseline": "bdp")"), {"#/baseline: ", "\"bdpt\"?"}},
      {study(rest + R"(, "seeds": 0)"), {"#/seeds: "}},
      {study(rest + R"(, "seeds": [1, 2, 1])"), {"#/seeds/2: ", "twice"}},
      {study(rest + R"(, "resolution": "64")"), {"#/resolution: ", "WIDTHxHEIGHT"}},
      {study(rest + R"(, "threads": -1)"), {"#/threads: "}},
  };
  for (const Case& c : cases) {
    const std::string message = error_of(c.text);
    for (const std::string& part : c.parts) {
      EXPECT_NE(message.find(part), std::string::npos) << c.text << "\nsays " << message;
    }
  }
  EXPECT_THROW(read_study((folder_ / "absent.json").string()), IoError);
}

TEST(ShippedStudies, CanBeRead) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(AJAR_SOURCE_DIR "/studies")) {
    if (entry.path().extension() != ".json") continue;  // scripts that read results
    EXPECT_NO_THROW(read_study(entry.path().string())) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 2);
}

TEST(FileName, KeepsSafeCharacters) {
  EXPECT_EQ(file_name("mmlt sigma=0.01"), "mmlt_sigma=0.01");
  EXPECT_EQ(file_name("../é"), "_._" + std::string("__"));
}

}  // namespace
}  // namespace ajar::study
