#include "imageio/formats/image_formats.h"

#include <ImfInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "core/error.h"
#include "imageio/formats/jpeg_library.h"
#include "imageio/image_encoder.h"
#include "imageio/image_input.h"
#include "imageio/testing/image_writers.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_HDR
#define STBI_ONLY_JPEG
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

// Held against stb_image, which decodes PNG, JPEG and HDR by itself; against OpenEXR's own simpler
// interface; and against pixels that the tests write.
namespace ajar {
namespace {

namespace fs = std::filesystem;
using namespace testing;

class ImageFormats : public ::testing::Test {
 protected:
  ImageFormats()
      : folder_(fs::temp_directory_path() / ("ajar_small_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string written(const std::string& name, const std::string& bytes) const {
    write_bytes(path(name), bytes);
    return path(name);
  }
  std::string written(const std::string& name, const std::vector<unsigned char>& bytes) const {
    return written(name, std::string(bytes.begin(), bytes.end()));
  }

 private:
  fs::path folder_;
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

Pixels pixels_of(std::unique_ptr<ImageDecoder> decoder) {
  const SampleType type = decoder->header().type;
  Pixels pixels{decoder->header(), values<unsigned char>(*decoder, type, size_of(type)), {}};
  // From the top again.
  pixels.floats = values<float>(*decoder, SampleType::Float, sizeof(float));
  return pixels;
}

Pixels pixels_of(const std::string& path, bool has_unassociated_alpha = true) {
  return pixels_of(open_image(path, has_unassociated_alpha));
}

std::string error_of(const std::string& path) {
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

constexpr int kWidth = 37;
constexpr int kHeight = 90;  // more than a strip

ImageLayout layout_of(std::vector<std::string> names) {
  ImageLayout layout{kWidth, kHeight, std::move(names), {5, 3}, {50, 100}, {{"ajar:seed", "7"}}};
  return layout;
}

/// Some bright, some dark, with rows that repeat themselves.
float value_at(int x, int y, std::size_t channel) {
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

/// Pixels of the same file as stb_image decodes it; empty if it cannot read it.
template <typename T>
TestImage<T> read_by_stb(const std::string& path, int channels) {
  TestImage<T> image{0, 0, channels, {}};
  int stored = 0;
  T* values = nullptr;
  if constexpr (std::is_same_v<T, float>) {
    values = stbi_loadf(path.c_str(), &image.width, &image.height, &stored, channels);
  } else if constexpr (std::is_same_v<T, std::uint16_t>) {
    values = stbi_load_16(path.c_str(), &image.width, &image.height, &stored, channels);
  } else {
    values = stbi_load(path.c_str(), &image.width, &image.height, &stored, channels);
  }
  if (values == nullptr) return image;
  EXPECT_EQ(stored, channels) << path;
  image.values.assign(values, values + image.row() * static_cast<std::size_t>(image.height));
  stbi_image_free(values);
  return image;
}

template <typename T>
void expect_as_stb(const std::string& path) {
  expect_pixels(path, read_by_stb<T>(path, open_image(path, true)->header().channels));
}

/// Decoders may round the cosine transform, and the colours that are between those of the file, as
/// they like: nearly all values agree within a level or two.
void expect_nearly_as_stb(const std::string& path, int furthest) {
  const Pixels ours = pixels_of(path);
  const TestImage<std::uint8_t> theirs = read_by_stb<std::uint8_t>(path, ours.header.channels);
  ASSERT_EQ(ours.stored.size(), theirs.values.size()) << path;
  int largest = 0;
  for (std::size_t i = 0; i < ours.stored.size(); ++i) {
    largest = std::max(largest, std::abs(ours.stored[i] - theirs.values[i]));
  }
  EXPECT_LE(largest, furthest) << path;
}

/// Writes a JPEG of one, three or, for printing, four channels.
std::string jpeg_of(const std::string& path, const TestImage<std::uint8_t>& image,
                    J_COLOR_SPACE colors, J_COLOR_SPACE stored, bool is_progressive,
                    bool is_subsampled, bool has_adobe_marker = true) {
  jpeg_error_mgr errors{};
  jpeg_compress_struct codec{};
  codec.err = jpeg_std_error(&errors);
  jpeg_create_compress(&codec);
  std::FILE* file = std::fopen(path.c_str(), "wb");
  jpeg_stdio_dest(&codec, file);
  codec.image_width = static_cast<JDIMENSION>(image.width);
  codec.image_height = static_cast<JDIMENSION>(image.height);
  codec.input_components = image.channels;
  codec.in_color_space = colors;
  jpeg_set_defaults(&codec);
  jpeg_set_colorspace(&codec, stored);
  codec.write_Adobe_marker = has_adobe_marker ? TRUE : FALSE;
  jpeg_set_quality(&codec, 100, TRUE);
  if (is_progressive) jpeg_simple_progression(&codec);
  if (!is_subsampled) codec.comp_info[0].h_samp_factor = codec.comp_info[0].v_samp_factor = 1;
  jpeg_start_compress(&codec, TRUE);
  for (int y = 0; y < image.height; ++y) {
    JSAMPROW row = const_cast<JSAMPROW>(image.at(0, y));
    jpeg_write_scanlines(&codec, &row, 1);
  }
  jpeg_finish_compress(&codec);
  jpeg_destroy_compress(&codec);
  std::fclose(file);
  return path;
}

TEST_F(ImageFormats, ReadJpegNearlyAsStbDoes) {
  const TestImage<std::uint8_t> gray = image_of<std::uint8_t>(1);
  const TestImage<std::uint8_t> rgb = image_of<std::uint8_t>(3);
  for (const bool is_progressive : {false, true}) {
    expect_nearly_as_stb(
        jpeg_of(path("gray.jpg"), gray, JCS_GRAYSCALE, JCS_GRAYSCALE, is_progressive, false), 1);
    expect_nearly_as_stb(jpeg_of(path("full.jpg"), rgb, JCS_RGB, JCS_YCbCr, is_progressive, false),
                         2);
    expect_nearly_as_stb(
        jpeg_of(path("quarter.jpg"), rgb, JCS_RGB, JCS_YCbCr, is_progressive, true), 4);
  }
}

TEST_F(ImageFormats, JpegForPrintingBecomesWhatInksLeaveOfWhite) {
  // Cyan 51, magenta 102, yellow 0, black 0 of 255.
  for (const bool is_of_adobe : {false, true}) {
    const std::uint8_t flip = is_of_adobe ? 255 : 0;
    TestImage<std::uint8_t> inks{16, 16, 4, {}};
    for (int i = 0; i < 16 * 16; ++i) {
      for (const int ink : {51, 102, 0, 51}) {
        inks.values.push_back(static_cast<std::uint8_t>(ink ^ flip));
      }
    }
    for (const J_COLOR_SPACE stored : {JCS_CMYK, JCS_YCCK}) {
      if (stored == JCS_YCCK && !is_of_adobe) continue;  // its marker alone says so
      const Pixels read =
          pixels_of(jpeg_of(path("inks.jpg"), inks, JCS_CMYK, stored, false, false, is_of_adobe));
      ASSERT_EQ(read.header.names, (std::vector<std::string>{"R", "G", "B"}));
      EXPECT_NEAR(read.stored[0], 204 * 0.8, 2) << is_of_adobe << stored;
      EXPECT_NEAR(read.stored[1], 153 * 0.8, 2) << is_of_adobe << stored;
      EXPECT_NEAR(read.stored[2], 255 * 0.8, 2) << is_of_adobe << stored;
      EXPECT_EQ(read.stored.size(), 16U * 16U * 3U);
    }
  }
}

TEST_F(ImageFormats, ReadExrAsItWasWritten) {
  for (const int tile : {0, 16}) {
    for (const int channels : {1, 2, 3}) {
      write_exr(path("a.exr"), image_of<float>(channels), Imf::ZIP_COMPRESSION, tile);
      const Pixels read = pixels_of(path("a.exr"));
      EXPECT_EQ(read.floats, image_of<float>(channels).values) << tile << channels;
    }
    const TestImage<Imath::half> image = image_of<Imath::half>(4);
    write_exr(path("half.exr"), image, Imf::PIZ_COMPRESSION, tile);
    expect_pixels(path("half.exr"), image);
    // As its own simpler interface does.
    Imf::RgbaInputFile file(path("half.exr").c_str());
    std::vector<Imf::Rgba> pixels(kWidth * kHeight);
    file.setFrameBuffer(pixels.data(), 1, kWidth);
    file.readPixels(0, kHeight - 1);
    const Pixels read = pixels_of(path("half.exr"));
    EXPECT_EQ(std::memcmp(pixels.data(), read.stored.data(), read.stored.size()), 0);
  }
  // Red, green and blue first, whatever the alphabet says.
  write_exr(path("a.exr"), image_of<float>(4), Imf::ZIP_COMPRESSION, 16, {0, 0},
            {"R", "G", "B", "depth"});
  const Pixels read = pixels_of(path("a.exr"));
  EXPECT_EQ(read.header.names, (std::vector<std::string>{"R", "G", "B", "depth"}));
  EXPECT_EQ(read.header.alpha_channel, -1);
  EXPECT_EQ(read.floats, image_of<float>(4).values);
}

TEST_F(ImageFormats, WriteWhatOthersRead) {
  const ImageLayout layers =
      layout_of({"R", "G", "B", "albedo.R", "albedo.G", "albedo.B", "depth"});
  const TestImage<float> values = image_of<float>(7);
  const std::string exr = written("a.exr", encode_exr(layers, rows_of(values)));
  EXPECT_EQ(open_image(exr, false)->header().texts.at("ajar:seed"), "7");
  Imf::InputFile file(exr.c_str());
  const Imath::V2i last(4 + kWidth, 2 + kHeight);
  EXPECT_EQ(file.header().dataWindow(), Imath::Box2i({5, 3}, last));
  EXPECT_EQ(file.header().displayWindow(), Imath::Box2i({0, 0}, {49, 99}));
  TestImage<float> read{kWidth, kHeight, 7, std::vector<float>(values.values.size())};
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < 7; ++c) {
    buffer.insert(layers.names[c], Imf::Slice::Make(Imf::FLOAT, read.values.data() + c, {5, 3},
                                                    kWidth, kHeight, 28, 28 * kWidth));
  }
  file.setFrameBuffer(buffer);
  file.readPixels(3, last.y);
  EXPECT_EQ(read.values, values.values);

  const ImageLayout colors = layout_of({"R", "G", "B"});
  const TestImage<std::uint8_t> rgb = image_of<std::uint8_t>(3);
  expect_pixels(written("a.png", encode_png(colors, rows_of(rgb))), rgb);
  EXPECT_EQ(read_by_stb<std::uint8_t>(path("a.png"), 3).values, rgb.values);
  const TestImage<std::uint8_t> rgba = image_of<std::uint8_t>(4);
  written("b.png", encode_png(layout_of({"R", "G", "B", "A"}), rows_of(rgba)));
  EXPECT_EQ(read_by_stb<std::uint8_t>(path("b.png"), 4).values, rgba.values);

  const TestImage<float> bright = image_of<float>(3);
  expect_as_stb<float>(written("a.hdr", encode_hdr(colors, rows_of(bright))));
  const TestImage<float> hdr = read_by_stb<float>(path("a.hdr"), 3);
  for (std::size_t i = 0; i < hdr.values.size(); ++i) {
    const std::size_t pixel = i / 3 * 3;
    const float largest =
        std::max({bright.values[pixel], bright.values[pixel + 1], bright.values[pixel + 2]});
    ASSERT_NEAR(hdr.values[i], bright.values[i], largest / 128.F) << i;
  }

  TestImage<std::uint8_t> smooth{kWidth, kHeight, 3, {}};
  for (int i = 0; i < kWidth * kHeight * 3; ++i) {
    smooth.values.push_back(static_cast<std::uint8_t>(i / (kWidth * 3) * 2 + i % 3 * 30));
  }
  expect_nearly_as_stb(written("a.jpg", encode_jpeg(colors, rows_of(smooth))), 4);
  const TestImage<std::uint8_t> jpeg = read_by_stb<std::uint8_t>(path("a.jpg"), 3);
  for (std::size_t i = 0; i < jpeg.values.size(); ++i) {
    ASSERT_NEAR(jpeg.values[i], smooth.values[i], 4) << i;
  }
}

/// Writes any kind of PNG: a palette of four colours, grey of a few bits, a colour that is
/// transparent, rows in seven parts.
std::string png_kind_of(const std::string& path, int type, int bits, bool interlaced,
                        bool transparent) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_set_IHDR(png, info, kWidth, kHeight, bits, type,
               interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  const png_color palette[4] = {{255, 0, 0}, {0, 200, 0}, {0, 0, 99}, {7, 8, 9}};
  if (type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 4);
  const png_byte alphas[2] = {0, 128};
  png_color_16 gone{};
  gone.gray = 1;
  if (transparent) {
    const bool in_palette = type == PNG_COLOR_TYPE_PALETTE;
    png_set_tRNS(png, info, in_palette ? alphas : nullptr, in_palette ? 2 : 0,
                 in_palette ? nullptr : &gone);
  }
  png_write_info(png, info);
  const std::size_t row = png_get_rowbytes(png, info);
  std::vector<unsigned char> bytes(row * kHeight);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<unsigned char>(
        type == PNG_COLOR_TYPE_PALETTE && bits == 8 ? i % 4 : i * i % 251);
  }
  std::vector<unsigned char*> rows;
  for (std::size_t y = 0; y < kHeight; ++y) rows.push_back(bytes.data() + y * row);
  png_write_image(png, rows.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  std::fclose(file);
  return path;
}

TEST_F(ImageFormats, ReadEveryKindOfPng) {
  struct Kind {
    int type, bits;
    bool transparent;
  };
  int number = 0;
  for (const bool interlaced : {false, true}) {
    for (const Kind& kind : {Kind{PNG_COLOR_TYPE_GRAY, 1, false},
                             {PNG_COLOR_TYPE_GRAY, 4, false},
                             {PNG_COLOR_TYPE_GRAY, 16, false},
                             {PNG_COLOR_TYPE_GRAY, 8, true},
                             {PNG_COLOR_TYPE_GRAY_ALPHA, 8, false},
                             {PNG_COLOR_TYPE_PALETTE, 2, false},
                             {PNG_COLOR_TYPE_PALETTE, 8, true},
                             {PNG_COLOR_TYPE_RGB, 8, false},
                             {PNG_COLOR_TYPE_RGB_ALPHA, 8, false},
                             {PNG_COLOR_TYPE_RGB_ALPHA, 16, false}}) {
      SCOPED_TRACE(::testing::Message() << "type " << kind.type << ", bits " << kind.bits
                                        << (interlaced ? ", interlaced" : ""));
      const std::string file = png_kind_of(path(std::to_string(number++) + ".png"), kind.type,
                                           kind.bits, interlaced, kind.transparent);
      if (kind.bits == 16) {
        expect_as_stb<std::uint16_t>(file);
      } else {
        expect_as_stb<std::uint8_t>(file);
      }
    }
  }
}

TEST_F(ImageFormats, MultiplyWithAlphaUnlessTold) {
  const TestImage<std::uint8_t> image = image_of<std::uint8_t>(4);
  write_png(path("a.png"), image);
  write_webp(path("a.webp"), image);
  write_bytes(path("a.bmp"), bmp_bytes(image));
  write_bytes(path("a.tga"), tga_bytes(image, true, true));
  write_tiff(path("a.tif"), image, {.extra_samples = {EXTRASAMPLE_UNASSALPHA}});
  for (const std::string name : {"a.png", "a.webp", "a.bmp", "a.tga", "a.tif"}) {
    const Pixels with = pixels_of(path(name), false);
    const Pixels without = pixels_of(path(name), true);
    // WebP drops the colours of transparent pixels.
    if (name != "a.webp") {
      EXPECT_EQ(without.stored, image.values) << name;
    }
    for (std::size_t i = 0; i < with.floats.size(); ++i) {
      const float alpha = without.floats[i / 4 * 4 + 3];
      const float expected = without.floats[i] * (i % 4 == 3 ? 1.F : alpha);
      ASSERT_NEAR(with.floats[i], expected, 0.51F / 255.F) << name << i;
    }
  }
  write_tiff(path("b.tif"), image, {.extra_samples = {EXTRASAMPLE_ASSOCALPHA}});
  EXPECT_EQ(pixels_of(path("b.tif"), false).stored, image.values) << "it is multiplied already";
}

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

TEST_F(ImageFormats, ReadWebpAsItWasWritten) {
  const TestImage<std::uint8_t> image = image_of<std::uint8_t>(3);
  write_webp(path("a.webp"), image);
  expect_pixels(path("a.webp"), image);
  unsigned char* bytes = nullptr;
  TestImage<std::uint8_t> flat{16, 16, 3, std::vector<std::uint8_t>(16 * 16 * 3, 100)};
  const std::size_t size = WebPEncodeRGB(flat.values.data(), 16, 16, 48, 90.F, &bytes);
  written("lossy.webp", std::vector<unsigned char>(bytes, bytes + size));
  WebPFree(bytes);
  EXPECT_NEAR(pixels_of(path("lossy.webp")).stored.at(333), 100, 2);
}

TEST_F(ImageFormats, ReadPgmAndPpmAsTheyWereWritten) {
  for (const int channels : {1, 3}) {
    const std::string start = (channels == 1 ? "P5" : "P6") + std::string("\n# a remark\n37 90\n");
    const TestImage<std::uint8_t> image = image_of<std::uint8_t>(channels);
    expect_pixels(
        written("a.ppm", start + "255\n" + std::string(image.values.begin(), image.values.end())),
        image);
    const TestImage<std::uint16_t> finer = image_of<std::uint16_t>(channels);
    std::string pixels;
    for (const std::uint16_t value : finer.values) {
      pixels += {static_cast<char>(value >> 8U), static_cast<char>(value)};
    }
    expect_pixels(written("b.ppm", start + "65535\n" + pixels), finer);
  }
  EXPECT_EQ(error_of(written("a.ppm", "P6 1 1 31\n123")),
            "the image is damaged (its largest value is not 255 or 65535)");
}

TEST_F(ImageFormats, ReadBmpAndTargaAsTheyWereWritten) {
  for (const int channels : {1, 3, 4}) {
    const TestImage<std::uint8_t> image = image_of<std::uint8_t>(channels);
    if (channels > 1) expect_pixels(written("a.bmp", bmp_bytes(image)), image);
    for (const bool in_runs : {false, true}) {
      for (const bool from_top : {false, true}) {
        SCOPED_TRACE(::testing::Message() << channels << in_runs << from_top);
        expect_pixels(written("a.tga", tga_bytes(image, in_runs, from_top)), image);
        // Its only sign is what it says.
        expect_pixels(written("unnamed", tga_bytes(image, in_runs, from_top)), image);
      }
    }
  }
  // Two colours of a palette, by a bit and by a byte.
  const std::string palette("\x1e\x14\x0a\0\x3c\x32\x28\0", 8);
  const auto bmp = [&](int bits, const std::string& row) {
    return "BM" + little_endian(0, 8) + little_endian(62, 4) + little_endian(40, 4) +
           little_endian(2, 4) + little_endian(1, 4) + little_endian(1, 2) +
           little_endian(static_cast<std::uint64_t>(bits), 2) + std::string(16, '\0') +
           little_endian(2, 4) + little_endian(0, 4) + palette + row;
  };
  const TestImage<std::uint8_t> two{2, 1, 3, {40, 50, 60, 10, 20, 30}};
  expect_pixels(written("a.bmp", bmp(1, std::string("\x80\0\0\0", 4))), two);
  expect_pixels(written("a.bmp", bmp(8, std::string("\1\0\0\0", 4))), two);
  const std::string tga = little_endian(0, 1) + little_endian(1, 1) + little_endian(1, 1) +
                          little_endian(0, 2) + little_endian(2, 2) + little_endian(24, 1) +
                          little_endian(0, 4) + little_endian(2, 2) + little_endian(1, 2) +
                          little_endian(8, 1) + little_endian(0x20, 1);
  expect_pixels(written("a.tga", tga + std::string("\x1e\x14\x0a\x3c\x32\x28\1\0", 8)), two);
}

TEST_F(ImageFormats, AgreeOnImagesOfTheFuzzersOrRefuseThem) {
  std::size_t agreed = 0;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(fs::path(AJAR_SOURCE_DIR) / "fuzz/corpus/image")) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::string image = written("image", bytes);
    SCOPED_TRACE(entry.path());
    std::unique_ptr<ImageDecoder> decoder;
    try {
      decoder = open_image(image, true);
      pixels_of(image);
    } catch (const std::exception&) {
      continue;
    }
    const int channels = decoder->header().channels;
    if (bytes.starts_with("\x89PNG") && decoder->header().type == SampleType::UInt8) {
      expect_as_stb<std::uint8_t>(image);
    } else if (bytes.starts_with("\xff\xd8") &&
               !read_by_stb<std::uint8_t>(image, channels).values.empty()) {
      expect_nearly_as_stb(image, 4);
    } else if (bytes.starts_with("#?")) {
      expect_as_stb<float>(image);
    } else {
      continue;
    }
    ++agreed;
  }
  EXPECT_GT(agreed, 2U);
}

TEST_F(ImageFormats, RefuseWhatIsCutOff) {
  const ImageLayout layout = layout_of({"R", "G", "B"});
  const TestImage<float> floats = image_of<float>(3);
  TestImage<std::uint8_t> noise = image_of<std::uint8_t>(3);
  for (std::size_t i = 0; i < noise.values.size(); ++i) {
    noise.values[i] = static_cast<std::uint8_t>(i * i * 31 >> 3U);
  }
  write_tiff(path("a.tif"), noise, {.compression = COMPRESSION_LZW});
  write_webp(path("a.webp"), noise);
  const auto content = [&](const std::string& name) {
    std::ifstream file(path(name), std::ios::binary);
    return std::vector<unsigned char>{std::istreambuf_iterator<char>(file),
                                      std::istreambuf_iterator<char>()};
  };
  const auto bytes_of = [](const std::string& text) {
    return std::vector<unsigned char>(text.begin(), text.end());
  };
  const std::pair<const char*, std::vector<unsigned char>> files[] = {
      {"cut.exr", encode_exr(layout, rows_of(floats))},
      {"cut.hdr", encode_hdr(layout, rows_of(floats))},
      {"cut.pfm", encode_pfm(layout, rows_of(floats))},
      {"cut.png", encode_png(layout, rows_of(noise))},
      {"cut.jpg", encode_jpeg(layout, rows_of(noise))},
      {"cut.tif", content("a.tif")},
      {"cut.webp", content("a.webp")},
      {"cut.bmp", bytes_of(bmp_bytes(noise))},
      {"cut.tga", bytes_of(tga_bytes(noise, false, true))},
      {"runs.tga", bytes_of(tga_bytes(noise, true, false))},
      {"cut.ppm",
       bytes_of("P6 37 90 255\n" + std::string(noise.values.begin(), noise.values.end()))}};
  for (const auto& [name, bytes] : files) {
    for (const std::size_t size : {std::size_t{12}, bytes.size() / 3, bytes.size() / 2,
                                   bytes.size() * 3 / 4, bytes.size() - 20}) {
      const std::string file =
          written(name, std::vector<unsigned char>(
                            bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)));
      // As ImageInput takes it: any exception of the libraries.
      EXPECT_THROW(pixels_of(file), std::exception) << name << " cut to " << size;
    }
  }
}

/// Their errors leave them by long jumps, ours never pass through them.
TEST_F(ImageFormats, TurnErrorsOfTheLibrariesIntoExceptions) {
  const auto message_of = [](const auto& action) -> std::string {
    try {
      action();
    } catch (const std::exception& error) {
      return error.what();
    }
    return {};
  };
  ImageLayout layout = layout_of({"R", "G", "B"});
  const auto noise = [](int y, unsigned char* row) {
    for (int x = 0; x < 3 * kWidth; ++x) row[x] = static_cast<unsigned char>(x * x * 31 + y * 77);
  };
  const auto is_full = [](int y, unsigned char* row) {
    std::fill_n(row, 3 * kWidth, std::uint8_t{0});
    if (y == 3) throw std::runtime_error("out of rows");
  };
  EXPECT_EQ(message_of([&] { encode_png(layout, is_full); }), "out of rows");
  EXPECT_EQ(message_of([&] { encode_jpeg(layout, is_full); }), "out of rows");
  std::vector<unsigned char> png = encode_png(layout, noise);
  png[png.size() / 2] ^= 0x55U;
  EXPECT_EQ(message_of([&] { pixels_of(written("a.png", png)); }).find("the image is damaged ("),
            0U);
  std::vector<unsigned char> jpeg = encode_jpeg(layout, noise);
  jpeg.resize(jpeg.size() / 2);
  EXPECT_EQ(message_of([&] { pixels_of(written("a.jpg", jpeg)); }).find("the image is damaged ("),
            0U);
  layout.width = 0;
  EXPECT_EQ(message_of([&] { encode_png(layout, noise); }).find("the image cannot be written ("),
            0U);
  EXPECT_EQ(message_of([&] { encode_jpeg(layout, noise); }).find("the image cannot be written ("),
            0U);
}

TEST_F(ImageFormats, OthersAreNamed) {
  using namespace std::string_literals;
  for (const auto& [bytes, name] : {std::pair("GIF89a and so on"s, "a GIF"s),
                                    {"SDPX"s, "a DPX"},
                                    {"XPDS"s, "a DPX"},
                                    {"FOR4"s, "an IFF"},
                                    {"8BPS"s, "a PSD"},
                                    {"\0\0\1\0"s, "an icon"},
                                    {"\1\xda"s, "an SGI"}}) {
    const std::string error = error_of(written("a.png", bytes + std::string(3000, '\0')));
    EXPECT_EQ(error.find("it is " + name + ", which is not read; EXR, PNG, "), 0U) << error;
  }
  std::string in_runs = bmp_bytes(image_of<std::uint8_t>(3));
  in_runs[30] = 1;
  EXPECT_EQ(error_of(written("a.bmp", in_runs)).find("it is a BMP in runs, which is not read"), 0U);
  EXPECT_EQ(error_of(written("a", "what is this"))
                .find("it is no image of a format that is read; EXR, PNG, "),
            0U);
  EXPECT_NE(error_of(written("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n\1\1\1\1"))
                .find("32-bit_rle_xyze, which is not read"),
            std::string::npos);
}

/// A part of an EXR file, each channel of one value.
struct TestPart {
  std::string name;
  std::vector<std::pair<std::string, float>> channels;
  int width = 3;
};

void write_parts(const std::string& path, const std::vector<TestPart>& parts) {
  std::vector<Imf::Header> headers;
  for (const TestPart& part : parts) {
    Imf::Header& header = headers.emplace_back(Imath::Box2i({0, 0}, {2, 1}),
                                               Imath::Box2i({0, 0}, {part.width - 1, 1}));
    header.setName(part.name);
    header.setType(Imf::SCANLINEIMAGE);
    for (const auto& [name, value] : part.channels) {
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    }
  }
  Imf::MultiPartOutputFile file(path.c_str(), headers.data(), static_cast<int>(headers.size()));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Imf::OutputPart output(file, static_cast<int>(i));
    Imf::FrameBuffer buffer;
    const auto width = static_cast<std::size_t>(parts[i].width);
    std::vector<std::vector<float>> values;
    for (const auto& [name, value] : parts[i].channels) {
      values.emplace_back(2 * width, value);
      buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.back().data()),
                                     sizeof(float), sizeof(float) * width));
    }
    output.setFrameBuffer(buffer);
    output.writePixels(2);
  }
}

