#include <ImfInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <gtest/gtest.h>

#include "imageio/image_input.h"
#include "imageio/testing/format_checks.h"

namespace ajar {
namespace {

using namespace testing;

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
    // The oracle is OpenEXR's simpler interface.
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

}  // namespace
}  // namespace ajar
