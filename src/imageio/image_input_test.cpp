#include "imageio/image_input.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string_view>

#include "core/error.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kSide = 65535;

/// Puts the beginnings of files together.
class Bytes {
 public:
  Bytes& text(std::string_view value) {
    bytes_ += value;
    return *this;
  }
  Bytes& zeros(std::size_t count) {
    bytes_.append(count, '\0');
    return *this;
  }
  Bytes& little(std::initializer_list<std::uint32_t> values, int size) {
    for (const std::uint32_t value : values) {
      for (int i = 0; i < size; ++i) bytes_ += static_cast<char>(value >> (8 * i));
    }
    return *this;
  }
  Bytes& big(std::initializer_list<std::uint32_t> values, int size) {
    for (const std::uint32_t value : values) {
      for (int i = size - 1; i >= 0; --i) bytes_ += static_cast<char>(value >> (8 * i));
    }
    return *this;
  }
  Bytes& png_chunk(const std::string& content) {
    big({static_cast<std::uint32_t>(content.size()) - 4}, 4).text(content);
    return big({static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(content.data()),
                                                 static_cast<uInt>(content.size())))},
               4);
  }
  const std::string& result() const { return bytes_; }

 private:
  std::string bytes_;
};

std::string png(std::uint32_t depth, std::uint32_t type, std::uint32_t interlace) {
  return Bytes()
      .text("\x89PNG\r\n\x1a\n")
      .png_chunk(Bytes()
                     .text("IHDR")
                     .big({kSide, kSide}, 4)
                     .big({depth, type, 0, 0, interlace}, 1)
                     .result())
      .png_chunk(Bytes().text("IDAT").text("\x78\x9c\x03").zeros(8).result())
      .png_chunk("IEND")
      .result();
}

std::string bmp(std::uint32_t depth, std::uint32_t compression) {
  return Bytes()
      .text("BM")
      .little({200}, 4)
      .zeros(4)
      .little({54, 40, kSide, kSide}, 4)
      .little({1, depth}, 2)
      .little({compression, 0, 0, 0, 2, 0}, 4)
      .zeros(200)
      .result();
}

std::string tiff(std::uint32_t compression) {
  const std::uint32_t bits = compression == 4 ? 1 : 8;
  Bytes file;
  file.text("II*").zeros(1).little({8}, 4).little({9}, 2);
  const std::uint32_t entries[][3] = {{256, 4, kSide},       {257, 4, kSide}, {258, 3, bits},
                                      {259, 3, compression}, {262, 3, 1},     {273, 4, 200},
                                      {277, 3, 1},           {278, 4, kSide}, {279, 4, 20}};
  for (const auto& [tag, type, value] : entries) file.little({tag, type}, 2).little({1, value}, 4);
  return file.zeros(100).result();
}

/// A header of zipped half-floats, and next to nothing behind it.
std::string exr(std::uint32_t width, std::uint32_t height) {
  const auto attribute = [](Bytes bytes, std::string_view name, std::string_view type,
                            std::uint32_t size) {
    return bytes.text(name).zeros(1).text(type).zeros(1).little({size}, 4);
  };
  Bytes bytes = Bytes().little({20000630, 2}, 4);
  bytes = attribute(bytes, "channels", "chlist", 19).text("Y").zeros(1).little({1, 0, 1, 1}, 4);
  bytes = attribute(bytes.zeros(1), "compression", "compression", 1).little({3}, 1);
  for (const char* window : {"dataWindow", "displayWindow"}) {
    bytes = attribute(bytes, window, "box2i", 16).little({0, 0, width - 1, height - 1}, 4);
  }
  bytes = attribute(bytes, "lineOrder", "lineOrder", 1).zeros(1);
  bytes = attribute(bytes, "pixelAspectRatio", "float", 4).little({0x3f800000}, 4);
  bytes = attribute(bytes, "screenWindowCenter", "v2f", 8).zeros(8);
  bytes = attribute(bytes, "screenWindowWidth", "float", 4).little({0x3f800000}, 4);
  return bytes.zeros(40).result();
}