TEST_F(ImageFormats, ThePartOfAnExrThatIsThePictureIsShownWhereverItIs) {
  const TestPart depth{"depth", {{"Z", 9.F}}};
  const TestPart beauty{"rgba", {{"R", 1.F}, {"G", 2.F}, {"B", 3.F}, {"A", 0.5F}}};
  const TestPart diffuse{"diffuse", {{"R", 4.F}, {"G", 5.F}, {"B", 6.F}}};
  const TestPart small{"thumbnail", {{"R", 7.F}, {"G", 7.F}, {"B", 7.F}}, 1};
  write_parts(path("parts.exr"), {depth, diffuse, small, beauty});
  ImageInput input(path("parts.exr"));
  EXPECT_EQ(input.header().names,
            (std::vector<std::string>{"R", "G", "B", "A", "depth.Z", "diffuse.R", "diffuse.G",
                                      "diffuse.B"}));
  EXPECT_EQ(input.header().width, 3);
  EXPECT_EQ(input.header().alpha_channel, 3);
  EXPECT_EQ(input.colors().count, 3);
  EXPECT_EQ(input.colors().remark, "");
  const std::vector<float> values = input.read<float>(input.header().channels);
  EXPECT_EQ(std::vector<float>(values.begin(), values.begin() + 8),
            (std::vector<float>{1, 2, 3, 0.5F, 9, 4, 5, 6}));
  EXPECT_EQ(input.read_from<float>(5, 3), (std::vector<float>{4, 5, 6, 4, 5, 6, 4, 5, 6,  //
                                                              4, 5, 6, 4, 5, 6, 4, 5, 6}));

  write_parts(path("layers.exr"),
              {depth, {"colour", {{"main.R", 1.F}, {"main.G", 2.F}, {"main.B", 3.F}}}});
  ImageInput layers(path("layers.exr"));
  EXPECT_EQ(layers.read_from<float>(layers.colors().first, 3)[1], 2.F);
}

