#include "apps/cli/render_report.h"

#include <gtest/gtest.h>

namespace ajar::cli {
namespace {

RenderResult result() {
  RenderResult r;
  r.samples_per_pixel = 64;
  r.seconds = 2.0;
  r.counters.rays = 4'000'000;
  r.relative_error = RelativeError{.value = 0.034};
  return r;
}

TEST(EndText, HasAllNumbers) {
  EXPECT_EQ(end_text(result(), 0.0, std::nullopt),
            "64 samples per pixel in 0:02, 2 M rays/s, estimated error 3.4 %");
  EXPECT_EQ(end_text(result(), 1.24, 0.012),
            "64 samples per pixel in 0:02, 2 M rays/s, after 1.2 s of preparing, estimated error "
            "3.4 %, denoised 1.2 %");
}

TEST(EndText, SaysWhenTheErrorIsUnknown) {
  RenderResult r = result();
  r.relative_error.reset();
  EXPECT_TRUE(end_text(r, 0.0, std::nullopt).ends_with("rays/s, error unknown"))
      << end_text(r, 0.0, std::nullopt);
}

TEST(EndText, SaysOfBothErrorsThatTheyAreLowerBounds) {
  RenderResult r = result();
  r.relative_error->misses_light = true;
  EXPECT_TRUE(end_text(r, 0.0, 0.012)
                  .ends_with("estimated error ≥ 3.4 % (without the light that this method cannot "
                             "see), denoised ≥ 1.2 %"))
      << end_text(r, 0.0, 0.012);
}

}  // namespace
}  // namespace ajar::cli