/// One pixel on a large canvas.
std::string gif(std::string_view version, std::uint32_t side = kSide) {
  return Bytes()
      .text(version)
      .little({side, side}, 2)
      .little({0x80, 0, 0}, 1)
      .zeros(6)
      .text(",")
      .little({0, 0, 1, 1}, 2)
      .text(std::string_view("\0\2\2\x44\1\0;", 7))
      .result();
}

/// Small files of many formats that claim billions of pixels.
std::vector<std::pair<std::string, std::string>> liars() {
  const auto tga = [](std::uint32_t type) {
    return Bytes()
        .zeros(2)
        .little({type}, 1)
        .zeros(9)
        .little({kSide, kSide}, 2)
        .little({24, 32}, 1)
        .zeros(30)
        .result();
  };
  return {
      {"gray.png", png(8, 0, 0)},
      {"bits.png", png(1, 0, 0)},
      {"interlaced.png", png(16, 2, 1)},
      {"canvas.gif", gif("GIF89a")},
      {"odd-version.gif", gif("GIF???")},
      {"smaller-canvas.gif", gif("GIF89a", 20000) + std::string(450, '\0')},
      {"plain.bmp", bmp(24, 0)},
      {"runs.bmp", bmp(8, 1)},
      {"plain.tga", tga(2)},
      {"runs.tga", tga(10)},
      {"a.hdr", Bytes()
                    .text("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 65535 +X 65535\n")
                    .zeros(30)
                    .result()},
      {"a.pgm", Bytes().text("P5\n65535 65535\n255\n").zeros(30).result()},
      {"a.psd", Bytes()
                    .text("8BPS")
                    .big({1}, 2)
                    .zeros(6)
                    .big({3}, 2)
                    .big({30000, 30000}, 4)
                    .big({8, 3}, 2)
                    .zeros(12)
                    .big({0}, 2)
                    .zeros(30)
                    .result()},
      {"a.sgi",
       Bytes().big({474}, 2).big({0, 1}, 1).big({3, kSide, kSide, 3}, 2).zeros(600).result()},
      {"plain.tif", tiff(1)},
      {"fax.tif", tiff(4)},
      {"lzw.tif", tiff(5)},
      {"zip.tif", tiff(8)},
      {"runs.tif", tiff(32773)},
      {"long-rows.exr", exr(1U << 24U, 4)},
      {"a.webp", Bytes()
                     .text("RIFF")
                     .little({40}, 4)
                     .text("WEBPVP8L")
                     .little({20}, 4)
                     .text("\x2f")
                     .little({0x0fffffff}, 4)
                     .zeros(20)
                     .result()},
      {"lossless-stream.webp", Bytes().text("\x2f").little({0x0fffffff}, 4).zeros(20).result()},
      {"a.dds", Bytes()
                    .text("DDS ")
                    .little({124, 0x1007, 11000, 11000, 0, 0, 1}, 4)
                    .zeros(44)
                    .little({32, 4}, 4)
                    .text("DXT1")
                    .zeros(20)
                    .little({0x1000}, 4)
                    .zeros(30)
                    .result()},
      // 13874 x 10281 pixels, which the decoder would make of it.
      {"colour-alone.webp",
       Bytes().text("\x2f").little({0x1a0a3631}, 4).zeros(2).text(std::string(131, 'K')).result()},
      {"lossy-stream.webp",
       Bytes().zeros(3).text("\x9d\x01\x2a").little({0x3fff, 0x3fff}, 2).zeros(20).result()},
      {"longer-lossy-stream.webp",
       Bytes().zeros(3).text("\x9d\x01\x2a").little({0x3fff, 0x3fff}, 2).zeros(5000).result()}};
}

/// A folder of its own that is gone after the test.
class ImageInputTest : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

  fs::path folder_ = fs::temp_directory_path() / ("ajar-image-input-" + std::to_string(getpid()));
};

