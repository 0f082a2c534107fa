#include "imageio/formats/image_formats.h"

#include <ImfInputFile.h>
#include <ImfRgbaFile.h>
#include <gtest/gtest.h>

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
#include "imageio/testing/format_checks.h"

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
      // ImageInput catches any exception of the libraries, too.
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
