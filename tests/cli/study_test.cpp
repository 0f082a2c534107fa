// `ajar study` as a user runs it.
#include <gtest/gtest.h>
#include <signal.h>

#include <cmath>

#include "cli/cli_fixture.h"

namespace ajar {
namespace {

class StudyCli : public Cli {
 protected:
  /// Two methods, two seeds, `budgets`; pictures of 16x12 pixels.
  void write_study(const std::string& budgets) const {
    std::ofstream(file("study.json"), std::ios::trunc)
        << R"({"scenes": [{"scene": ["absent.pbrt", "builtin:cornell"], "name": "box"}],
               "resolution": "16x12", "depth": 4, "threads": 1,
               "integrators": ["pt", {"integrator": "bdpt", "sweep": {"cull": [0, 0.1]}}],
               "seeds": 2, "metrics": ["relmse", "rmse"],
               "reference": {"integrator": "pt", "spp": 64},
               "budgets": )"
        << budgets << "}";
  }
  fs::path run_file(const std::string& method, const std::string& budget, int seed,
                    const std::string& suffix) const {
    return folder_ / "out" / "runs" / "box" / method / budget /
           ("seed-" + std::to_string(seed) + suffix);
  }
  Outcome study() const { return run({"study", "study.json", "--out", "out"}); }
  json results() const { return json::parse(read_text(folder_ / "out" / "study.json")); }
};

TEST_F(StudyCli, RendersMeasuresAndSummarises) {
  write_study(R"([{"spp": 4}, {"spp": 16}])");
  const Outcome outcome = study();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "study.md")) << outcome.out;
  EXPECT_TRUE(contains(outcome.err, "left)")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, ", relmse ")) << "the first that is listed: " << outcome.err;
  for (const char* name :
       {"study.md", "study.csv", "curves.csv", "curves/box-relmse.svg", "report/box/index.html"}) {
    EXPECT_TRUE(fs::exists(folder_ / "out" / name)) << name;
  }
  const json result = results();
  EXPECT_EQ(result.at("planned"), 12);
  ASSERT_EQ(result.at("runs").size(), 12U);
  ASSERT_EQ(result.at("summary").size(), 6U);
  for (const json& one : result.at("runs")) {
    EXPECT_EQ(one.at("statistics").at("integrator"), one.at("method") == "pt" ? "pt" : "bdpt");
    EXPECT_EQ(one.at("statistics").at("seed"), one.at("seed"));
    EXPECT_NE(one.at("machine").at("processor"), "");
    EXPECT_TRUE(one.at("load_average").is_number());
  }
  // The first row: its mean and error from the two pictures, by `ajar compare`.
  const json row = result.at("summary").at(0);
  const std::string reference = result.at("scenes").at(0).at("reference");
  std::vector<double> errors;
  for (const int seed : {1, 2}) {
    const Outcome compared = run({"compare", reference, run_file("pt", "4spp", seed, ".exr"),
                                  "--metrics", "rmse", "--json"});
    errors.push_back(
        json::parse(compared.out).at("pictures").at(0).at("metrics").at("rmse").get<double>());
  }
  const json& measured = row.at("metrics").at("rmse");
  EXPECT_NEAR(measured.at("mean"), (errors[0] + errors[1]) / 2, 1e-9);
  EXPECT_NEAR(measured.at("standard_error"), std::abs(errors[0] - errors[1]) / 2, 1e-9);
}

TEST_F(StudyCli, ScenesOfEqualFileNamesHaveReportsOfTheirOwn) {
  const std::string scene =
      "Integrator \"path\" \"integer maxdepth\" 99\nWorldBegin\nLightSource \"point\"\nShape "
      "\"sphere\"\n"
      "WorldEnd\n";
  for (const char* name : {"one", "two"}) {
    fs::create_directories(folder_ / name);
    std::ofstream(folder_ / name / "room.pbrt") << scene;
  }
  std::ofstream(file("study.json"), std::ios::trunc)
      << R"({"scenes": ["one/room.pbrt", "two/room.pbrt"], "resolution": "8x8", "threads": 1,
             "integrators": [{"integrator": "pt", "sweep": {"roulette-start": [3, 5]}}],
             "metrics": ["psnr"],
             "budgets": [{"spp": 1}], "reference": {"integrator": "pt", "spp": 4}})";
  const Outcome outcome = study();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const std::string name : {"one", "two"}) {
    const fs::path report = folder_ / "out" / "report" / (name + "_room");
    EXPECT_TRUE(fs::exists(report / "index.html")) << report;
    const std::string script = read_text(report / "data" / "report.js");
    EXPECT_TRUE(contains(script, name + "/room")) << "the scene's name";
    EXPECT_TRUE(contains(read_text(report / "index.html"), ">roulette-start</text>"));
    const std::string plot = name + "_room-roulette-start-psnr.svg";
    EXPECT_TRUE(fs::exists(folder_ / "out" / "sweeps" / plot)) << plot;
  }
}