std::string error_of(const std::string& path) {
  try {
    ImageInput(path).read<float>(1);
  } catch (const IoError& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(ImageInputTest, FilesCannotClaimMorePixelsThanTheyHold) {
  for (const auto& [name, content] : liars()) {
    const std::string error = error_of(write(name, content));
    EXPECT_NE(error.find("pixels, but has " + std::to_string(content.size()) + " bytes"),
              std::string::npos)
        << name << ": " << error;
  }
}

TEST_F(ImageInputTest, FormatsWhoseDecodersBreakAreRefused) {
  for (const auto& [name, start] :
       {std::pair("a.dpx", Bytes().text("SDPX")), std::pair("b.dpx", Bytes().text("XPDS")),
        std::pair("a.iff", Bytes().text("FOR4")), std::pair("a.ico", Bytes().little({0, 1}, 2)),
        std::pair("a.pic", Bytes().big({0x5380f634}, 4)),
        std::pair("a.png", Bytes().big({0x5380f634}, 4))}) {
    Bytes content = start;
    const std::string error = error_of(write(name, content.zeros(3000).result()));
    EXPECT_NE(error.find("which is not read: damaged ones would end the program"),
              std::string::npos)
        << name << ": " << error;
  }
}

TEST_F(ImageInputTest, DamagedSgiIsNoticedBeforeItIsDecoded) {
  const auto sgi = [](std::uint32_t storage, std::uint32_t bytes, std::uint32_t dimensions) {
    return Bytes().big({474}, 2).big({storage, bytes}, 1).big({dimensions, 4, 4, 1}, 2).zeros(500);
  };
  const auto expect_error = [&](Bytes bytes, const char* part) {
    const std::string error = error_of(write("a.sgi", bytes.result()));
    EXPECT_NE(error.find(part), std::string::npos) << error;
  };
  expect_error(sgi(16, 0, 2).zeros(600), "damaged");
  expect_error(sgi(0, 0, 2).zeros(600), "damaged");
  expect_error(sgi(0, 3, 2).zeros(600), "damaged");
  expect_error(sgi(0, 1, 4).zeros(600), "damaged");
  expect_error(sgi(0, 2, 2).zeros(31), "it claims 4x4 pixels");
  expect_error(sgi(1, 1, 2).zeros(31), "cut short");
  expect_error(sgi(1, 1, 2).big({2000, 0, 0, 0, 1, 1, 1, 1}, 4), "cut short");
  EXPECT_EQ(error_of(write("a.sgi", sgi(0, 1, 2).zeros(16).result())), "no error");
}

TEST_F(ImageInputTest, ChunksOfPngCannotClaimMoreThanTheFile) {
  std::string header = png(8, 0, 0);
  // A picture of four pixels in front of a text of two gigabytes.
  header.replace(16, 8, std::string("\0\0\0\2\0\0\0\2", 8));
  const std::string content =
      Bytes().text(header.substr(0, 33)).big({0x7fff0000}, 4).text("tEXt").zeros(40).result();
  const std::string error = error_of(write("a.png", content));
  EXPECT_EQ(error, "its chunk \"tEXt\" claims 2147418112 bytes, but the file has " +
                       std::to_string(content.size()));
}

TEST_F(ImageInputTest, LargeCanvasesOfSmallPicturesAreBelieved) {
  const std::string small = gif("GIF89a", 3000);
  ASSERT_LT(small.size(), 60U) << "of which LZW could not make so many pixels";
  EXPECT_EQ(ImageInput(write("canvas.gif", small)).header().width, 3000);
}

TEST_F(ImageInputTest, IsAskedForFloatsOrWhatTheFileHas) {
  const std::string file = path("half.exr");
  const auto output = OIIO::ImageOutput::create(file);
  const std::vector<float> values = {0.25F, 0.5F, 0.75F};
  ASSERT_TRUE(output && output->open(file, OIIO::ImageSpec(1, 1, 3, OIIO::TypeDesc::HALF)) &&
              output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close());
  EXPECT_EQ(ImageInput(file).read<float>(3), values);
  EXPECT_EQ(ImageInput(file).read<Imath::half>(3).at(1), Imath::half(0.5F));
  EXPECT_THROW(ImageInput(file).read<std::uint8_t>(3), std::invalid_argument);
}

TEST_F(ImageInputTest, FlatPicturesAreBelieved) {
  // As small as files of so many pixels get.
  constexpr int kFlat = 1000;
  const std::vector<std::uint8_t> flat(std::size_t{kFlat} * kFlat, 7);
  for (const auto& [name, packing] :
       {std::pair("a.png", "zip"), std::pair("a.tif", "zip"), std::pair("b.tif", "lzw"),
        std::pair("c.tif", "packbits"), std::pair("d.tif", "none"), std::pair("a.jpg", "jpeg:90"),
        std::pair("a.webp", "lossless"), std::pair("a.tga", "rle"), std::pair("a.bmp", "rle"),
        std::pair("a.gif", ""), std::pair("a.sgi", "rle"), std::pair("a.exr", "zip"),
        std::pair("b.exr", "rle"), std::pair("c.exr", "piz"), std::pair("d.exr", "pxr24"),
        std::pair("e.exr", "b44a"), std::pair("f.exr", "dwaa"), std::pair("g.exr", "dwab")}) {
    const auto output = OIIO::ImageOutput::create(path(name));
    ASSERT_TRUE(output) << name;
    const bool needs_colour = std::string(name) == "a.webp" || std::string(name) == "a.gif";
    OIIO::ImageSpec spec(kFlat, kFlat, needs_colour ? 3 : 1, OIIO::TypeDesc::UINT8);
    spec.attribute("compression", packing);
    spec.attribute("png:compressionLevel", 9);
    ASSERT_TRUE(output->open(path(name), spec)) << name << output->geterror();
    // A zero stride in x repeats the value in all channels.
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, flat.data(), 0, 0)) << name;
    ASSERT_TRUE(output->close());
    ImageInput input(path(name));
    const std::vector<float> read = input.read<float>(1);
    ASSERT_EQ(read.size(), flat.size()) << name;
    EXPECT_NEAR(read.back(), 7.0 / 255.0, 1.0 / 255.0) << name;
  }
}

