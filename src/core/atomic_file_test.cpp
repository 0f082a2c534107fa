#include "core/atomic_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>

#include "core/error.h"

namespace ajar {
namespace {
namespace fs = std::filesystem;

class AtomicFile : public testing::Test {
 protected:
  AtomicFile()
      : folder_(fs::temp_directory_path() / ("ajar_atomic_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path path(const std::string& name) const { return folder_ / name; }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  static void write(const fs::path& path, const std::string& text) {
    write_file_atomically(path, std::as_bytes(std::span(text)));
  }
  static std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

 private:
  fs::path folder_;
};

TEST_F(AtomicFile, WritesAndReplaces) {
  write(path("a.txt"), "one");
  EXPECT_EQ(read(path("a.txt")), "one");
  write(path("a.txt"), std::string(1 << 20, 'x'));
  EXPECT_EQ(read(path("a.txt")).size(), 1U << 20);
  write(path("a.txt"), "");
  EXPECT_EQ(read(path("a.txt")), "");
  EXPECT_EQ(files(), 1U);
}

TEST_F(AtomicFile, KeepsPermissionsAndLinks) {
  write(path("a.txt"), "one");
  fs::permissions(path("a.txt"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("a.txt", path("link"));
  write(path("link"), "two");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(read(path("a.txt")), "two");
  EXPECT_EQ(fs::status(path("a.txt")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(AtomicFile, OpenReadersKeepTheOldContent) {
  write(path("a.txt"), "one");
  std::ifstream reader(path("a.txt"));
  write(path("a.txt"), "two");
  std::string seen;
  reader >> seen;
  EXPECT_EQ(seen, "one");
}

TEST_F(AtomicFile, ExplainsFailures) {
  try {
    write(path("none/a.txt"), "one");
    FAIL();
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("there is no folder"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(write(path("."), "one"), IoError);
  EXPECT_THROW(write("", "one"), IoError);
  if (fs::exists("/dev/full")) {
    EXPECT_THROW(write("/dev/full", "one"), IoError);
  }
  if (fs::exists("/dev/null")) {
    EXPECT_NO_THROW(write("/dev/null", "one"));
  }
}

}  // namespace
}  // namespace ajar
