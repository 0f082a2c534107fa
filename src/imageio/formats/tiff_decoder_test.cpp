#include <gtest/gtest.h>

#include "imageio/image_input.h"
#include "imageio/testing/format_checks.h"

namespace ajar {
namespace {

using namespace testing;

template <typename T>
void expect_every_kind_of_tiff(const std::string& file) {
  for (const int channels : {1, 2, 3, 4}) {
    const TestImage<T> image = image_of<T>(channels);
    for (const int compression :
         {COMPRESSION_NONE, COMPRESSION_PACKBITS, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE}) {
      for (const int tile : {0, 16, 128}) {
        for (const bool has_planes : {false, true}) {
          for (const char* mode : {"w", "wb", "w8"}) {
            SCOPED_TRACE(::testing::Message() << channels << " channels of " << sizeof(T)
                                              << ", compression " << compression << ", tiles "
                                              << tile << (has_planes ? ", planes " : " ") << mode);
            write_tiff(
                file, image,
                {.compression = compression, .tile = tile, .has_planes = has_planes, .mode = mode});
            expect_pixels(file, image);
          }
        }
      }
    }
  }
}

TEST_F(ImageFormats, ReadEveryKindOfTiff) {
  expect_every_kind_of_tiff<std::uint8_t>(path("a.tif"));
  expect_every_kind_of_tiff<std::uint16_t>(path("a.tif"));
  expect_every_kind_of_tiff<Imath::half>(path("a.tif"));
  expect_every_kind_of_tiff<float>(path("a.tif"));
}

TEST_F(ImageFormats, TiffMayHaveOneStripForAll) {
  const TestImage<std::uint16_t> image = image_of<std::uint16_t>(3);
  for (const bool has_planes : {false, true}) {
    write_tiff(path("a.tif"), image,
               {.compression = COMPRESSION_LZW, .has_planes = has_planes, .rows_per_strip = 4000});
    expect_pixels(path("a.tif"), image);
  }
}

TEST_F(ImageFormats, SamplesOfTiffThatAreNoAlphaAreChannels) {
  const TestImage<std::uint8_t> image = image_of<std::uint8_t>(6);
  write_tiff(path("a.tif"), image,
             {.extra_samples = {EXTRASAMPLE_UNSPECIFIED, EXTRASAMPLE_UNASSALPHA,
                                EXTRASAMPLE_UNSPECIFIED}});
  const Pixels read = pixels_of(path("a.tif"));
  EXPECT_EQ(read.header.names,
            (std::vector<std::string>{"R", "G", "B", "channel3", "A", "channel5"}));
  EXPECT_EQ(read.header.alpha_channel, 4);
  EXPECT_EQ(read.stored, image.values);
}

TEST_F(ImageFormats, TiffOfOtherColoursBecomesRgbOrGrey) {
  const auto expect_near = [&](const std::vector<int>& expected, int furthest) {
    const Pixels read = pixels_of(path("a.tif"));
    EXPECT_EQ(read.header.channels, static_cast<int>(expected.size()));
    ASSERT_EQ(read.stored.size(), 2 * expected.size());
    for (std::size_t i = 0; i < read.stored.size(); ++i) {
      EXPECT_NEAR(read.stored[i], expected[i % expected.size()], furthest) << i;
    }
  };
  write_tiff(path("a.tif"), TestImage<std::uint8_t>{2, 1, 1, {5, 5}},
             {.colors = PHOTOMETRIC_MINISWHITE});
  expect_near({250}, 0);
  write_tiff(path("a.tif"), TestImage<std::uint8_t>{2, 1, 4, {51, 102, 0, 51, 51, 102, 0, 51}},
             {.colors = PHOTOMETRIC_SEPARATED});
  expect_near({163, 122, 204}, 1);
  const TestImage<std::uint8_t> index{2, 1, 1, {3, 3}};
  TIFF* tiff = open_tiff_of(path("a.tif"), index, {.colors = PHOTOMETRIC_PALETTE});
  std::vector<std::uint16_t> red(256);
  std::vector<std::uint16_t> green(256);
  std::vector<std::uint16_t> blue(256);
  red[3] = 10 * 257;
  green[3] = 20 * 257;
  blue[3] = 30 * 257;
  TIFFSetField(tiff, TIFFTAG_COLORMAP, red.data(), green.data(), blue.data());
  std::uint8_t row[] = {3, 3};
  TIFFWriteScanline(tiff, row, 0, 0);
  TIFFClose(tiff);
  expect_near({10, 20, 30}, 0);
  tiff = open_tiff_of(path("a.tif"), index, {}, 1);
  row[0] = 0xff;
  TIFFWriteScanline(tiff, row, 0, 0);
  TIFFClose(tiff);
  expect_near({255}, 0);
  TestImage<std::uint8_t> flat{16, 16, 3, {}};
  for (int i = 0; i < 16 * 16; ++i) flat.values.insert(flat.values.end(), {200, 100, 50});
  write_tiff(path("a.tif"), flat, {.compression = COMPRESSION_JPEG, .colors = PHOTOMETRIC_YCBCR});
  const Pixels read = pixels_of(path("a.tif"));
  ASSERT_EQ(read.stored.size(), flat.values.size());
  for (std::size_t i = 0; i < read.stored.size(); ++i) {
    ASSERT_NEAR(read.stored[i], flat.values[i], 3) << i;
  }
}

TEST_F(ImageFormats, TiffOfOtherNumbersSaysSo) {
  for (const auto& [name, image] : {std::pair("a.tif", TestImage<std::uint32_t>{1, 1, 1, {7}}),
                                    {"b.tif", {1, 1, 3, {7, 8, 9}}}}) {
    write_tiff(path(name), image);
    EXPECT_NE(error_of(path(name)).find("samples of 32 bits"), std::string::npos)
        << error_of(path(name));
  }
  write_tiff(path("a.tif"), TestImage<double>{1, 1, 1, {7}});
  EXPECT_NE(error_of(path("a.tif")).find("samples of 64 bits"), std::string::npos);
}

}  // namespace
}  // namespace ajar
