#include "post/denoise/library_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include "post/testing/loaded_library.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

class LibraryFile : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::string said(const std::string& content) const {
    const fs::path path = folder_ / "library.so";
    std::ofstream(path, std::ios::binary) << content;
    return library_complaint(path);
  }
  fs::path folder_ = fs::temp_directory_path() / ("ajar-library-" + std::to_string(getpid()));
};

TEST_F(LibraryFile, CompleteLibrariesAreAccepted) {
  const fs::path library = testing::loaded_library();
  if (library.empty()) GTEST_SKIP() << "linked into the program";
  EXPECT_EQ(library_complaint(library), "");
  fs::create_symlink(library, folder_ / "link.so");
  EXPECT_EQ(library_complaint(folder_ / "link.so"), "");
}

TEST_F(LibraryFile, TruncatedLibrariesAreRefused) {
  const fs::path library = testing::loaded_library();
  if (library.empty()) GTEST_SKIP() << "linked into the program";
  std::ifstream file(library, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  ASSERT_EQ(said(whole), "");
  const std::size_t size = whole.size();
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{1}, std::size_t{63}, std::size_t{64}, std::size_t{1000},
        std::size_t{4096}, size / 3, size / 2, size - 4096, size - 1}) {
    EXPECT_NE(said(whole.substr(0, length)), "") << length;
  }
  EXPECT_EQ(said(whole.substr(0, size / 2)), "it is cut short");
  // A download that made room for the whole of it.
  EXPECT_NE(said(whole.substr(0, size / 2) + std::string(size - size / 2, '\0')), "");
}

TEST_F(LibraryFile, OtherFilesAreRefused) {
  EXPECT_EQ(said(""), "it is empty");
  EXPECT_EQ(said("#!/bin/sh\n"), "it is no library");
  EXPECT_EQ(said(std::string(5000, '\0')), "it is no library");
  const fs::path library = testing::loaded_library();
  if (!library.empty()) {
    std::ifstream file(library, std::ios::binary);
    std::string other{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    ElfW(Half) machine = EM_68K;
    std::memcpy(other.data() + offsetof(ElfW(Ehdr), e_machine), &machine, sizeof(machine));
    EXPECT_EQ(said(other), "it is for another kind of processor");
  }
  const auto complaint = [&](const char* name) { return library_complaint(folder_ / name); };
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_NE(complaint("pipe").find("named pipe"), std::string::npos);
  EXPECT_NE(library_complaint(folder_).find("folder"), std::string::npos);
  EXPECT_NE(library_complaint("/dev/zero").find("device"), std::string::npos);
  EXPECT_NE(complaint("none"), "");
  fs::create_symlink("b", folder_ / "a");
  fs::create_symlink("a", folder_ / "b");
  EXPECT_NE(complaint("a"), "");
}

}  // namespace
}  // namespace ajar