TEST_F(StudyCli, ReportsSkippedScenes) {
  std::ofstream(file("study.json"), std::ios::trunc)
      << R"({"scenes": ["builtin:cornell", {"scene": "absent.pbrt", "optional": true}],
             "resolution": "8x8", "threads": 1, "metrics": ["psnr"], "integrators": ["pt"],
             "budgets": [{"spp": 1}], "reference": {"integrator": "pt", "spp": 4}})";
  const Outcome outcome = study();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "absent.pbrt; this scene is left out")) << outcome.err;
  EXPECT_TRUE(contains(read_text(folder_ / "out" / "study.md"), "absent.pbrt"));
  EXPECT_EQ(results().at("left_out").size(), 1U);
  const fs::path report = folder_ / "out" / "report" / "cornell" / "data" / "report.js";
  EXPECT_TRUE(contains(read_text(report), "absent.pbrt"));
}

TEST_F(StudyCli, RunsMissingAndChangedRenders) {
  write_study(R"([{"spp": 4}])");
  ASSERT_EQ(study().exit_code, 0);
  const auto written = [&](const std::string& method, int seed) {
    return fs::last_write_time(run_file(method, "4spp", seed, ".exr"));
  };
  const auto kept = written("pt", 1);
  fs::remove(run_file("pt", "4spp", 2, ".exr"));
  std::ofstream(run_file("bdpt_cull=0", "4spp", 1, ".record.json"), std::ios::trunc) << "{\"key";
  // One that has the right key, and nothing else that is right.
  const fs::path other = run_file("bdpt_cull=0.1", "4spp", 1, ".record.json");
  json record = json::parse(read_text(other));
  record.at("statistics").at("seconds") = "none";
  std::ofstream(other, std::ios::trunc) << record;
  const auto broken = written("bdpt_cull=0", 1);
  const Outcome again = study();
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(contains(again.err, "4 of 7 renders are there already")) << again.err;
  EXPECT_EQ(written("pt", 1), kept);
  EXPECT_GT(written("bdpt_cull=0", 1), broken);
  EXPECT_TRUE(fs::exists(run_file("pt", "4spp", 2, ".exr")));
  // Another budget has its own folder; other depths change every run.
  write_study(R"([{"spp": 4}, {"spp": 8}])");
  EXPECT_TRUE(contains(study().err, "7 of 13 renders are there already"));
  std::string text = read_text(file("study.json"));
  text.replace(text.find("\"depth\": 4"), 10, "\"depth\": 3");
  std::ofstream(file("study.json"), std::ios::trunc) << text;
  EXPECT_FALSE(contains(study().err, "there already"));
  EXPECT_GT(written("pt", 1), kept);
}

TEST_F(StudyCli, ControlCKeepsFinishedRuns) {
  write_study(R"([{"spp": 4}, {"time": "1h"}])");
  const pid_t child = start({"study", "study.json", "--out", "out"});
  const fs::path last = run_file("bdpt_cull=0.1", "4spp", 2, ".record.json");
  const fs::path endless = run_file("pt", "3600s", 1, ".log");
  const bool reached = wait_for_file(last) && wait_for_file(endless);
  kill(child, reached ? SIGINT : SIGKILL);
  const Outcome outcome = finish(child);
  ASSERT_TRUE(reached) << outcome.err;
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  const json result = results();
  EXPECT_EQ(result.at("interrupted"), true);
  EXPECT_EQ(result.at("runs").size(), 6U) << "the interrupted render is none of them";
  EXPECT_FALSE(fs::exists(run_file("pt", "3600s", 1, ".record.json")));
  // Also those that come after the one that was interrupted.
  write_study(R"([{"time": "1h"}, {"spp": 4}])");
  fs::remove(endless);
  const pid_t second = start({"study", "study.json", "--out", "out"});
  EXPECT_TRUE(wait_for_file(endless));
  kill(second, SIGTERM);
  EXPECT_EQ(finish(second).exit_code, 130);
  EXPECT_EQ(results().at("runs").size(), 6U);
  write_study(R"([{"spp": 4}, {"spp": 8}])");
  const Outcome again = study();
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(contains(again.err, "7 of 13 renders are there already")) << again.err;
}

