#include "imageio/image_file.h"

#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "core/error.h"

namespace ajar {
namespace {
namespace fs = std::filesystem;

class ImageFile : public ::testing::Test {
 protected:
  ImageFile() : folder_(fs::temp_directory_path() / ("ajar_image_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  static std::string content(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

 private:
  fs::path folder_;
};

/// A crop of 70 × 66 (more than one strip) in an image of 100 × 80.
constexpr int kFileWidth = 70;
constexpr int kFileHeight = 66;
Picture cropped(std::vector<Picture::Layer> layers) {
  return {{100, 80}, Box2i({20, 5}, {89, 70}), std::move(layers), {}, {}};
}

std::vector<float> numbers(int channels, float scale = 1.F) {
  std::vector<float> values(static_cast<std::size_t>(kFileWidth * kFileHeight * channels));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = scale * std::exp(std::sin(static_cast<float>(i)) * 20.F);
  return values;
}

void expect_same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(std::bit_cast<std::uint32_t>(a[i]), std::bit_cast<std::uint32_t>(b[i]))
        << "value " << i;
  }
}

TEST_F(ImageFile, ExrKeepsEveryLayerPlaceAndBit) {
  const auto beauty = numbers(3);
  const auto albedo = numbers(3, 0.1F);
  const auto depth = numbers(1, 1e-3F);
  Picture image = cropped({{"", 3, beauty}, {"albedo", 3, albedo}, {"depth", 1, depth}});
  image.metadata = {{"ajar:integrator", "pt"}, {"ajar:spp", "64"}};
  write_image(path("a.exr"), image);

  const Image read = read_image(path("a.exr"));
  EXPECT_EQ(read.origin, Vec2i(20, 5));
  EXPECT_EQ(read.resolution, Vec2i(100, 80));
  EXPECT_EQ(read.width, kFileWidth);
  EXPECT_EQ(read.height, kFileHeight);
  EXPECT_EQ(read.channels, 7);
  EXPECT_FALSE(read.is_display_encoded);
  expect_same_bits(read.rgb(), beauty);
  expect_same_bits(read.rgb("albedo"), albedo);
  const auto grey = read.rgb("depth");
  ASSERT_EQ(grey.size(), beauty.size());
  for (std::size_t i = 0; i < depth.size(); ++i) ASSERT_EQ(grey[i * 3 + 1], depth[i]);
  EXPECT_TRUE(read.rgb("normal").empty());
  EXPECT_EQ(files(), 1U) << "no temporary file is left";
  EXPECT_EQ(read.metadata.at("integrator"), "pt");
  const Imf::InputFile file(path("a.exr").c_str());
  EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("ajar:spp").value(), "64");
}

TEST_F(ImageFile, PfmKeepsEveryBit) {
  const auto values = numbers(3);
  write_image(path("a.pfm"), cropped({{"", 3, values}}));
  const Image read = read_image(path("a.pfm"));
  EXPECT_EQ(read.width, kFileWidth);
  EXPECT_EQ(read.height, kFileHeight);
  expect_same_bits(read.data, values);
}

TEST_F(ImageFile, PfmReadsGreyOfEitherByteOrder) {
  std::ofstream(path("grey.pfm"), std::ios::binary) << "Pf\n1 2\n1.0\n"
                                                    << std::string("\x3f\x80\0\0\x40\0\0\0", 8);
  const Image read = read_image(path("grey.pfm"));
  EXPECT_EQ(read.data, (std::vector<float>{2.F, 1.F})) << "rows come from the bottom";
  EXPECT_EQ(read.rgb().size(), 6U);
}

TEST_F(ImageFile, HdrKeepsWhatItsFormatCan) {
  auto values = numbers(3);
  write_image(path("a.hdr"), cropped({{"", 3, values}}));
  const Image read = read_image(path("a.hdr"));
  ASSERT_EQ(read.data.size(), values.size());
  for (std::size_t i = 0; i < values.size(); i += 3) {
    const float largest = std::max({values[i], values[i + 1], values[i + 2]});
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_NEAR(read.data[i + c], values[i + c], largest / 128.F);
  }
}

TEST_F(ImageFile, PngAndJpegHoldValuesAsTheyAreShown) {
  std::vector<float> values(static_cast<std::size_t>(kFileWidth * kFileHeight * 3), 0.5F);
  for (const char* name : {"a.png", "a.JPG", "a.jpeg"}) {
    write_image(path(name), cropped({{"", 3, values}}));
    const Image read = read_image(path(name));
    EXPECT_TRUE(read.is_display_encoded);
    ASSERT_EQ(read.data.size(), values.size()) << name;
    EXPECT_NEAR(read.data[300], 0.5F, 1.5F / 255.F) << name;
  }
}

TEST_F(ImageFile, NanDoesNoHarm) {
  auto values = numbers(3);
  values[0] = std::nanf("");
  values[4] = std::numeric_limits<float>::infinity();
  values[8] = -std::numeric_limits<float>::infinity();
  for (const char* name : {"n.exr", "n.pfm", "n.hdr", "n.png", "n.jpg"}) {
    ASSERT_NO_THROW(write_image(path(name), cropped({{"", 3, values}}))) << name;
    ASSERT_EQ(read_image(path(name)).data.size(), values.size()) << name;
  }
  expect_same_bits(read_image(path("n.exr")).rgb(), values);
  EXPECT_EQ(read_image(path("n.png")).data[0], 0.F);
  EXPECT_EQ(read_image(path("n.png")).data[4], 1.F);
  EXPECT_EQ(read_image(path("n.hdr")).data[8], 0.F);
}

TEST_F(ImageFile, UnknownExtensionListsTheValidOnes) {
  for (const char* name : {"a.bmp", "a", "a.exr.gz"}) {
    try {
      check_image_extension(name);
      FAIL() << name;
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find(".exr, .png"), std::string::npos) << error.what();
    }
  }
  EXPECT_NO_THROW(check_image_extension("A.EXR"));
}

