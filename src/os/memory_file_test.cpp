#include "os/memory_file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "os/regular_file.h"

namespace ajar {
namespace {

TEST(MemoryFile, IsARegularFileWithItsBytesWhileItLives) {
  const std::string bytes("a\0b\n", 4);
  std::string path;
  {
    const MemoryFile file(bytes);
    path = file.path();
    EXPECT_EQ(reading_complaint(path), "");
    EXPECT_EQ(read_file(path).view(), bytes);
    EXPECT_EQ(read_file(path).view(), bytes) << "the second time, too";
    EXPECT_EQ(std::filesystem::file_size(path), 4U);
  }
  EXPECT_NE(reading_complaint(path), "");
}

TEST(MemoryFile, MayBeEmpty) { EXPECT_EQ(read_file(MemoryFile("").path()).view(), ""); }

}  // namespace
}  // namespace ajar
