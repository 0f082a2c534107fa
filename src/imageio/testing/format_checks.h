#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"
#include "imageio/formats/image_formats.h"
#include "imageio/image_encoder.h"
#include "imageio/testing/image_writers.h"

/// Checks of decoders: the pixels of a file against those that were written.
namespace ajar::testing {

class ImageFormats : public ::testing::Test {
 protected:
  ImageFormats()
      : folder_(std::filesystem::temp_directory_path() /
                ("ajar_small_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string written(const std::string& name, const std::string& bytes) const {
    write_bytes(path(name), bytes);
    return path(name);
  }
  std::string written(const std::string& name, const std::vector<unsigned char>& bytes) const {
    return written(name, std::string(bytes.begin(), bytes.end()));
  }

 private:
  std::filesystem::path folder_;
};

struct Pixels {
  ImageHeader header;
  std::vector<unsigned char> stored;
  std::vector<float> floats;
};

template <typename T>
std::vector<T> values(ImageDecoder& decoder, SampleType type, std::size_t size) {
  const ImageHeader& header = decoder.header();
  const std::size_t row =
      static_cast<std::size_t>(header.width) * header.names.size() * size / sizeof(T);
  std::vector<T> all(row * static_cast<std::size_t>(header.height));
  const int rows = decoder.block_height();
  for (int y = 0; y < header.height; y += rows) {
    decoder.read_rows(y, std::min(rows, header.height - y), 0, header.channels, type,
                      all.data() + row * static_cast<std::size_t>(y));
  }
  return all;
}

inline Pixels pixels_of(std::unique_ptr<ImageDecoder> decoder) {
  const SampleType type = decoder->header().type;
  Pixels pixels{decoder->header(), values<unsigned char>(*decoder, type, size_of(type)), {}};
  // From the top again.
  pixels.floats = values<float>(*decoder, SampleType::Float, sizeof(float));
  return pixels;
}

inline Pixels pixels_of(const std::string& path, bool has_unassociated_alpha = true) {
  return pixels_of(open_image(path, has_unassociated_alpha));
}

inline std::string error_of(const std::string& path) {
  try {
    pixels_of(path);
  } catch (const IoError& error) {
    return error.what();
  }
  return "no error";
}

/// To the bit, stored and as floats.
template <typename T>
void expect_pixels(const std::string& path, const TestImage<T>& image) {
  const Pixels read = pixels_of(path);
  EXPECT_EQ(read.header.width, image.width) << path;
  EXPECT_EQ(read.header.height, image.height) << path;
  EXPECT_EQ(read.header.type, sample_type_of<T>()) << path;
  EXPECT_EQ(read.header.is_integer, std::is_integral_v<T>) << path;
  ASSERT_EQ(read.header.channels, image.channels) << path;
  const std::vector<std::string> names = image.channels < 3
                                             ? std::vector<std::string>{"Y", "A"}
                                             : std::vector<std::string>{"R", "G", "B", "A"};
  EXPECT_TRUE(std::equal(read.header.names.begin(), read.header.names.end(), names.begin()))
      << path;
  EXPECT_EQ(read.header.alpha_channel, image.channels % 2 == 0 ? image.channels - 1 : -1) << path;
  ASSERT_EQ(read.stored.size(), image.values.size() * sizeof(T)) << path;
  EXPECT_EQ(std::memcmp(read.stored.data(), image.values.data(), read.stored.size()), 0) << path;
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    float expected = static_cast<float>(image.values[i]);
    if constexpr (std::is_integral_v<T>) expected *= 1.F / static_cast<float>(static_cast<T>(-1));
    ASSERT_EQ(read.floats[i], expected) << path << ", value " << i;
  }
}

inline constexpr int kWidth = 37;
inline constexpr int kHeight = 90;  // more than a strip

inline ImageLayout layout_of(std::vector<std::string> names) {
  ImageLayout layout{kWidth, kHeight, std::move(names), {5, 3}, {50, 100}, {{"ajar:seed", "7"}}};
  return layout;
}

/// Some bright, some dark, with rows that repeat themselves.
inline float value_at(int x, int y, std::size_t channel) {
  if (y % 5 == 0) return 0.25F;
  return std::exp(6.F * std::sin(static_cast<float>(x * 7 + y * 3) + static_cast<float>(channel)));
}

template <typename T>
TestImage<T> image_of(int channels) {
  TestImage<T> image{kWidth, kHeight, channels, {}};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
        const float value = value_at(x, y, c);
        if constexpr (std::is_integral_v<T>) {
          image.values.push_back(static_cast<T>(std::min(value / 4.F, 1.F) * static_cast<T>(-1)));
        } else {
          image.values.push_back(static_cast<T>(value));
        }
      }
    }
  }
  return image;
}

template <typename T>
RowSource<T> rows_of(const TestImage<T>& image) {
  return [&image](int y, T* row) { std::copy_n(image.at(0, y), image.row(), row); };
}

}  // namespace ajar::testing
