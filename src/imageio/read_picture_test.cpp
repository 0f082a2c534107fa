#include "imageio/read_picture.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "core/error.h"
#include "imageio/image_file.h"

namespace ajar {
namespace {

std::string path_of(const std::string& extension) {
  return (std::filesystem::temp_directory_path() /
          ("ajar_read_picture_" + std::to_string(::getpid()) + extension))
      .string();
}

Picture small_picture() {
  Picture picture;
  picture.resolution = {8, 6};
  picture.crop = Box2i({2, 1}, {3, 1});
  picture.layers.push_back({"", 3, {1, 2, 3, 4, 5, 6}});
  picture.layers.push_back({"albedo", 3, {0, 1, 0, 1, 0, 1}});
  picture.layers.push_back({"depth", 1, {7, 8}});
  picture.layers.push_back({"replicates.0", 3, {9, 9, 9, 9, 9, 9}});
  picture.metadata["ajar:seed"] = "5";
  return picture;
}

TEST(ReadPicture, GivesBackWhatWasWritten) {
  const std::string path = path_of(".exr");
  const Picture written = small_picture();
  write_image(path, written);
  const Picture read = read_picture(path);
  std::filesystem::remove(path);
  EXPECT_EQ(read.resolution, written.resolution);
  EXPECT_EQ(read.crop.min, written.crop.min);
  EXPECT_EQ(read.crop.max, written.crop.max);
  EXPECT_EQ(read.metadata.at("ajar:seed"), "5");
  ASSERT_EQ(read.layers.size(), written.layers.size());
  EXPECT_EQ(read.layers.front().name, "");
  for (const Picture::Layer& layer : written.layers) {
    const auto found = std::find_if(read.layers.begin(), read.layers.end(),
                                    [&](const auto& other) { return other.name == layer.name; });
    ASSERT_NE(found, read.layers.end()) << layer.name;
    EXPECT_EQ(found->channels, layer.channels) << layer.name;
    EXPECT_EQ(found->pixels, layer.pixels) << layer.name;
  }
}

TEST(ReadPicture, TakesTheLayerThatIsThePicture) {
  const std::string path = path_of(".exr");
  Picture picture = small_picture();
  picture.layers = {{"AO", 3, {9, 9, 9, 9, 9, 9}},
                    {"View.Combined", 3, {1, 2, 3, 4, 5, 6}},
                    {"View.Depth.Z", 1, {7, 8}}};
  write_image(path, picture);
  EXPECT_EQ(read_picture(path).layers.front().pixels, (std::vector<float>{1, 2, 3, 4, 5, 6}));
  picture.layers = {{"AO", 3, {9, 9, 9, 9, 9, 9}}, {"diffuse", 3, {1, 2, 3, 4, 5, 6}}};
  write_image(path, picture);
  EXPECT_THROW(read_picture(path), IoError) << "no telling which";
  picture.layers = {{"A", 1, {1, 1}}, {"Y", 1, {3, 4}}};
  write_image(path, picture);
  EXPECT_EQ(read_picture(path).layers.front().pixels, (std::vector<float>{3, 3, 3, 4, 4, 4}));
  std::filesystem::remove(path);
}

TEST(ReadPicture, RefusesDisplayValues) {
  const std::string path = path_of(".png");
  write_image(path, small_picture());
  EXPECT_THROW(read_picture(path), IoError);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace ajar
