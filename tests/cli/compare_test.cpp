// `ajar compare` as a user runs it.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "cli/cli_fixture.h"
#include "imageio/image_file.h"
#include "post/display.h"

namespace ajar {
namespace {

/// A uniform picture, its last pixel of another value.
void write_picture(const fs::path& path, Vec2i size, float value, float last) {
  const Box2i crop({0, 0}, size - Vec2i(1, 1));
  std::vector<float> pixels(static_cast<std::size_t>(size.x * size.y) * 3, value);
  pixels.back() = last;
  const Picture picture{size, crop, {{"", 3, pixels}}, {}};
  write_image(path.string(), is_display_file(path.string()) ? displayed(picture, {}) : picture);
}

class CompareCli : public Cli {
 protected:
  /// Two pictures of 16x12 pixels that differ by 0.1 everywhere.
  void SetUp() override {
    Cli::SetUp();
    write_picture(file("reference.exr"), {16, 12}, 0.5F, 0.5F);
    write_picture(file("brighter.exr"), {16, 12}, 0.6F, 0.6F);
  }
};

TEST_F(CompareCli, PrintsATableAndItsLegend) {
  const Outcome outcome = run({"compare", "reference.exr", "brighter.exr", "reference.exr"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* part : {"brighter.exr", "relmse-trimmed", "67.02 pixels per degree", "exposures",
                           "r^2 + 0.01", "not tested for bias"}) {
    EXPECT_TRUE(contains(outcome.out, part)) << part << " in\n" << outcome.out;
  }
  std::istringstream lines(outcome.out);
  std::vector<std::size_t> columns;
  for (std::string line; std::getline(lines, line);) {
    for (const char* part :
         {"reference.exr", "0  mean of (a - r)^2 [radiance^2]", "0  mean of |a - r| ["}) {
      const std::size_t found = line.find(part);
      if (found == std::string::npos || line.starts_with("reference")) continue;
      columns.push_back(line.starts_with("metric") ? found + 12 : found);
    }
  }
  EXPECT_EQ(columns, std::vector<std::size_t>(3, columns.at(0))) << "columns are aligned";
}

TEST_F(CompareCli, ComputesItsMetrics) {
  const Outcome outcome = run({"compare", "reference.exr", "brighter.exr", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  const json& values = result.at("pictures").at(0).at("metrics");
  EXPECT_NEAR(values.at("mse"), 0.01, 1e-7);
  EXPECT_NEAR(values.at("rmse"), 0.1, 1e-6);
  EXPECT_NEAR(values.at("mae"), 0.1, 1e-6);
  EXPECT_NEAR(values.at("relmse"), 0.01 / 0.26, 1e-6);
  EXPECT_NEAR(values.at("smape"), 0.1 / 1.11, 1e-6);
  const auto encoded = [](double v) { return 1.055 * std::pow(v, 1 / 2.4) - 0.055; };
  EXPECT_NEAR(values.at("psnr"), -20 * std::log10(encoded(0.6) - encoded(0.5)), 1e-3);
  EXPECT_GT(values.at("flip"), 0.1);
  EXPECT_EQ(result.at("conditions").at("relmse_epsilon"), 0.01);
  EXPECT_EQ(result.at("resolution"), (json{16, 12}));
}

TEST_F(CompareCli, ComputesTheNamedMetrics) {
  const Outcome outcome =
      run({"compare", "reference.exr", "brighter.exr", "--metrics", "flip,mse", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out).at("pictures").at(0).at("metrics").size(), 2U);
  const Outcome wrong = run({"compare", "reference.exr", "brighter.exr", "--metrics", "flop"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(contains(wrong.err, "did you mean \"flip\"")) << wrong.err;
  EXPECT_TRUE(contains(wrong.err, "relmse-trimmed")) << wrong.err;
}

TEST_F(CompareCli, ReadsEveryFormatAndWarnsOfDisplayValues) {
  for (const char* name : {"same.pfm", "same.hdr", "same.png", "same.jpg"}) {
    write_picture(file(name), {16, 12}, 0.5F, 0.5F);
  }
  const Outcome outcome = run({"compare", "reference.exr", "same.pfm", "same.hdr", "same.png",
                               "same.jpg", "--metrics", "rmse", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  for (const json& picture : result.at("pictures")) {
    EXPECT_LT(picture.at("metrics").at("rmse"), 0.003) << picture;
  }
  EXPECT_EQ(result.at("warnings").size(), 2U) << result.at("warnings");
  EXPECT_TRUE(contains(outcome.err, "same.png holds display values")) << outcome.err;
}

TEST_F(CompareCli, RefusesPicturesThatDoNotFit) {
  write_picture(file("small.exr"), {15, 12}, 0.5F, 0.5F);
  const Outcome small = run({"compare", "reference.exr", "small.exr"});
  EXPECT_EQ(small.exit_code, 2);
  EXPECT_TRUE(contains(small.err, "15x12")) << small.err;
  EXPECT_TRUE(contains(small.err, "16x12")) << small.err;

  write_picture(file("broken.exr"), {16, 12}, 0.5F, std::nanf(""));
  const Outcome broken = run({"compare", "reference.exr", "broken.exr"});
  EXPECT_EQ(broken.exit_code, 2);
  EXPECT_TRUE(contains(broken.err, "1 of 192 pixels")) << broken.err;
  EXPECT_TRUE(contains(broken.err, "15,11")) << broken.err;
  EXPECT_EQ(run({"compare", "broken.exr", "reference.exr"}).exit_code, 2);

  EXPECT_EQ(run({"compare", "reference.exr"}).exit_code, 2);
  EXPECT_EQ(run({"compare", "reference.exr", "brighter.exr", "--ppd", "0"}).exit_code, 2);
}

TEST_F(CompareCli, ReportsUnreadableFiles) {
  EXPECT_EQ(run({"compare", "absent.exr", "brighter.exr"}).exit_code, 4);
  EXPECT_EQ(run({"compare", "reference.exr", "absent.exr"}).exit_code, 4);
  file("text.exr", "no picture");
  EXPECT_EQ(run({"compare", "reference.exr", "text.exr"}).exit_code, 4);
}

TEST_F(CompareCli, ABlackReferenceIsMeasuredWithAWarning) {
  write_picture(file("black.exr"), {16, 12}, 0.F, 0.F);
  const Outcome outcome = run({"compare", "black.exr", "reference.exr", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "is black")) << outcome.err;
  const json values = json::parse(outcome.out).at("pictures").at(0).at("metrics");
  EXPECT_NEAR(values.at("relmse"), 0.25 / 0.01, 1e-4);
  EXPECT_TRUE(values.at("hdr-flip").is_null());
}

TEST_F(CompareCli, TestsRendersForBias) {
  const auto render_to = [&](const char* path, const char* spp, const char* seed) {
    return render({"--spp", spp, "--seed", seed, "--aov", "replicates", "-o", path}).exit_code;
  };
  ASSERT_EQ(render_to("many.exr", "256", "1"), 0);
  ASSERT_EQ(render_to("few.exr", "16", "2"), 0);
  const json same = json::parse(run({"compare", "many.exr", "few.exr", "--json"}).out);
  const json bias = same.at("pictures").at(0).at("bias");
  EXPECT_EQ(bias.at("differs"), false) << bias;
  EXPECT_EQ(bias.at("picture_error"), "replicates");
  EXPECT_GT(bias.at("power").at("detectable_mean"), 0.0);
  // Without indirect light the picture is darker by far more than the power that is stated.
  ASSERT_EQ(
      render({"--spp", "16", "--depth", "2", "--aov", "replicates", "-o", "direct.exr"}).exit_code,
      0);
  const json other = json::parse(run({"compare", "many.exr", "direct.exr", "--json"}).out);
  const json found = other.at("pictures").at(0).at("bias");
  EXPECT_EQ(found.at("differs"), true) << found;
  EXPECT_LT(found.at("mean").at("relative_difference"), 0.0);
}

TEST_F(CompareCli, WritesAReport) {
  ASSERT_EQ(render({"--spp", "1", "--aov", "albedo,replicates", "-o", "render.exr"}).exit_code, 0);
  const Outcome outcome =
      run({"compare", "render.exr", "render.exr", "--json", "--report", "report"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "report/index.html")) << outcome.err;
  EXPECT_TRUE(json::accept(outcome.out)) << "the report's place is no part of the result";
  EXPECT_TRUE(fs::exists(file("report/index.html")));
  const std::string data = read_text(file("report/data/report.js"));
  for (const char* part : {"\"albedo\"", "\"integrator\"", "relmse-trimmed", "Tests for bias"}) {
    EXPECT_TRUE(contains(data, part)) << part;
  }
  EXPECT_FALSE(contains(data, "replicates.0"));
  // Again: an earlier report is replaced.
  EXPECT_EQ(run({"compare", "reference.exr", "brighter.exr", "--report", "report"}).exit_code, 0);
  EXPECT_FALSE(contains(read_text(file("report/data/report.js")), "albedo"));
}

TEST_F(CompareCli, ReportsUnwritableReports) {
  const auto compare_to = [&](const std::string& folder) {
    return run({"compare", "reference.exr", "brighter.exr", "--report", folder});
  };
  const Outcome absent = compare_to("absent/report");
  EXPECT_EQ(absent.exit_code, 4);
  EXPECT_TRUE(contains(absent.err, "there is no folder")) << absent.err;
  const Outcome others = compare_to(".");
  EXPECT_EQ(others.exit_code, 4);
  EXPECT_TRUE(contains(others.err, "no part of a report")) << others.err;
  EXPECT_EQ(compare_to("reference.exr").exit_code, 4);
  EXPECT_TRUE(fs::is_regular_file(file("reference.exr"))) << "nothing else was touched";
}

}  // namespace
}  // namespace ajar
