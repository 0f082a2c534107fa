#include "study/study_summary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "study/study_output.h"
#include "study/study_table.h"

namespace ajar::study {
namespace {

using Json = nlohmann::ordered_json;

TEST(MeanOf, MatchesValuesByHand) {
  const Mean mean = mean_of(std::vector<double>{1.0, 2.0, 6.0});
  EXPECT_EQ(mean.count, 3U);
  EXPECT_DOUBLE_EQ(mean.mean, 3.0);
  EXPECT_DOUBLE_EQ(mean.deviation, std::sqrt(7.0));
  EXPECT_DOUBLE_EQ(mean.standard_error, std::sqrt(7.0 / 3.0));
  EXPECT_EQ(mean_of(std::vector<double>{5.0}).standard_error, 0.0);
  EXPECT_EQ(mean_of({}).count, 0U);
}

TEST(EfficiencyRatio, MatchesValuesByHand) {
  // Means 3 and 12. The squared standard error of {1, 2, 6} is 7/3, relative to the mean 7/27; four
  // times the values have the same. Equal variances: 4 degrees of freedom, t = 2.776445 (tables),
  // and the variance of the logarithm is 14/27.
  const Ratio ratio = efficiency_ratio(std::vector<double>{1, 2, 6}, std::vector<double>{4, 8, 24});
  EXPECT_DOUBLE_EQ(ratio.value, 4.0);
  const double factor = std::exp(2.776445 * std::sqrt(14.0 / 27.0));
  EXPECT_NEAR(ratio.low.value(), 4.0 / factor, 1e-5);
  EXPECT_NEAR(ratio.high.value(), 4.0 * factor, 1e-4);
}

TEST(EfficiencyRatio, HasNoIntervalFromASingleRun) {
  const Ratio ratio = efficiency_ratio(std::vector<double>{2.0}, std::vector<double>{1.0, 3.0});
  EXPECT_DOUBLE_EQ(ratio.value, 1.0);
  EXPECT_FALSE(ratio.low);
}

TEST(EfficiencyRatio, ItsIntervalCoversTheTruth) {
  // 5 runs a side, gamma distributed with a relative deviation of 30 %, true ratio 2: of 1000
  // intervals 95 % should cover it (σ 0.7 %); the approximation is allowed to be off by three
  // percent.
  std::mt19937 generator(7);
  std::gamma_distribution<double> gamma(1 / 0.09, 0.09);
  int covered = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::vector<double> runs(5);
    std::vector<double> baseline(5);
    for (double& v : runs) v = gamma(generator);
    for (double& v : baseline) v = 2 * gamma(generator);
    const Ratio ratio = efficiency_ratio(runs, baseline);
    covered += *ratio.low <= 2.0 && 2.0 <= *ratio.high ? 1 : 0;
  }
  EXPECT_NEAR(covered, 950, 30);
}

/// A study of one scene and budget with methods "a" (the baseline) and "b", made of numbers.
class Summary : public ::testing::Test {
 protected:
  Summary() {
    plan_.name = "numbers";
    plan_.scenes.push_back({"room", "builtin:cornell", {}, "r.exr", std::nullopt});
    plan_.methods = {{"a", "pt", {}, "a", {}, {}}, {"b, c", "mmlt", {}, "b, c", {}, {}}};
    plan_.budgets = {{std::nullopt, 4}};
    plan_.seeds = {1, 2, 3};
    plan_.metrics = metrics_by_name({"relmse", "psnr"});
    plan_.baseline = "a";
    plan_.efficiency_metric = "relmse";
    result_.references = {"r.exr"};
    result_.noise = {0.05};
    result_.planned = 6;
    const std::vector<double> errors{0.1, 0.2, 0.6};
    for (std::size_t seed = 0; seed < 3; ++seed) {
      add(0, seed, 4 * errors[seed], nullptr);
      add(1, seed, errors[seed],
          {{"small", 0.25},
           {"large", 0.5},
           {"by_depth",
            {{{"mutations", 30}, {"acceptance", 0.2}}, {{"mutations", 10}, {"acceptance", 0.6}}}}});
    }
  }
  /// Half a second each, a tenth of it preparing; loading and building do not count.
  void add(std::size_t method, std::size_t seed, double error, const Json& acceptance) {
    FinishedRun finished;
    finished.run.method = method;
    finished.run.seed = seed + 1;
    finished.run.stem = "out/run";
    finished.record.json = {
        {"metrics", {{"relmse", error}, {"psnr", nullptr}}},
        {"statistics",
         {{"seconds", {{"load", 9.0}, {"build", 9.0}, {"prepare", 0.05}, {"render", 0.45}}},
          {"cpu_seconds", 0.9},
          {"threads", 2},
          {"samples_per_pixel", 4},
          {"acceptance", acceptance}}}};
    result_.runs.push_back(finished);
  }
  StudyPlan plan_;
  StudyResult result_;
};

TEST_F(Summary, MatchesValuesByHand) {
  const std::vector<SummaryRow> rows = summarise(plan_, result_);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_NEAR(rows[0].metrics[0].mean, 1.2, 1e-12);
  EXPECT_NEAR(rows[1].metrics[0].mean, 0.3, 1e-12);
  EXPECT_NEAR(rows[1].metrics[0].standard_error, 0.1 * std::sqrt(7.0 / 3.0), 1e-12);
  EXPECT_EQ(rows[1].metrics[1].count, 0U) << "null is no value";
  EXPECT_NEAR(rows[1].seconds.mean, 0.5, 1e-12);
  EXPECT_FALSE(rows[0].small_acceptance);
  EXPECT_EQ(rows[1].small_acceptance, 0.25);
  EXPECT_FALSE(rows[0].acceptance);
  EXPECT_NEAR(rows[1].acceptance.value(), 0.3, 1e-12) << "each mutation counts, not each depth";
  EXPECT_EQ(rows[0].efficiency->value, 1.0);
  EXPECT_FALSE(rows[0].efficiency->low);
  EXPECT_NEAR(rows[1].efficiency->value, 4.0, 1e-12);
  EXPECT_TRUE(rows[1].efficiency->low);
}

TEST_F(Summary, PutsEstimatedErrorsBesideTrueOnes) {
  const auto set = [&](std::size_t run, double truth, const Json& estimated, bool is_bound) {
    Json& json = result_.runs[run].record.json;
    json["metrics"][kRelativeErrorMetric] = truth;
    json["statistics"]["estimated_relative_error"] = estimated;
    json["statistics"]["estimated_error_is_lower_bound"] = is_bound;
  };
  std::vector<std::size_t> own;
  for (std::size_t i = 0; i < result_.runs.size(); ++i) {
    if (result_.runs[i].run.method == 0) own.push_back(i);
  }
  ASSERT_EQ(own.size(), 3U);
  set(own[0], 0.2, 0.1, false);
  set(own[1], 0.2, 0.3, false);
  set(own[2], 5.0, 0.7, true);
  const SummaryRow row = summarise(plan_, result_).front();
  EXPECT_NEAR(row.estimated_error.mean, 0.2, 1e-12);
  EXPECT_NEAR(row.estimate_ratio.mean, 1.0, 1e-12) << "0.5 and 1.5; what is a bound is no estimate";
  EXPECT_EQ(row.estimate_ratio.count, 2U);
  EXPECT_EQ(row.lower_bounds, 1U);
  const std::vector<std::string> cells = table_cells(plan_, result_, row);
  EXPECT_NE(cells[cells.size() - 2].find("(1.00×) (≥ 1/3)"), std::string::npos)
      << cells[cells.size() - 2];
}

TEST_F(Summary, LeavesOutRowsWithoutRuns) {
  result_.runs.erase(result_.runs.begin());
  std::erase_if(result_.runs, [](const FinishedRun& finished) { return finished.run.method == 0; });
  const std::vector<SummaryRow> rows = summarise(plan_, result_);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_FALSE(rows[0].efficiency) << "there is no baseline";
}

TEST_F(Summary, TablesHaveTheNumbers) {
  const std::vector<SummaryRow> rows = summarise(plan_, result_);
  const std::string markdown = to_markdown(plan_, result_, rows);
  EXPECT_NE(markdown.find("| b, c | 3 | 0.5 ± 0 | 0.9 ± 0 | 4 ± 0 | 0.30 (0.25 / 0.50) | 0.3 ± "
                          "0.15 | - | - (≥ 3/3) | 4 "
                          "["),
            std::string::npos)
      << markdown;
  // 0.05 is more than a tenth of 0.3, but not of 1.2.
  EXPECT_NE(markdown.find("] \\* |"), std::string::npos) << markdown;
  EXPECT_NE(markdown.find("| 1.2 ± 0.61 | - | - (≥ 3/3) | 1 |"), std::string::npos) << markdown;
  const std::string csv = to_csv(plan_, rows);
  EXPECT_NE(
      csv.find("\nroom,\"b, c\",4spp,3,0.5,0,0.9,0,0,4,0,0.3,0.25,0.5,0.3,0.152752523,,,,,,,3,4,"),
      std::string::npos)
      << csv;
  const Json json = to_json(plan_, result_, rows);
  EXPECT_EQ(json.at("summary").at(1).at("method"), "b, c");
  EXPECT_NEAR(json.at("summary").at(1).at("efficiency").at("ratio"), 4.0, 1e-12);
  EXPECT_EQ(json.at("runs").size(), 6U);
  // Every line of the CSV has the same number of cells, but for the quoted comma.
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    const auto commas = std::count(line.begin(), line.end(), ',');
    EXPECT_EQ(commas - (line.find('"') != std::string::npos ? 1 : 0), 25) << line;
  }
}