TEST_F(ImageFormats, LuminanceAndChromaAreColours) {
  for (const bool has_alpha : {false, true}) {
    const std::string file = path(has_alpha ? "yca.exr" : "yc.exr");
    std::vector<Imf::Rgba> pixels(16 * 12, Imf::Rgba(0.5F, 0.25F, 0.125F, 0.75F));
    {
      Imf::RgbaOutputFile output(file.c_str(), 16, 12, has_alpha ? Imf::WRITE_YCA : Imf::WRITE_YC);
      output.setFrameBuffer(pixels.data(), 1, 16);
      output.writePixels(12);
    }
    ImageInput input(file);
    ASSERT_EQ(input.header().names.size(), has_alpha ? 4U : 3U);
    EXPECT_EQ(input.colors().count, 3);
    EXPECT_EQ(input.colors().alpha, has_alpha ? 3 : -1);
    const std::vector<float> values = input.read<float>(3);
    for (std::size_t i = 0; i < values.size(); i += 3) {
      ASSERT_NEAR(values[i], 0.5F, 0.01F) << i;
      ASSERT_NEAR(values[i + 1], 0.25F, 0.01F) << i;
      ASSERT_NEAR(values[i + 2], 0.125F, 0.01F) << i;
    }
    EXPECT_EQ(input.read<Imath::half>(input.header().channels).size(),
              pixels.size() * input.header().names.size());
  }
}

