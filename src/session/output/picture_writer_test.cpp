#include "session/output/picture_writer.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "image/filter.h"
#include "imageio/image_file.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 640;
constexpr int kHeight = 480;

float value_at(std::size_t i) { return 0.5F + 0.5F * std::sin(static_cast<float>(i)); }

/// With a second layer, as large as real ones: memory of this size goes back to the system at once.
Picture made_picture(const Film& /*film*/, const JobState& /*state*/) {
  Picture picture;
  picture.resolution = {kWidth, kHeight};
  picture.crop = Box2i({0, 0}, {kWidth - 1, kHeight - 1});
  for (const char* name : {"", "albedo"}) {
    Picture::Layer layer{name, 3, std::vector<float>(std::size_t{3} * kWidth * kHeight)};
    for (std::size_t i = 0; i < layer.pixels.size(); ++i) layer.pixels[i] = value_at(i);
    picture.layers.push_back(std::move(layer));
  }
  return picture;
}

TEST(PictureWriter, WritesThePixelsThatWereDeveloped) {
  const fs::path folder =
      fs::temp_directory_path() / ("ajar-picture-writer-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const std::vector<std::string> paths = {folder / "a.exr", folder / "a.pfm", folder / "a.png"};
  InterruptCount requests{0};
  std::string said;
  const auto say = [&said](const std::string& text) { said += text + "\n"; };
  PictureWriter writer(paths, 1e9, &requests, {}, made_picture, say, say);
  const Film film({1, 1}, Box2i({0, 0}, {0, 0}), Filter::box(), 1, {{.name = "direct"}});
  EXPECT_FALSE(writer.wants_picture({}));
  for (int round = 0; round < 3; ++round) {
    ++requests;
    ASSERT_TRUE(writer.wants_picture({}));
    writer.see_picture(film, {});
    for (const std::string& path : {paths[0], paths[1]}) {
      const Image image = read_image(path);
      ASSERT_EQ(image.width, kWidth);
      for (const char* layer : {"", "albedo"}) {
        const std::vector<float> pixels = image.rgb(layer);
        if (path == paths[1] && *layer != '\0') continue;
        ASSERT_EQ(pixels.size(), std::size_t{3} * kWidth * kHeight);
        for (std::size_t i = 0; i < pixels.size(); ++i) ASSERT_EQ(pixels[i], value_at(i)) << i;
      }
    }
    const Image shown = read_image(paths[2]);
    for (std::size_t i = 0; i < shown.data.size(); ++i) {
      ASSERT_NEAR(shown.data[i], tone_map(value_at(i), ToneMap::Srgb, 0.F), 0.003F) << i;
    }
  }
  EXPECT_EQ(said.find("tried again"), std::string::npos) << said;
  fs::remove_all(folder);
}

TEST(PictureWriter, ExposesEachPictureByItselfIfAskedTo) {
  const fs::path folder =
      fs::temp_directory_path() / ("ajar-picture-exposure-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const std::string path = folder / "a.png";
  InterruptCount requests{0};
  float light = 0.F;
  const auto grey = [&light](const Film&, const JobState&) {
    Picture picture;
    picture.resolution = {4, 4};
    picture.crop = Box2i({0, 0}, {3, 3});
    picture.layers.push_back({"", 3, std::vector<float>(48, light)});
    return picture;
  };
  const auto say = [](const std::string&) {};
  const Display display{ToneMap::Srgb, {.automatic = true}};
  PictureWriter writer({path}, 1e9, &requests, display, grey, say, say);
  const Film film({1, 1}, Box2i({0, 0}, {0, 0}), Filter::box(), 1, {{.name = "direct"}});
  for (const float value : {0.002F, 18.F}) {
    light = value;
    ++requests;
    writer.see_picture(film, {});
    EXPECT_NEAR(read_image(path).data.front(), srgb_from_linear(0.18F), 0.02F) << value;
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace ajar