TEST_F(Summary, RunsThatHadLittleCpuTimeAreMarked) {
  // A render of one second on two threads; the machine has one core more.
  const auto rendered = [&](std::size_t run, double cpu, int threads) -> RunRecord& {
    Json& json = result_.runs[run].record.json;
    json["machine"] = {{"cores", 3}};
    json.at("statistics").at("seconds").at("render") = 1.0;
    json.at("statistics")["cpu_seconds"] = cpu;
    json.at("statistics")["threads"] = threads;
    return result_.runs[run].record;
  };
  EXPECT_FALSE(result_.runs[0].record.cpu_share()) << "too short to tell";
  EXPECT_NEAR(rendered(0, 1.9, 2).cpu_share().value(), 0.95, 1e-12);
  EXPECT_NEAR(rendered(2, 3.0, 6).cpu_share().value(), 1.0, 1e-12) << "of the cores there are";
  EXPECT_NEAR(rendered(4, 1.2, 2).cpu_share().value(), 0.6, 1e-12);
  const std::vector<SummaryRow> rows = summarise(plan_, result_);
  EXPECT_EQ(rows[0].disturbed, 1U);
  EXPECT_EQ(rows[1].disturbed, 0U);
  const std::string markdown = to_markdown(plan_, result_, rows);
  EXPECT_NE(markdown.find("(† 1/3) |"), std::string::npos) << markdown;
  const Json runs = to_json(plan_, result_, rows).at("runs");
  EXPECT_EQ(runs.at(4).at("disturbed"), true);
  EXPECT_EQ(runs.at(4).at("cpu_seconds"), 1.2);
  EXPECT_EQ(runs.at(5).at("disturbed"), false);
}

