#include "os/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>

#include "core/error.h"

namespace ajar {
namespace {
namespace fs = std::filesystem;

class AtomicFile : public ::testing::Test {
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
    write_file_atomically(path, text);
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

TEST_F(AtomicFile, DanglingLinksAreKept) {
  fs::create_directory(path("disk"));
  fs::create_symlink("disk/a.txt", path("second"));
  fs::create_symlink("second", path("first"));
  write(path("first"), "one");
  EXPECT_TRUE(fs::is_symlink(path("first")));
  EXPECT_TRUE(fs::is_symlink(path("second")));
  EXPECT_EQ(read(path("disk/a.txt")), "one");
  fs::create_symlink("circle", path("circle"));
  EXPECT_THROW(write(path("circle"), "one"), IoError);
}

TEST_F(AtomicFile, DoesNotWriteThroughAFileAtTheTemporaryName) {
  write(path("victim"), "untouched");
  write(path("other process"), "its part");
  const std::string used = temporary_path(path("a.txt")).filename().string();
  const std::string start = used.substr(0, used.find('.', used.find('.', 1) + 1) + 1);
  const int number = std::stoi(used.substr(start.size()));
  for (int next = number + 1; next < number + 5; ++next) {
    const fs::path name = path(start + std::to_string(next) + ".partial");
    if (next % 2 == 0) fs::create_symlink("victim", name);
    if (next % 2 == 1) fs::copy_file(path("other process"), name);
  }
  write(path("a.txt"), "one");
  EXPECT_EQ(read(path("a.txt")), "one");
  EXPECT_FALSE(fs::is_symlink(path("a.txt")));
  EXPECT_EQ(read(path("victim")), "untouched");
  EXPECT_EQ(files(), 3U + 4U) << "all is where it was";
}

TEST_F(AtomicFile, NamesMayHaveTheGreatestLength) {
  for (std::size_t size = 200; size <= 255; size += size < 240 ? 20 : 1) {
    const fs::path name = path(std::string(size - 4, 'n') + ".txt");
    EXPECT_NO_THROW(check_file_can_be_written(name)) << size;
    EXPECT_NO_THROW(write(name, "one")) << size;
    EXPECT_EQ(read(name), "one") << size;
  }
  try {
    check_file_can_be_written(path(std::string(256, 'n')));
    FAIL();
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("it has 256 bytes, of at most 255"), std::string::npos)
        << error.what();
  }
}

TEST_F(AtomicFile, CheckFindsTheErrorsOfWritingAndLeavesNoFile) {
  EXPECT_NO_THROW(check_file_can_be_written(path("a.txt")));
  EXPECT_EQ(files(), 0U);
  write(path("a.txt"), "one");
  EXPECT_NO_THROW(check_file_can_be_written(path("a.txt")));
  EXPECT_EQ(read(path("a.txt")), "one");
  EXPECT_EQ(files(), 1U);
  for (const fs::path& wrong :
       {path("none/a.txt"), path("a.txt/b.txt"), path("."), path(""), fs::path()}) {
    EXPECT_THROW(check_file_can_be_written(wrong), IoError) << wrong;
    EXPECT_THROW(write(wrong, "one"), IoError) << wrong;
  }
}

TEST_F(AtomicFile, WriteProtectedFilesStayAsTheyAre) {
  write(path("a.txt"), "one");
  fs::permissions(path("a.txt"), fs::perms::owner_read | fs::perms::others_read);
  fs::permissions(path("."), fs::perms::all);
  // A user without permission.
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && setuid(kNobody) != 0) _exit(2);
    int refusals = 0;
    for (const auto& attempt : {+[](const fs::path& file) { write(file, "two"); },
                                +[](const fs::path& file) { check_file_can_be_written(file); }}) {
      try {
        attempt(path("a.txt"));
      } catch (const IoError&) {
        ++refusals;
      }
    }
    _exit(refusals == 2 ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(read(path("a.txt")), "one");
  EXPECT_EQ(files(), 1U);
}

TEST_F(AtomicFile, FilesOfKilledProcessesAreRemoved) {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  int status = 0;
  waitpid(child, &status, 0);
  const auto part_of = [&](const std::string& name, pid_t process) {
    std::string part = temporary_path(path(name)).filename().string();
    const std::string own = "." + std::to_string(getpid()) + ".";
    part.replace(part.find(own), own.size(), "." + std::to_string(process) + ".");
    std::ofstream(path(part)) << "part";
    return path(part);
  };
  for (const std::string& name : {std::string("a.txt"), std::string(255, 'n')}) {
    const fs::path dead = part_of(name, child);
    const fs::path living = part_of(name, getppid());
    const fs::path other = part_of("b.txt", child);
    remove_abandoned_parts(path(name));
    EXPECT_FALSE(fs::exists(dead));
    EXPECT_TRUE(fs::exists(living));
    EXPECT_TRUE(fs::exists(other));
  }
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
