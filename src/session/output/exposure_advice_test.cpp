#include "session/output/exposure_advice.h"

#include <gtest/gtest.h>

namespace ajar {
namespace {

constexpr int kPixels = 100;

/// A row of grey pixels: `lamp` of them as bright as a lamp, the others of one value.
Picture row(int lamp, float value) {
  Picture picture;
  picture.resolution = {kPixels, 1};
  picture.crop = Box2i({0, 0}, {kPixels - 1, 0});
  std::vector<float> rgb(std::size_t{3} * kPixels, value);
  std::fill_n(rgb.begin(), 3 * lamp, 1e4F);
  picture.layers.push_back({"", 3, std::move(rgb)});
  return picture;
}

TEST(ExposureAdvice, SaysWhatWouldHelpAWhitePicture) {
  const Picture bright = row(0, 0.18F * 32.F);
  EXPECT_EQ(exposure_advice(bright, {}), "100 % of the picture is white: try --exposure -5");
  EXPECT_EQ(exposure_advice(bright, {ToneMap::Srgb, -5.F}), "") << "as advised";
  // The advised exposure is absolute, not relative to the current one.
  EXPECT_EQ(exposure_advice(row(0, 0.18F), {ToneMap::Srgb, 4.F}),
            "100 % of the picture is white: try --exposure 0");
}

TEST(ExposureAdvice, SaysWhatWouldHelpABlackPicture) {
  EXPECT_EQ(exposure_advice(row(0, 0.18F / 256.F), {}),
            "100 % of the picture is black: try --exposure +8");
  EXPECT_EQ(exposure_advice(row(0, 0.F), {}), "") << "no exposure helps where there is no light";
}

TEST(ExposureAdvice, SaysNothingOfLampsAndHighlights) {
  for (const int lamp : {1, 5, 20}) EXPECT_EQ(exposure_advice(row(lamp, 0.18F), {}), "") << lamp;
  EXPECT_EQ(exposure_advice(row(8, 0.F), {ToneMap::Srgb, -16.F}), "") << "a lamp at night";
}

TEST(ExposureAdvice, StopsAreWrittenAsTheOptionTakesThem) {
  EXPECT_EQ(stops_text(-2.5F), "-2.5");
  EXPECT_EQ(stops_text(4.F), "+4");
  EXPECT_EQ(stops_text(-0.F), "0");
  EXPECT_EQ(stops_text(-2.3F), "-2.3");
}

}  // namespace
}  // namespace ajar