TEST_F(Summary, NamesAreNeitherMarkupNorFormulas) {
  plan_.name = "<script>alert(1)</script>";
  plan_.scenes[0].name = "a|b\n# c";
  plan_.methods[0].name = plan_.baseline = "=cmd|' /c calc'!A0";
  plan_.methods[1].name = "`x` <img>\x1b[31m";
  result_.warnings = {"![x](http://a)\n| b |"};
  const std::vector<SummaryRow> rows = summarise(plan_, result_);
  const std::string markdown = to_markdown(plan_, result_, rows);
  EXPECT_EQ(markdown.find("<script"), markdown.find("\\<script") + 1) << markdown;
  for (const char* part :
       {"## a\\|b\\\\n\\# c\n", "| =cmd\\|' /c calc'\\!A0 |", "| \\`x\\` \\<img\\>",
        "Warning: \\!\\[x\\](http://a)\\\\n\\| b \\|\n"}) {
    EXPECT_NE(markdown.find(part), std::string::npos) << part << "\n" << markdown;
  }
  EXPECT_EQ(markdown.find('\x1b'), std::string::npos);
  const std::string csv = to_csv(plan_, rows);
  EXPECT_NE(csv.find(",'=cmd|"), std::string::npos) << csv;
}

}  // namespace
}  // namespace ajar::study
