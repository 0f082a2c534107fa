#include "imageio/formats/image_formats.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "core/error.h"
#include "imageio/exr_header.h"
#include "imageio/image_encoder.h"
#include "imageio/image_input.h"
#include "imageio/openimageio/openimageio_module.h"
#include "imageio/png_chunks.h"

// Held against OpenImageIO.
namespace ajar {
namespace {

namespace fs = std::filesystem;

class ImageFormats : public ::testing::Test {
 protected:
  ImageFormats()
      : folder_(fs::temp_directory_path() / ("ajar_small_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string written(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
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

void expect_same(const std::string& path, bool has_unassociated_alpha = true) {
  const Pixels theirs = pixels_of(open_with_openimageio(path, has_unassociated_alpha));
  const Pixels ours = pixels_of(image_formats::open_own(path, has_unassociated_alpha));
  EXPECT_EQ(ours.header.width, theirs.header.width) << path;
  EXPECT_EQ(ours.header.height, theirs.header.height) << path;
  EXPECT_EQ(ours.header.names, theirs.header.names) << path;
  EXPECT_EQ(ours.header.alpha_channel, theirs.header.alpha_channel) << path;
  EXPECT_EQ(ours.header.type, theirs.header.type) << path;
  EXPECT_EQ(ours.header.is_integer, theirs.header.is_integer) << path;
  EXPECT_EQ(ours.header.origin, theirs.header.origin) << path;
  EXPECT_EQ(ours.header.resolution, theirs.header.resolution) << path;
  EXPECT_EQ(ours.stored, theirs.stored) << path;
  ASSERT_EQ(ours.floats.size(), theirs.floats.size()) << path;
  for (std::size_t i = 0; i < ours.floats.size(); ++i) {
    ASSERT_EQ(std::bit_cast<std::uint32_t>(ours.floats[i]),
              std::bit_cast<std::uint32_t>(theirs.floats[i]))
        << path << ", value " << i << ": " << ours.floats[i] << ", " << theirs.floats[i];
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

TEST_F(ImageFormats, ReadWhatOpenImageIoWrites) {
  for (const auto& [name, type] : {std::pair{"float.exr", OIIO::TypeDesc::FLOAT},
                                   {"half.exr", OIIO::TypeDesc::HALF},
                                   {"tiled.exr", OIIO::TypeDesc::FLOAT},
                                   {"eight.png", OIIO::TypeDesc::UINT8},
                                   {"sixteen.png", OIIO::TypeDesc::UINT16},
                                   {"a.jpg", OIIO::TypeDesc::UINT8},
                                   {"a.hdr", OIIO::TypeDesc::FLOAT}}) {
    const std::string file = path(name);
    const bool has_alpha = file.ends_with(".png") || file.ends_with(".exr");
    OIIO::ImageSpec spec(kWidth, kHeight, has_alpha ? 4 : 3, type);
    if (file.ends_with("tiled.exr")) {
      spec.tile_width = 16;
      spec.tile_height = 16;
      spec.channelnames = {"R", "G", "B", "depth"};
      spec.alpha_channel = -1;
    }
    std::vector<float> pixels;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        for (std::size_t c = 0; c < static_cast<std::size_t>(spec.nchannels); ++c) {
          const float value = value_at(x, y, c);
          pixels.push_back(type == OIIO::TypeDesc::FLOAT || type == OIIO::TypeDesc::HALF
                               ? value
                               : std::min(value / 4.F, 1.F));
        }
      }
    }
    const auto output = OIIO::ImageOutput::create(file);
    ASSERT_TRUE(output && output->open(file, spec) &&
                output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && output->close());
    expect_same(file);
  }
}

TEST_F(ImageFormats, WriteWhatOpenImageIoReads) {
  const auto floats = [](std::size_t channels) {
    return [=](int y, float* row) {
      for (int x = 0; x < kWidth; ++x) {
        for (std::size_t c = 0; c < channels; ++c) *row++ = value_at(x, y, c);
      }
    };
  };
  const auto bytes = [](int y, unsigned char* row) {
    for (int x = 0; x < kWidth; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        *row++ = static_cast<unsigned char>(std::min(60.F * value_at(x, y, c), 255.F));
      }
    }
  };
  const ImageLayout layers =
      layout_of({"R", "G", "B", "albedo.R", "albedo.G", "albedo.B", "depth"});
  expect_same(written("a.exr", encode_exr(layers, floats(7))));
  const Pixels read = pixels_of(open_with_openimageio(path("a.exr"), false));
  EXPECT_EQ(read.header.origin, Vec2i(5, 3));
  EXPECT_EQ(read.header.resolution, Vec2i(50, 100));
  EXPECT_EQ(read.header.texts.at("ajar:seed"), "7");
  EXPECT_EQ(image_formats::open_own(path("a.exr"), false)->header().texts.at("ajar:seed"), "7");
  std::vector<float> row(7 * kWidth);
  floats(7)(kHeight - 1, row.data());
  // The order of the channels may be another in the file, but not in what is read.
  for (std::size_t c = 0; c < 7; ++c) {
    const auto place =
        std::find(read.header.names.begin(), read.header.names.end(), layers.names[c]);
    ASSERT_NE(place, read.header.names.end());
    const auto channel = static_cast<std::size_t>(place - read.header.names.begin());
    EXPECT_EQ(read.floats[read.floats.size() - 7 + channel], row[row.size() - 7 + c]);
  }
  const ImageLayout colours = layout_of({"R", "G", "B"});
  expect_same(written("ours.hdr", encode_hdr(colours, floats(3))));
  expect_same(written("ours.png", encode_png(colours, bytes)));
  expect_same(written("ours.jpg", encode_jpeg(colours, bytes)));
  // The same picture, whoever wrote it.
  std::vector<float> hdr(3 * kWidth * kHeight);
  std::vector<unsigned char> shown(hdr.size());
  for (int y = 0; y < kHeight; ++y) {
    floats(3)(y, hdr.data() + 3 * kWidth * y);
    bytes(y, shown.data() + 3 * kWidth * y);
  }
  for (const std::string extension : {".hdr", ".png", ".jpg"}) {
    const std::string theirs = path("theirs" + extension);
    const bool is_shown = extension != ".hdr";
    OIIO::ImageSpec spec(kWidth, kHeight, 3,
                         is_shown ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    spec.attribute("CompressionQuality", 95);
    const auto output = OIIO::ImageOutput::create(theirs);
    ASSERT_TRUE(output && output->open(theirs, spec) &&
                output->write_image(
                    spec.format, is_shown ? static_cast<const void*>(shown.data()) : hdr.data()) &&
                output->close());
    EXPECT_EQ(pixels_of(open_with_openimageio(path("ours" + extension), false)).floats,
              pixels_of(open_with_openimageio(theirs, false)).floats)
        << extension;
  }
}

/// Of every kind that PNG has: a palette of four colours, grey of a few bits, a colour that is
/// transparent, rows in seven parts.
std::string png_of(const std::string& path, int type, int bits, bool interlaced, bool transparent) {
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
      expect_same(png_of(path(std::to_string(number++) + ".png"), kind.type, kind.bits, interlaced,
                         kind.transparent));
    }
  }
}

TEST_F(ImageFormats, MultiplyWithAlphaUnlessTold) {
  const std::string file = png_of(path("alpha.png"), PNG_COLOR_TYPE_RGB_ALPHA, 8, false, false);
  const Pixels with = pixels_of(image_formats::open_own(file, false));
  const Pixels without = pixels_of(image_formats::open_own(file, true));
  for (std::size_t i = 0; i < with.floats.size(); ++i) {
    const float alpha = without.floats[i / 4 * 4 + 3];
    const float expected = without.floats[i] * (i % 4 == 3 ? 1.F : alpha);
    ASSERT_NEAR(with.floats[i], expected, 0.51F / 255.F) << i;
  }
}

TEST_F(ImageFormats, AgreeOnImagesOfTheFuzzersOrRefuseThem) {
  constexpr const char* kExtensions[] = {".pfm", ".exr", ".png", ".jpg", ".hdr", ".tif"};
  std::size_t read = 0;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(fs::path(AJAR_SOURCE_DIR) / "fuzz/corpus/image")) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::string image =
        written("image" + std::string(kExtensions[static_cast<unsigned char>(bytes[0]) % 6]),
                bytes.substr(1));
    const bool is_ours =
        bytes.substr(1).starts_with("\x76\x2f\x31\x01") || bytes.substr(1).starts_with("\x89PNG") ||
        bytes.substr(1).starts_with("\xff\xd8") || bytes.substr(1).starts_with("#?");
    if (!is_ours) {
      EXPECT_THROW(image_formats::open_own(image, true), IoError) << entry.path();
      continue;
    }
    // What nobody opens.
    if (!exr_header_complaint(image, bytes.size() - 1).empty() ||
        !png_chunk_complaint(image, bytes.size() - 1).empty()) {
      continue;
    }
    ++read;
    SCOPED_TRACE(entry.path());
    expect_same(image);
  }
  EXPECT_GT(read, 6U);
}

TEST_F(ImageFormats, RefuseWhatIsCutOff) {
  const ImageLayout layout = layout_of({"R", "G", "B"});
  const auto floats = [](int y, float* row) {
    std::fill_n(row, 3 * kWidth, static_cast<float>(y));
  };
  const auto noise = [](int y, unsigned char* row) {
    for (int x = 0; x < 3 * kWidth; ++x) row[x] = static_cast<unsigned char>(x * x * 31 + y * 77);
  };
  const std::pair<const char*, std::vector<unsigned char>> files[] = {
      {"cut.exr", encode_exr(layout, floats)},
      {"cut.hdr", encode_hdr(layout, floats)},
      {"cut.png", encode_png(layout, noise)},
      {"cut.jpg", encode_jpeg(layout, noise)}};
  for (const auto& [name, bytes] : files) {
    for (const std::size_t size :
         {std::size_t{12}, bytes.size() / 3, bytes.size() / 2, bytes.size() * 3 / 4}) {
      const std::string file =
          written(name, std::vector<unsigned char>(
                            bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)));
      // As ImageInput takes it: any exception of the libraries.
      EXPECT_THROW(pixels_of(image_formats::open_own(file, true)), std::exception)
          << name << " cut to " << size;
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
  EXPECT_EQ(message_of([&] {
              pixels_of(image_formats::open_own(written("a.png", png), true));
            }).find("the image is damaged ("),
            0U);
  std::vector<unsigned char> jpeg = encode_jpeg(layout, noise);
  jpeg.resize(jpeg.size() / 2);
  EXPECT_EQ(message_of([&] {
              pixels_of(image_formats::open_own(written("a.jpg", jpeg), true));
            }).find("the image is damaged ("),
            0U);
  layout.width = 0;
  EXPECT_EQ(message_of([&] { encode_png(layout, noise); }).find("the image cannot be written ("),
            0U);
  EXPECT_EQ(message_of([&] { encode_jpeg(layout, noise); }).find("the image cannot be written ("),
            0U);
}

TEST_F(ImageFormats, LeaveToOthersWhatOnlyTheyRead) {
  const auto foreign = [&](const std::string& file) -> std::string {
    try {
      image_formats::open_own(file, true);
    } catch (const image_formats::ForeignImage& image) {
      return image.what();
    }
    return "";
  };
  EXPECT_EQ(foreign(written("a.tif", "II*\0and so on")), "a TIFF");
  EXPECT_EQ(foreign(written("a", "what is this")), "something unknown");
  EXPECT_NE(foreign(written("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n\1\1\1\1")),
            "");
  // What it says of itself comes from OpenImageIO, which is found beside this program.
  try {
    open_image(path("a.tif"), true);
    FAIL();
  } catch (const IoError& error) {
    EXPECT_EQ(std::string(error.what()).find("only builds"), std::string::npos) << error.what();
  }
  const std::string tiff = path("b.tif");
  const std::vector<unsigned char> pixels = {10, 20, 30, 40, 50, 60};
  const auto output = OIIO::ImageOutput::create(tiff);
  ASSERT_TRUE(output && output->open(tiff, OIIO::ImageSpec(2, 1, 3, OIIO::TypeDesc::UINT8)) &&
              output->write_image(OIIO::TypeDesc::UINT8, pixels.data()) && output->close());
  EXPECT_EQ(pixels_of(open_image(tiff, true)).stored, pixels);
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

TEST_F(ImageFormats, RadiancePicturesMayBeginInAnyCornerAndRunEitherWay) {
  // Red of 1 to 6, row by row.
  const std::vector<std::pair<std::string, std::string>> files = {
      {"-Y 2 +X 3", "123456"}, {"-Y 2 -X 3", "321654"}, {"+Y 2 +X 3", "456123"},
      {"+Y 2 -X 3", "654321"}, {"+X 3 -Y 2", "142536"}, {"-X 3 -Y 2", "362514"},
      {"+X 3 +Y 2", "415263"}, {"-X 3 +Y 2", "635241"}};
  for (const auto& [size, order] : files) {
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n";
    for (const char c : order) bytes += {static_cast<char>(16 * (c - '0')), 0, 0, '\x84'};
    const std::unique_ptr<ImageDecoder> image =
        image_formats::open_own(written("turned.hdr", bytes), true);
    EXPECT_EQ(image->header().width, 3) << size;
    EXPECT_EQ(image->header().height, 2) << size;
    std::vector<float> red(6);
    image->read_rows(1, 1, 0, 1, SampleType::Float, red.data() + 3);
    image->read_rows(0, 1, 0, 1, SampleType::Float, red.data());
    EXPECT_EQ(red, (std::vector<float>{1, 2, 3, 4, 5, 6})) << size;
  }
  for (const std::string size :
       {"+Y 2 +Y 3", "-Y 2", "Y 2 X 3", "-Y +X 3", "-Y 2 +X 0", "-+", ""}) {
    EXPECT_THROW(
        image_formats::open_own(written("odd.hdr", "#?RADIANCE\n\n" + size + "\n\1\1\1\x81"), true),
        IoError)
        << size;
  }
}

}  // namespace
}  // namespace ajar
