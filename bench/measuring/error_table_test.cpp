#include "measuring/error_table.h"

#include <gtest/gtest.h>

namespace ajar::bench {
namespace {

TEST(ErrorTable, ErrorsAreScaledToTheTimeAskedForAfterTheFloorIsTaken) {
  Reference reference;
  reference.picture.assign(3, 1.F);
  reference.floor = {0.01, 0.02};
  // Error 0.25/1.01 of each value, in 12 seconds where 8 were asked for.
  const Measurement run = measure(std::vector<float>(3, 1.5F), 7, 12.0, reference, 8.0);
  EXPECT_EQ(run.samples, 7U);
  EXPECT_EQ(run.cpu_seconds, 12.0);
  EXPECT_NEAR(run.plain, 1.5 * (0.25 / 1.01 - 0.01), 1e-12);
  EXPECT_NEAR(run.trimmed, 1.5 * (0.25 / 1.01 - 0.02), 1e-12);
}

TEST(ErrorTable, HasMeansAndRatiosWithTheirRange) {
  const std::vector<VariantMeasurements> variants = {
      {"pt", {{10, 8.0, 0.5, 0.2}, {20, 9.0, 0.7, 0.4}}},
      {"bdpt", {{4, 8.0, 0.1, 0.1}, {6, 8.0, 0.1, 0.1}}},
      {"interrupted", {}},
  };
  EXPECT_EQ(error_table(variants, 8.0),
            "| variant | samples per pixel | CPU-seconds | relMSE trimmed @8 s | relMSE @8 s | "
            "ratio to the first |\n"
            "|---|---|---|---|---|---|\n"
            "| pt | 15 | 8.5 | 0.3 | 0.6 | 1 (1–1) |\n"
            "| bdpt | 5 | 8.0 | 0.1 | 0.1 | 0.333 (0.25–0.5) |\n");
}

TEST(ErrorTable, HasNoRatioToNoError) {
  const std::vector<VariantMeasurements> variants = {{"pt", {{1, 1.0, 0.0, 0.0}}}};
  EXPECT_NE(error_table(variants, 1.0).find("| – |"), std::string::npos);
}

}  // namespace
}  // namespace ajar::bench
