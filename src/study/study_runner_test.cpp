#include "study/study_runner.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "imageio/image_file.h"

namespace ajar::study {
namespace {

namespace fs = std::filesystem;

/// Instead of `ajar`: copies a picture and claims to have rendered for a second on one thread, with
/// the CPU time that is in the next line of a file.
constexpr const char* kProgram = R"(#!/bin/sh
while [ $# -gt 0 ]; do
  case "$1" in
    --stats) statistics="$2" ;;
    -o) picture="$2" ;;
  esac
  shift
done
echo "$picture" >> calls
cpu=$(sed -n "$(wc -l < calls)p" cpu)
cp reference.exr "$picture"
echo "{\"threads\": 1, \"cpu_seconds\": $cpu, \"seconds\": {\"prepare\": 0, \"render\": 1}}" > "$statistics"
)";

class StudyRunner : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              ("ajar-study-runner-" + std::string(test->name()) + "-" + std::to_string(getpid()));
    fs::create_directories(folder_);
    std::ofstream(folder_ / "program") << kProgram;
    fs::permissions(folder_ / "program", fs::perms::owner_all);
    Picture picture;
    picture.resolution = {2, 1};
    picture.crop = Box2i({0, 0}, {1, 0});
    picture.layers.push_back({"", 3, std::vector<float>(6, 0.5F)});
    const std::string reference = folder_ / "reference.exr";
    write_image(reference, picture);
    plan_.name = "cornell";
    plan_.scenes.push_back({"cornell", "builtin:cornell", {}, reference, std::nullopt});
    plan_.methods = {{"pt", "pt", {}, "pt", {}, {}}};
    plan_.budgets = {{std::nullopt, 4}};
    plan_.seeds = {1, 2};
    plan_.metrics = metrics_by_name({"relmse"});
    plan_.baseline = "pt";
    plan_.efficiency_metric = "relmse";
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// CPU seconds of the renders, one after the other.
  StudyResult run(const std::string& cpu) {
    std::ofstream(folder_ / "cpu") << cpu;
    StudyOptions options;
    options.folder = folder_;
    options.out = folder_ / "out";
    options.program = folder_ / "program";
    options.report = [this](const std::string& text) { said_ += text + "\n"; };
    return run_study(plan_, options);
  }
  std::size_t calls() const {
    std::ifstream file(folder_ / "calls");
    std::size_t count = 0;
    for (std::string line; std::getline(file, line);) ++count;
    return count;
  }

  fs::path folder_;
  StudyPlan plan_;
  std::string said_;
};

TEST_F(StudyRunner, RepeatsARunThatHadLittleCpuTime) {
  const StudyResult result = run("0.3\n0.9\n0.95\n");
  ASSERT_EQ(result.runs.size(), 2U);
  EXPECT_EQ(calls(), 3U) << said_;
  EXPECT_EQ(result.runs[0].record.number("cpu_seconds"), 0.9) << "of the second attempt";
  EXPECT_EQ(result.runs[0].record.json.at("attempt"), 2);
  EXPECT_EQ(result.runs[1].record.json.at("attempt"), 1);
  EXPECT_TRUE(result.warnings.empty()) << result.warnings.front();
  EXPECT_NE(said_.find("30 % of its CPU time"), std::string::npos) << said_;
  EXPECT_NE(said_.find("1 s, 0.9 s of CPU, relmse"), std::string::npos) << said_;
}

TEST_F(StudyRunner, MarksARunThatHadLittleCpuTimeTwice) {
  const StudyResult result = run("0.3\n0.5\n0.95\n");
  ASSERT_EQ(result.runs.size(), 2U);
  EXPECT_EQ(calls(), 3U) << said_;
  EXPECT_TRUE(result.runs[0].record.is_disturbed());
  EXPECT_FALSE(result.runs[1].record.is_disturbed());
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_EQ(result.warnings[0].find("1 of 2 renders had less than 75 % of their CPU time"), 0U)
      << result.warnings[0];
  // The run counts as finished.
  EXPECT_EQ(run("").warnings.size(), 1U);
  EXPECT_EQ(calls(), 3U);
}

}  // namespace
}  // namespace ajar::study
