#include "core/exr_header.h"

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

std::string window(std::uint32_t last_row) {
  return attribute("dataWindow", "box2i", 16, number(0) + number(0) + number(7) + number(last_row));
}

class ExrHeader : public testing::Test {
 protected:
  void TearDown() override { fs::remove(path_); }
  /// Of a file with these attributes and some pixels.
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
  EXPECT_EQ(complaint(attribute("owner", "string", 4, "Mary") + window(1023)), "");
}

TEST_F(ExrHeader, AttributesLargerThanTheFileAreTold) {
  for (const std::uint32_t size : {1000U, 1718188051U, 0xffffffffU}) {
    const std::string text = complaint(window(7) + attribute("owner", "string", size, "Mary"));
    EXPECT_NE(text.find(std::to_string(size) + " bytes for \"owner\""), std::string::npos) << text;
  }
}

TEST_F(ExrHeader, MoreRowsThanBytesCouldHoldAreTold) {
  EXPECT_NE(complaint(window(0x7ffffffe)).find("2147483647 rows"), std::string::npos);
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