TEST_F(ImageInputTest, TilesAndOffsetsAreReadAsWhole) {
  OIIO::ImageSpec spec(70, 150, 2, OIIO::TypeDesc::FLOAT);
  std::vector<float> values;
  values.reserve(70 * 150 * 2);
  for (int i = 0; i < 70 * 150 * 2; ++i) values.push_back(static_cast<float>(i));
  for (const int tile : {0, 32}) {
    spec.tile_width = spec.tile_height = tile;
    spec.x = 5;
    spec.y = -7;
    const auto output = OIIO::ImageOutput::create(path("a.exr"));
    ASSERT_TRUE(output->open(path("a.exr"), spec));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
    ASSERT_TRUE(output->close());
    ImageInput input(path("a.exr"));
    EXPECT_EQ(input.read<float>(2), values) << tile;
    const std::vector<float> first = ImageInput(path("a.exr")).read<float>(1);
    ASSERT_EQ(first.size(), values.size() / 2);
    EXPECT_EQ(first[1234], values[2468]) << tile;
  }
}

TEST_F(ImageInputTest, WhatIsNoImageSaysWhy) {
  EXPECT_NE(error_of(folder_.string()).find("it is a folder"), std::string::npos);
  EXPECT_EQ(error_of(write("empty.png", "")), "the file is empty");
  EXPECT_EQ(error_of(path("absent.png")), "No such file or directory");
  EXPECT_EQ(error_of(write("text.png", "no image\n")).find('\n'), std::string::npos);
}

}  // namespace
}  // namespace ajar