TEST_F(ImageFile, MissingFolderIsExplained) {
  const auto values = numbers(3);
  for (const char* name : {"no/such/a.exr", "no/such/a.png", "no/such/a.pfm"}) {
    try {
      write_image(path(name), cropped({{"", 3, values}}));
      FAIL() << name;
    } catch (const IoError& error) {
      EXPECT_NE(std::string(error.what()).find("there is no folder"), std::string::npos)
          << error.what();
    }
  }
}

TEST_F(ImageFile, ProtectedPlacesAreRefused) {
  // /proc takes no new files even from root.
  if (!fs::exists("/proc/self")) GTEST_SKIP() << "needs /proc";
  EXPECT_THROW(write_image("/proc/a.png", cropped({{"", 3, numbers(3)}})), IoError);
  fs::create_directory(path("folder.png"));
  EXPECT_THROW(write_image(path("folder.png"), cropped({{"", 3, numbers(3)}})), IoError);
}

/// While it lives, no file of this process can grow beyond 1 kB, as on a disk that is full.
class FullDisk {
 public:
  FullDisk() : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    rlimit limit = old_;
    limit.rlim_cur = 512;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_{};
  void (*old_handler_)(int);
};

TEST_F(ImageFile, FullDiskLeavesThePreviousFile) {
  const auto values = numbers(3);
  for (const char* name : {"f.exr", "f.png", "f.pfm", "f.hdr", "f.jpg"}) {
    write_image(path(name), cropped({{"", 3, values}}));
    const std::string before = content(path(name));
    bool refused = false;
    {
      const FullDisk full;
      try {
        write_image(path(name), cropped({{"", 3, numbers(3, 2.F)}}));
      } catch (const IoError&) {
        refused = true;
      }
    }
    EXPECT_TRUE(refused) << name;
    EXPECT_EQ(content(path(name)), before) << name;
  }
  EXPECT_EQ(files(), 5U) << "no temporary file is left";
}

TEST_F(ImageFile, ReadErrorsAreExplained) {
  EXPECT_THROW(read_image(path("missing.exr")), IoError);
  EXPECT_THROW(read_image(path("missing.pfm")), IoError);
  EXPECT_THROW(read_image(path(".")), IoError);
  for (const char* name :
       {"empty.exr", "empty.png", "empty.pfm", "empty.hdr", "empty.jpg", "empty.xyz"}) {
    std::ofstream(path(name)).flush();
    EXPECT_THROW(read_image(path(name)), IoError) << name;
  }
}

TEST_F(ImageFile, TruncatedFilesAreErrorsNotCrashes) {
  const auto values = numbers(3);
  for (const char* name : {"t.exr", "t.pfm", "t.hdr"}) {
    write_image(path(name), cropped({{"", 3, values}}));
    const std::string whole = content(path(name));
    for (const std::size_t size :
         {std::size_t{3}, std::size_t{20}, whole.size() / 2, whole.size() - 5}) {
      std::ofstream(path(name), std::ios::binary | std::ios::trunc) << whole.substr(0, size);
      EXPECT_THROW(read_image(path(name)), IoError) << name << " cut to " << size;
    }
  }
}

TEST_F(ImageFile, AbsurdPfmHeadersAreRefused) {
  for (const char* header : {"PF\n-1 4\n-1\n", "PF\n1e9 1e9\n-1\n", "PF\nx y\n-1\n",
                             "PF\nnan 1\n-1\n", "PF\n1048576 1048576\n-1\n", "PG\n1 1\n-1\n"}) {
    std::ofstream(path("bad.pfm"), std::ios::binary | std::ios::trunc)
        << header << "some bytes that follow";
    EXPECT_THROW(read_image(path("bad.pfm")), IoError) << header;
  }
}

}  // namespace
}  // namespace ajar
