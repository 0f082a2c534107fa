#include "support/tiny_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <utility>

#include "imageio/image_encoder.h"
#include "scene/scene.h"
#include "support/render.h"

namespace ajar::test {

Vec3 TinyPicture::mean(float x0, float x1, float y0, float y1) const {
  Vec3 sum(0.F);
  float count = 0.F;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const Vec2 at((static_cast<float>(x) + 0.5F) / static_cast<float>(size.x),
                    (static_cast<float>(y) + 0.5F) / static_cast<float>(size.y));
      if (at.x < x0 || at.x > x1 || at.y < y0 || at.y > y1) continue;
      const std::size_t i = 3 * static_cast<std::size_t>(y * size.x + x);
      sum += Vec3(pixels[i], pixels[i + 1], pixels[i + 2]);
      count += 1.F;
    }
  }
  return sum / count;
}

TinyPicture picture_of(const Import& import, int samples, MayWarn may_warn) {
  Warnings warnings;
  desc::SceneDesc description = import(warnings);
  const float exposure = description.film.scale;
  RenderOptions options;
  options.max_depth = description.hints.max_depth.value_or(options.max_depth);
  const Scene scene(std::move(description), BuildOptions{}, warnings);
  if (may_warn == MayWarn::No) {
    for (const std::string& message : warnings.messages()) ADD_FAILURE() << message;
  }
  options.samples = samples;
  TinyPicture picture{render(scene, options).image(), scene.camera().resolution()};
  for (float& value : picture.pixels) value *= exposure;
  return picture;
}

void expect_color(const Vec3& actual, const Vec3& expected, float relative) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(actual[i], expected[i], relative * expected[i] + 1e-4F) << "lane " << i;
  }
}

void expect_four_colors(const TinyPicture& picture) {
  expect_color(picture.upper_left(), {1, 0, 0});
  expect_color(picture.upper_right(), {0, 1, 0});
  expect_color(picture.lower_left(), {0, 0, 1});
  expect_color(picture.lower_right(), {1, 1, 1});
}

std::string with_quotes(std::string text) {
  std::replace(text.begin(), text.end(), '\'', '"');
  return text;
}

FourColors::FourColors() {
  // Portable float maps begin with the lowest row.
  const float texels[] = {0, 0, 1, 1, 1, 1, 1, 0, 0, 0, 1, 0};
  std::ofstream out(file_.path(), std::ios::binary);
  out << "PF\n2 2\n-1.0\n";
  out.write(reinterpret_cast<const char*>(texels), sizeof(texels));
}

CodedGray::CodedGray(int code) : code_(code) {
  const ImageLayout layout{
      .width = 2, .height = 2, .names = {"R", "G", "B"}, .resolution = {2, 2}, .texts = {}};
  const std::vector<unsigned char> bytes = encode_png(layout, [code](int, unsigned char* row) {
    std::fill_n(row, 6, static_cast<unsigned char>(code));
  });
  std::ofstream out(file_.path(), std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
}

float CodedGray::decoded() const {
  const float v = undecoded();
  return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
}

float normal_reflectance(float n, float k) {
  return ((n - 1.F) * (n - 1.F) + k * k) / ((n + 1.F) * (n + 1.F) + k * k);
}

}  // namespace ajar::test
