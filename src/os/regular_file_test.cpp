#include "os/regular_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "os/available_memory.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

/// A folder of its own that is gone after the test.
class RegularFile : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  fs::path folder_ = fs::temp_directory_path() / ("ajar-regular-file-" + std::to_string(getpid()));
};

std::string refusal_of(const std::string& path) {
  try {
    read_file(path);
  } catch (const IoError& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(RegularFile, IsReadToItsEnd) {
  const std::string content("a\0b\n", 4);
  std::ofstream(path("file"), std::ios::binary) << content;
  std::ofstream(path("empty")).flush();
  fs::create_symlink("file", path("link"));
  EXPECT_EQ(read_file(path("file")).view(), content);
  EXPECT_EQ(read_file(path("link")).view(), content);
  EXPECT_EQ(read_file(path("empty")).view(), "");
  EXPECT_EQ(reading_complaint(path("link")), "");
}

TEST_F(RegularFile, IsTheOnlyKindThatIsRead) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", path("zero"));
  const std::pair<std::string, std::string> kinds[] = {{path("pipe"), "it is a named pipe"},
                                                       {path("zero"), "it is a device"},
                                                       {folder_.string(), "it is a folder"}};
  for (const auto& [name, kind] : kinds) {
    EXPECT_EQ(reading_complaint(name), kind + ", and only regular files can be read");
    EXPECT_EQ(refusal_of(name), "cannot read \"" + name + "\": " + reading_complaint(name));
  }
  EXPECT_EQ(refusal_of(path("absent")),
            "cannot open \"" + path("absent") + "\": No such file or directory");
  EXPECT_EQ(reading_complaint(path("absent")), "No such file or directory");
}

TEST_F(RegularFile, LargerThanTheMemoryIsRefusedBeforeItIsRead) {
  std::ofstream(path("holes")).flush();
  // More than any machine has, and nothing on the disk.
  std::error_code error;
  fs::resize_file(path("holes"), std::uintmax_t{1} << 43U, error);
  if (error) GTEST_SKIP() << "this file system has no files with holes";
  EXPECT_NE(refusal_of(path("holes")).find("needs 8796.1 GB of memory, and "), std::string::npos);
}

TEST(AvailableMemory, FitsSmallRequestsOnly) {
  EXPECT_EQ(memory_shortage(1000), "");
  EXPECT_NE(memory_shortage(std::uint64_t{1} << 60U), "");
  EXPECT_TRUE(fits_into_memory(94, 100));
  EXPECT_FALSE(fits_into_memory(96, 100));
  EXPECT_TRUE(fits_into_memory(96, 0)) << "unknown";
}

}  // namespace
}  // namespace ajar