TEST_F(StudyCli, AKilledStudyLosesOnlyTheCurrentRender) {
  write_study(R"([{"spp": 4}, {"time": "1h"}])");
  const pid_t child = start({"study", "study.json", "--out", "out"});
  const fs::path endless = run_file("pt", "3600s", 1, ".log");
  EXPECT_TRUE(wait_for_file(endless));
  kill(child, SIGKILL);
  finish(child);
  write_study(R"([{"spp": 4}])");
  const Outcome again = study();
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(contains(again.err, "7 of 7 renders are there already")) << again.err;
}

TEST_F(StudyCli, AFailingRenderDoesNotStopTheOthers) {
  // Only the render itself can find that the map of importance is absent.
  file("study.json", R"({"scenes": ["builtin:cornell"], "resolution": "16x12", "seeds": 2,
      "integrators": ["pt", {"integrator": "selective", "name": "mapped",
                             "parameters": {"importance": "absent.pfm"}}],
      "budgets": [{"spp": 4}], "metrics": ["relmse"],
      "reference": {"integrator": "pt", "spp": 16}})");
  const Outcome outcome = study();
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "cornell, mapped, 4spp, seed 1: ")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "absent.pfm")) << "the reason: " << outcome.err;
  EXPECT_EQ(results().at("runs").size(), 2U);
  EXPECT_EQ(results().at("failures").size(), 2U);
  std::ofstream(folder_ / "absent.pfm", std::ios::binary) << "Pf\n16 12\n-1.0\n"
                                                          << std::string(16 * 12 * 4, '\x3f');
  EXPECT_EQ(study().exit_code, 0);
  EXPECT_EQ(results().at("runs").size(), 4U);
  // Without its reference a scene has no errors: not those against an older one.
  EXPECT_TRUE(results().at("summary").at(0).at("metrics").at("relmse").is_object());
  std::string text = read_text(file("study.json"));
  const std::string made = R"({"integrator": "pt", "spp": 16})";
  text.replace(text.find(made), made.size(), R"({"integrator": "selective", "spp": 16,
      "parameters": {"importance": "nowhere.pfm"}})");
  std::ofstream(file("study.json"), std::ios::trunc) << text;
  EXPECT_EQ(study().exit_code, 1);
  EXPECT_EQ(results().at("runs").size(), 4U);
  EXPECT_TRUE(results().at("summary").at(0).at("metrics").at("relmse").is_null());
}

TEST_F(StudyCli, ReportsErrors) {
  file("wrong.json", R"({"scenes": ["builtin:cornell"], "integrators": ["ptt"],
      "reference": {"integrator": "pt", "spp": 1}})");
  const Outcome wrong = run({"study", "wrong.json", "--out", "out"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(contains(wrong.err, "wrong.json:1:49#/integrators/0: ")) << wrong.err;
  EXPECT_EQ(run({"study", "absent.json"}).exit_code, 4);
  EXPECT_EQ(run({"study"}).exit_code, 2);
  write_study(R"([{"spp": 4}])");
  file("a-file", "in the way");
  EXPECT_EQ(run({"study", "study.json", "--out", "a-file"}).exit_code, 4);
  // A reference of another size.
  ASSERT_EQ(render({"--spp", "1", "-o", "other.exr"}).exit_code, 0);
  std::string text = read_text(file("study.json"));
  const std::string made = R"({"integrator": "pt", "spp": 64})";
  text.replace(text.find(made), made.size(), "\"other.exr\"");
  std::ofstream(file("study.json"), std::ios::trunc) << text;
  const Outcome size = study();
  EXPECT_EQ(size.exit_code, 2) << size.err;
  EXPECT_TRUE(contains(size.err, "24x16")) << size.err;
}

}  // namespace
}  // namespace ajar
