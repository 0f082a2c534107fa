#include "apps/cli/progress_reporter.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace ajar::cli {
namespace {

TEST(ProgressReporter, StyleDependsOnTheTerminalOnlyWhenAutomatic) {
  EXPECT_EQ(progress_style("auto", true), ProgressStyle::Bar);
  EXPECT_EQ(progress_style("auto", false), ProgressStyle::Plain);
  EXPECT_EQ(progress_style("plain", true), ProgressStyle::Plain);
  EXPECT_EQ(progress_style("json", true), ProgressStyle::Json);
  EXPECT_EQ(progress_style("none", true), ProgressStyle::None);
  EXPECT_THROW(progress_style("jsn", true), UsageError);
}

TEST(ProgressReporter, EndsWithALineOfItsOwn) {
  ::testing::internal::CaptureStderr();
  {
    const ProgressReporter reporter(ProgressStyle::Json, [] { return RenderSnapshot(); });
  }
  const std::string text = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(nlohmann::json::parse(text).at("event"), "done");
}

}  // namespace
}  // namespace ajar::cli
