#include "imageio/image_input.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string_view>

#include "core/error.h"
#include "imageio/testing/image_writers.h"

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

std::string bmp() {
  return Bytes()
      .text("BM")
      .little({200}, 4)
      .zeros(4)
      .little({54, 40, kSide, kSide}, 4)
      .little({1, 24}, 2)
      .little({0, 0, 0, 0, 2, 0}, 4)
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

/// A container with what begins a picture, and some bytes behind it.
std::string webp(Bytes content, const std::string& rest = std::string(20, '\0')) {
  const std::string inside = content.text(rest).result();
  return Bytes()
      .text("RIFF")
      .little({static_cast<std::uint32_t>(inside.size() + 4)}, 4)
      .text("WEBP")
      .text(inside)
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
      {"plain.bmp", bmp()},
      {"plain.tga", tga(2)},
      {"runs.tga", tga(10)},
      {"a.hdr", Bytes()
                    .text("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 65535 +X 65535\n")
                    .zeros(30)
                    .result()},
      {"a.pgm", Bytes().text("P5\n65535 65535\n255\n").zeros(30).result()},
      {"plain.tif", tiff(1)},
      {"fax.tif", tiff(4)},
      {"lzw.tif", tiff(5)},
      {"zip.tif", tiff(8)},
      {"runs.tif", tiff(32773)},
      {"long-rows.exr", exr(1U << 24U, 4)},
      {"a.webp", webp(Bytes().text("VP8L").little({20}, 4).text("\x2f").little({0x0fffffff}, 4))},
      {"canvas.webp", webp(Bytes()
                               .text("VP8X")
                               .little({10, 0}, 4)
                               .little({0x3ffe, 0x3ffe}, 3)
                               .text("VP8L")
                               .little({20}, 4)
                               .text("\x2f")
                               .little({0x0fffbffe}, 4))},
      // 13874 x 10281 pixels, which the decoder would make of it.
      {"colour-alone.webp",
       webp(Bytes().text("VP8L").little({138}, 4).text("\x2f").little({0x1a0a3631}, 4),
            std::string(2, '\0') + std::string(131, 'K'))},
      {"lossy.webp", webp(Bytes()
                              .text("VP8 ")
                              .little({5010}, 4)
                              .little({0x10}, 1)
                              .zeros(2)
                              .text("\x9d\x01\x2a")
                              .little({0x3fff, 0x3fff}, 2),
                          std::string(5000, '\0'))}};
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

TEST_F(ImageInputTest, ChunksOfPngThatClaimMoreThanTheFileTakeNoMemory) {
  std::string header = png(8, 0, 0);
  // A picture of four pixels in front of a text of two gigabytes.
  header.replace(16, 8, std::string("\0\0\0\2\0\0\0\2", 8));
  const std::string header_chunk = Bytes().text(header.substr(8, 21)).result();
  const std::string content = Bytes()
                                  .text("\x89PNG\r\n\x1a\n")
                                  .png_chunk(header_chunk.substr(4, 17))
                                  .big({0x7fff0000}, 4)
                                  .text("tEXt")
                                  .zeros(40)
                                  .result();
  const std::string file = write("a.png", content);
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
  rlimit limit = before;
  limit.rlim_cur = std::uint64_t{1} << 31U;
  setrlimit(RLIMIT_AS, &limit);
  const std::string error = error_of(file);
  setrlimit(RLIMIT_AS, &before);
  EXPECT_EQ(error, "the image is damaged (Read Error)");
}

TEST_F(ImageInputTest, IsAskedForFloatsOrWhatTheFileHas) {
  const std::string file = path("half.exr");
  const std::vector<float> values = {0.25F, 0.5F, 0.75F};
  testing::write_exr(file, testing::TestImage<Imath::half>{1, 1, 3, {0.25F, 0.5F, 0.75F}});
  EXPECT_EQ(ImageInput(file).read<float>(3), values);
  EXPECT_EQ(ImageInput(file).read<Imath::half>(3).at(1), Imath::half(0.5F));
  EXPECT_THROW(ImageInput(file).read<std::uint8_t>(3), std::invalid_argument);
}

TEST_F(ImageInputTest, FlatPicturesAreBelieved) {
  // The smallest files of so many pixels.
  constexpr int kFlat = 1000;
  const auto flat = [](int channels, auto value) {
    return testing::TestImage<decltype(value)>{
        kFlat, kFlat, channels,
        std::vector<decltype(value)>(static_cast<std::size_t>(kFlat * kFlat * channels), value)};
  };
  const testing::TestImage<std::uint8_t> gray = flat(1, std::uint8_t{7});
  const testing::TestImage<std::uint8_t> rgb = flat(3, std::uint8_t{7});
  const testing::TestImage<Imath::half> half = flat(1, Imath::half(7.F / 255.F));
  std::vector<std::string> names;
  const auto next = [&](const char* name) { return path(names.emplace_back(name)); };
  testing::write_png(next("a.png"), gray);
  testing::write_tiff(next("zip.tif"), gray, {.compression = COMPRESSION_ADOBE_DEFLATE});
  testing::write_tiff(next("lzw.tif"), gray, {.compression = COMPRESSION_LZW});
  testing::write_tiff(next("runs.tif"), gray, {.compression = COMPRESSION_PACKBITS});
  testing::write_tiff(next("plain.tif"), gray, {.compression = COMPRESSION_NONE});
  testing::write_webp(next("a.webp"), rgb);
  testing::write_bytes(next("a.tga"), testing::tga_bytes(rgb, true, true));
  testing::write_bytes(next("a.bmp"), testing::bmp_bytes(rgb));
  ImageLayout layout;
  layout.width = layout.height = kFlat;
  testing::write_bytes(next("a.jpg"), encode_jpeg(layout, [](int, unsigned char* row) {
                         std::fill_n(row, 3 * kFlat, std::uint8_t{7});
                       }));
  for (const auto& [name, compression] :
       {std::pair("a.exr", Imf::ZIP_COMPRESSION), std::pair("b.exr", Imf::RLE_COMPRESSION),
        std::pair("c.exr", Imf::PIZ_COMPRESSION), std::pair("d.exr", Imf::PXR24_COMPRESSION),
        std::pair("e.exr", Imf::B44A_COMPRESSION), std::pair("f.exr", Imf::DWAA_COMPRESSION),
        std::pair("g.exr", Imf::DWAB_COMPRESSION)}) {
    testing::write_exr(next(name), half, compression);
  }
  for (const std::string& name : names) {
    const std::vector<float> read = ImageInput(path(name)).read<float>(1);
    ASSERT_EQ(read.size(), gray.values.size()) << name;
    EXPECT_NEAR(read.back(), 7.0 / 255.0, 1.0 / 255.0) << name;
  }
}

TEST_F(ImageInputTest, TilesAndOffsetsAreReadAsWhole) {
  testing::TestImage<float> image{70, 150, 2, {}};
  for (int i = 0; i < 70 * 150 * 2; ++i) image.values.push_back(static_cast<float>(i));
  for (const int tile : {0, 32}) {
    testing::write_exr(path("a.exr"), image, Imf::ZIP_COMPRESSION, tile, {5, -7});
    ImageInput input(path("a.exr"));
    EXPECT_EQ(input.header().origin, Vec2i(5, -7)) << tile;
    EXPECT_EQ(input.read<float>(2), image.values) << tile;
    const std::vector<float> first = ImageInput(path("a.exr")).read<float>(1);
    ASSERT_EQ(first.size(), image.values.size() / 2);
    EXPECT_EQ(first[1234], image.values[2468]) << tile;
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