TEST_F(ImageFormats, ExrOfSubsampledChannelsAloneSaysSo) {
  {
    Imf::Header header(4, 4);
    header.channels().insert("BY", Imf::Channel(Imf::HALF, 2, 2));
    std::vector<Imath::half> values(4);
    Imf::FrameBuffer buffer;
    buffer.insert("BY", Imf::Slice(Imf::HALF, reinterpret_cast<char*>(values.data()), 2, 4, 2, 2));
    Imf::OutputFile file(path("a.exr").c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(4);
  }
  EXPECT_EQ(error_of(path("a.exr")), "all its channels are subsampled, which is not read");
}

TEST_F(ImageFormats, RadiancePicturesMayBeginInAnyCornerAndRunEitherWay) {
  // Red of 1 to 6, row by row.
  const std::vector<std::pair<std::string, std::string>> files = {
      {"-Y 2 +X 3", "123456"}, {"-Y 2 -X 3", "321654"}, {"+Y 2 +X 3", "456123"},
      {"+Y 2 -X 3", "654321"}, {"+X 3 -Y 2", "142536"}, {"-X 3 -Y 2", "362514"},
      {"+X 3 +Y 2", "415263"}, {"-X 3 +Y 2", "635241"}};
  for (const auto& [size, order] : files) {
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n";
    for (const char c : order) bytes += {static_cast<char>(16 * (c - '0')), 0, 0, '\x84'};
    const std::unique_ptr<ImageDecoder> image = open_image(written("turned.hdr", bytes), true);
    EXPECT_EQ(image->header().width, 3) << size;
    EXPECT_EQ(image->header().height, 2) << size;
    std::vector<float> red(6);
    image->read_rows(1, 1, 0, 1, SampleType::Float, red.data() + 3);
    image->read_rows(0, 1, 0, 1, SampleType::Float, red.data());
    EXPECT_EQ(red, (std::vector<float>{1, 2, 3, 4, 5, 6})) << size;
  }
  for (const std::string size :
       {"+Y 2 +Y 3", "-Y 2", "Y 2 X 3", "-Y +X 3", "-Y 2 +X 0", "-+", ""}) {
    EXPECT_THROW(open_image(written("odd.hdr", "#?RADIANCE\n\n" + size + "\n\1\1\1\x81"), true),
                 IoError)
        << size;
  }
}

}  // namespace
}  // namespace ajar
