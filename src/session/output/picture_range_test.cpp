#include "session/output/picture_range.h"

#include <gtest/gtest.h>

namespace ajar {
namespace {

const Vec2i kRangeSize(2, 1);

/// A film whose first pixel has this much light, and what is wrong with its picture.
std::string complaint_of(float light, double film_scale) {
  Film film(kRangeSize, Box2i(Vec2i(0, 0), kRangeSize - Vec2i(1, 1)), Filter::box(), 1,
            {LayerSpec{.name = "direct", .magnitude = light > 0.F ? double{light} : 1.0},
             LayerSpec{.name = "indirect"}});
  film.add(0, 0, Vec2i(0, 0), Spectrum(light));
  Development scales;
  scales.whole = {1.0, 1.0};
  const auto complaint =
      range_complaint(film, develop(film, scales, 1, film_scale, {}), film_scale);
  return complaint ? complaint->message : "";
}

TEST(PictureRange, IsFineForWhatFloatsHold) {
  for (const float light : {1e-30F, 1e-3F, 1.F, 1e36F}) EXPECT_EQ(complaint_of(light, 1.0), "");
  EXPECT_EQ(complaint_of(1e-30F, 1e30), "");
}

TEST(PictureRange, TellsOfBlackPictures) {
  EXPECT_NE(complaint_of(0.F, 1.0).find("no path has found light"), std::string::npos);
  EXPECT_EQ(complaint_of(1.F, 0.0), "") << "the scene is warned of that";
}

TEST(PictureRange, TellsOfWhatIsTooBright) {
  EXPECT_NE(complaint_of(1e20F, 1e20).find("3 of 6 values of the picture are infinite"),
            std::string::npos);
}

TEST(PictureRange, TellsOfWhatIsTooDimBeforeOrAfterTheScale) {
  for (const auto& [light, scale] : {std::pair(1e-40F, 1.0), std::pair(1e-20F, 1e-20),
                                     std::pair(1e-30F, 1e-30), std::pair(1e-38F, 1e38)}) {
    EXPECT_NE(complaint_of(light, scale).find("so dim that floats lose its digits"),
              std::string::npos)
        << light << " times " << scale;
  }
}

}  // namespace
}  // namespace ajar
