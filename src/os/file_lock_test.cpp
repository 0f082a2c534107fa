#include "os/file_lock.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/error.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

class FileLockTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              ("ajar-lock-" + std::string(test->name()) + "-" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(FileLockTest, IsExclusiveAndLeavesNoFile) {
  const fs::path lock_file = lock_file_of(folder_ / "room.checkpoint");
  {
    const FileLock lock(lock_file, "busy");
    EXPECT_THROW(FileLock(lock_file, "busy"), IoError);
    EXPECT_TRUE(fs::exists(lock_file));
  }
  EXPECT_TRUE(fs::is_empty(folder_));
  EXPECT_NO_THROW(FileLock(lock_file, "busy"));
}

TEST_F(FileLockTest, StaleFilesDoNotBlock) {
  const fs::path lock_file = lock_file_of(folder_ / "c");
  std::ofstream(lock_file) << "";
  EXPECT_NO_THROW(FileLock(lock_file, "busy"));
}

TEST_F(FileLockTest, DoesNotFollowAPlantedLink) {
  const fs::path lock_file = lock_file_of(folder_ / "c");
  fs::create_symlink(folder_ / "elsewhere", lock_file);
  const FileLock lock(lock_file, "busy");
  EXPECT_FALSE(fs::exists(folder_ / "elsewhere"));
}

TEST_F(FileLockTest, IsTheSameThroughALinkAndFitsForLongNames) {
  std::ofstream(folder_ / "c") << "x";
  fs::create_symlink("c", folder_ / "link");
  EXPECT_EQ(lock_file_of(folder_ / "link").filename(), lock_file_of(folder_ / "c").filename());
  const std::string a(255, 'a');
  std::string b = a;
  b.back() = 'b';
  EXPECT_LE(lock_file_of(folder_ / a).filename().string().size(), 255U);
  EXPECT_NE(lock_file_of(folder_ / a), lock_file_of(folder_ / b));
}

}  // namespace
}  // namespace ajar
