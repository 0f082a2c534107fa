#include "study/study_plots.h"

#include <gtest/gtest.h>

namespace ajar::study {
namespace {

/// A plain method and a sweep of two parameters, one of which has names for values.
StudyPlan plan_of_sweep() {
  StudyPlan plan;
  plan.scenes.push_back({"room", "builtin:cornell", {}, "r.exr", std::nullopt});
  plan.budgets = {{std::nullopt, 4}, {2.0, std::nullopt}};
  plan.metrics = metrics_by_name({"relmse", "psnr"});
  plan.baseline = "plain";
  plan.methods.push_back({"plain", "mmlt", {}, "plain", {}, {}});
  for (const char* mutation : {"gaussian", "kelemen"}) {
    for (const char* sigma : {"0.1", "0.01"}) {
      const std::map<std::string, std::string> swept{{"sigma", sigma}, {"mutation", mutation}};
      plan.methods.push_back(
          {"swept " + std::to_string(plan.methods.size()), "mmlt", {}, "swept", swept, {"4spp"}});
    }
  }
  return plan;
}

/// Both metrics of method m are m + 1.
SummaryRow row(std::size_t method, std::size_t budget) {
  SummaryRow row;
  row.method = method;
  row.budget = budget;
  const auto value = static_cast<double>(method + 1);
  row.metrics = {{2, value, 0.5, 0.35}, {2, value, 0.5, 0.35}};
  return row;
}

TEST(StudyPlots, HaveACurvePerOtherValueAndTheBaselineAsALevel) {
  const StudyPlan plan = plan_of_sweep();
  const std::vector<SummaryRow> rows{row(0, 0), row(1, 0), row(2, 0),
                                     row(3, 0), row(4, 0), row(0, 1)};
  const std::vector<LogPlot> plots = scene_plots(plan, rows, 0);
  ASSERT_EQ(plots.size(), 3U)
      << "errors over time, sigma for each metric; the mutations have no place on an axis";
  EXPECT_EQ(plots[2].title, "room, 4spp");
  EXPECT_EQ(plots[2].x_label, "sigma");
  EXPECT_EQ(plots[2].y_label, "psnr [dB]");
  EXPECT_EQ(plots[2].file, "sweeps/room-sigma-psnr.svg");
  const std::vector<PlotCurve>& curves = plots[1].curves;
  ASSERT_EQ(curves.size(), 3U);
  EXPECT_EQ(curves[0].name, "swept mutation=gaussian");
  EXPECT_EQ(curves[1].name, "swept mutation=kelemen");
  ASSERT_EQ(curves[1].points.size(), 2U);
  EXPECT_EQ(curves[1].points[0].x, 0.1);
  EXPECT_EQ(curves[1].points[0].y, 4.0);
  EXPECT_EQ(curves[1].points[0].low, 3.5) << "a standard deviation";
  EXPECT_EQ(curves[1].points[1].y, 5.0);
  EXPECT_EQ(curves[2].name, "plain");
  ASSERT_EQ(curves[2].points.size(), 2U);
  EXPECT_EQ(curves[2].points[0].x, 0.01);
  EXPECT_EQ(curves[2].points[1].x, 0.1);
  EXPECT_EQ(curves[2].points[1].y, 1.0);
}

TEST(StudyPlots, CurvesOfSeveralBudgetsAreNamed) {
  StudyPlan plan = plan_of_sweep();
  for (Method& method : plan.methods) method.budgets.clear();
  const std::vector<LogPlot> plots =
      scene_plots(plan, {row(1, 0), row(2, 0), row(1, 1), row(2, 1), row(0, 1)}, 0);
  ASSERT_EQ(plots.size(), 3U);
  EXPECT_EQ(plots[1].title, "room");
  ASSERT_EQ(plots[1].curves.size(), 3U);
  EXPECT_EQ(plots[1].curves[0].name, "swept mutation=gaussian, 2s");
  EXPECT_EQ(plots[1].curves[1].name, "swept mutation=gaussian, 4spp");
  EXPECT_EQ(plots[1].curves[2].name, "plain, 2s");
}

TEST(StudyPlots, OneValueIsNoSweepAndASweepWithASingleBudgetIsNotOverTime) {
  const std::vector<LogPlot> plots =
      scene_plots(plan_of_sweep(), {row(0, 0), row(1, 0), row(3, 0)}, 0);
  ASSERT_EQ(plots.size(), 1U);
  EXPECT_EQ(plots[0].file, "curves/room-relmse.svg");
  ASSERT_EQ(plots[0].curves.size(), 1U);
  EXPECT_EQ(plots[0].curves[0].name, "plain");
}

TEST(StudyPlots, ANameHasOneStyleInAllPlots) {
  const std::vector<LogPlot> plots =
      scene_plots(plan_of_sweep(), {row(0, 0), row(1, 0), row(2, 0)}, 0);
  ASSERT_EQ(plots.size(), 3U);
  EXPECT_EQ(plots[0].curves[0].name, plots[1].curves[1].name);
  EXPECT_EQ(plots[0].curves[0].style, plots[1].curves[1].style);
  EXPECT_NE(plots[1].curves[0].style, plots[1].curves[1].style);
}

}  // namespace
}  // namespace ajar::study
