#include "apps/viewer/frame.h"

#include <gtest/gtest.h>
#include <half.h>

#include <cstring>

namespace ajar::viewer {
namespace {

Picture picture() {
  Picture picture;
  picture.resolution = {8, 6};
  picture.crop = Box2i(Vec2i(2, 1), Vec2i(4, 2));
  Picture::Layer depth{"depth", 1, {1.F, 3.F, 5.F, 7.F, 9.F, 1e9F}};
  Picture::Layer id{"object-id", 1, {1.F, 3.F, 5.F, 7.F, 9.F, 11.F}};
  picture.layers = {depth, id};
  return picture;
}

std::vector<float> values_of(const std::string& frame, std::size_t count) {
  std::vector<float> values;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint16_t bits = 0;
    std::memcpy(&bits, frame.data() + frame.size() - 2 * (count - i), 2);
    half value;
    value.setBits(bits);
    values.push_back(value);
  }
  return values;
}

TEST(ViewerFrame, HasAHeaderAndHalves) {
  const Picture shown = picture();
  const std::string frame =
      encode_frame(shown, shown.layers[0], {.number = 7, .epoch = 3, .step = 1});
  EXPECT_EQ(frame.size(), 28U + 8U + 12U) << "the name is padded";
  EXPECT_EQ(frame.substr(0, 4), "AJF1");
  EXPECT_EQ(frame.substr(28, 5), "depth");
  std::uint16_t numbers[7];
  std::memcpy(numbers, frame.data() + 12, sizeof(numbers));
  EXPECT_EQ(std::vector<int>(numbers, numbers + 7), (std::vector<int>{8, 6, 2, 1, 3, 2, 1}));
  EXPECT_EQ(values_of(frame, 6), (std::vector<float>{1, 3, 5, 7, 9, 65504}));
}

TEST(ViewerFrame, CoarseFramesAreMeansButOfIds) {
  const Picture shown = picture();
  EXPECT_EQ(values_of(encode_frame(shown, shown.layers[0], {.step = 2}), 2),
            (std::vector<float>{5.F, 65504.F}));
  EXPECT_EQ(values_of(encode_frame(shown, shown.layers[1], {.step = 2}), 2),
            (std::vector<float>{1.F, 5.F}));
}

}  // namespace
}  // namespace ajar::viewer
