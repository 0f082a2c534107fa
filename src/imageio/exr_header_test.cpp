#include "imageio/exr_header.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace ajar {
namespace {

namespace fs = std::filesystem;

std::string number(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i));
  return bytes;
}

std::string attribute(const std::string& name, const std::string& type, std::uint32_t size,
                      const std::string& value) {
  return name + '\0' + type + '\0' + number(size) + value;
}

std::string window(std::uint32_t last_row, std::uint32_t last_column = 7) {
  return attribute("dataWindow", "box2i", 16,
                   number(0) + number(0) + number(last_column) + number(last_row));
}

std::string packed(char compression) {
  return attribute("compression", "compression", 1, std::string(1, compression));
}

/// Three channels of half numbers.
std::string colours() {
  std::string list;
  for (const char* name : {"B", "G", "R"}) {
    list += name + std::string(1, '\0') + number(1) + number(0) + number(1) + number(1);
  }
  list += '\0';
  return attribute("channels", "chlist", static_cast<std::uint32_t>(list.size()), list);
}

class ExrHeader : public ::testing::Test {
 protected:
  void TearDown() override { fs::remove(path_); }
  /// Error of a file with these attributes and some pixels.
  std::string complaint(const std::string& attributes, std::uint32_t flags = 2) {
    std::ofstream file(path_, std::ios::binary | std::ios::trunc);
    file << number(20000630) << number(flags) << attributes << '\0' << std::string(100, 'x');
    file.close();
    return exr_header_complaint(path_, fs::file_size(path_));
  }
  std::string path_ =
      (fs::temp_directory_path() / ("ajar-exr-header-" + std::to_string(getpid()))).string();
};

TEST_F(ExrHeader, OfAUsualFileIsFine) {
  EXPECT_EQ(complaint(attribute("owner", "string", 4, "Mary") + window(15) + packed(3) + colours()),
            "");
}

TEST_F(ExrHeader, AttributesLargerThanTheFileAreTold) {
  for (const std::uint32_t size : {1000U, 1718188051U, 0xffffffffU}) {
    const std::string text = complaint(window(7) + attribute("owner", "string", size, "Mary"));
    EXPECT_NE(text.find(std::to_string(size) + " bytes for \"owner\""), std::string::npos) << text;
  }
}

/// The library does not mind what is written there, and would read on elsewhere than we look.
TEST_F(ExrHeader, SizesThatAreNotThoseOfTheTypeAreTold) {
  EXPECT_NE(complaint(window(7) + attribute("compression", "compression", 3, "\3xx")), "");
  EXPECT_NE(complaint(attribute("dataWindow", "box2i", 20, std::string(20, '\0'))), "");
  EXPECT_EQ(complaint(window(7) + attribute("mine", "a type of mine", 3, "xyz")), "");
  const std::string list = "a name of many letters" + std::string(1, '\0') + number(1) + number(0) +
                           number(1) + number(1) + '\0';
  const auto size = static_cast<std::uint32_t>(list.size());
  EXPECT_EQ(complaint(window(7) + attribute("channels", "chlist", size, list)), "");
  EXPECT_NE(complaint(window(7) + attribute("channels", "chlist", size - 10, list)), "");
}

TEST_F(ExrHeader, MoreRowsThanBytesCouldHoldAreTold) {
  EXPECT_NE(complaint(window(0x7ffffffe)).find("8x2147483647 pixels"), std::string::npos);
}

/// Packing decides whether pixels fit: 250 bytes hold 41 raw pixels.
TEST_F(ExrHeader, MorePixelsThanBytesCouldHoldAreTold) {
  constexpr char kNone = 0, kRuns = 1, kZip = 3, kDwab = 9;
  const auto complains = [&](char compression, std::uint32_t width) {
    return !complaint(window(0, width - 1) + colours() + packed(compression)).empty();
  };
  EXPECT_FALSE(complains(kNone, 30));
  EXPECT_TRUE(complains(kNone, 60));
  EXPECT_FALSE(complains(kRuns, 60));
  EXPECT_TRUE(complains(kRuns, 5000));
  EXPECT_FALSE(complains(kZip, 5000));
  EXPECT_TRUE(complains(kZip, 100000));
  EXPECT_FALSE(complains(kDwab, 5000));
  EXPECT_TRUE(complains(kDwab, 16777216));
}

/// Tiles need few places in the table, where rows would need one each.
TEST_F(ExrHeader, OfTilesKnowsTheTableOfTiles) {
  constexpr char kZips = 2;
  const std::string high = window(9999, 3) + packed(kZips) + colours();
  const auto tiles = [](std::uint32_t width, std::uint32_t height) {
    return attribute("tiles", "tiledesc", 9, number(width) + number(height) + std::string(1, '\0'));
  };
  EXPECT_NE(complaint(high), "");
  EXPECT_EQ(complaint(high + tiles(4, 512)), "");
  EXPECT_NE(complaint(high + tiles(1, 1)), "");
  EXPECT_NE(complaint(high + tiles(0x7fffffff, 0x7fffffff)), "");
}

/// One row of eight million pixels in 250 bytes could just be, but 256 such rows are made room for.
TEST_F(ExrHeader, BlocksOfRowsThatNothingFillsAreTold) {
  EXPECT_NE(complaint(window(0, 2000000) + colours() + packed(9)), "");
}

TEST_F(ExrHeader, OfEveryPartIsLookedAt) {
  constexpr std::uint32_t kSeveralParts = 0x1002;
  const std::string first = window(7) + '\0';
  EXPECT_EQ(complaint(first + window(7) + '\0', kSeveralParts), "");
  EXPECT_NE(complaint(first + attribute("name", "string", 5000, "x"), kSeveralParts), "");
}

TEST_F(ExrHeader, WhatIsCutShortOrNoExrIsLeftToTheLibrary) {
  std::ofstream(path_) << "P6 this is no EXR";
  EXPECT_EQ(exr_header_complaint(path_, 17), "");
  for (const std::size_t length : {6U, 9U, 15U}) {
    std::ofstream(path_, std::ios::binary | std::ios::trunc)
        << (number(20000630) + number(2) + attribute("owner", "string", 4, "Mary"))
               .substr(0, length);
    EXPECT_EQ(exr_header_complaint(path_, length), "");
  }
  EXPECT_EQ(exr_header_complaint(path_ + "-missing", 0), "");
}

}  // namespace
}  // namespace ajar
