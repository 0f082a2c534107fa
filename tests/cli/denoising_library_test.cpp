#include <stdlib.h>
#include <sys/stat.h>

#include <cstddef>
#include <iterator>

#include "cli/cli_fixture.h"
#include "post/testing/loaded_library.h"

/// Any file in place of Open Image Denoise leaves the render running, with a message why it is not
/// used.
namespace ajar {
namespace {

class DenoisingLibrary : public Cli {
 protected:
  Outcome with_library(const fs::path& library, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"-s", "KILL", "60", AJAR_PROGRAM});
    return finish(
        start(arguments, "/usr/bin/timeout", [&] { ::setenv("AJAR_OIDN", library.c_str(), 1); }));
  }
  void expect_passed_over(const fs::path& library, const std::string& why) const {
    const std::vector<std::string> arguments = {
        "render", "builtin:cornell", "--resolution", "8x6", "--spp", "1", "--integrator",
        "pt",     "--progress",      "none",         "-o",  "a.exr"};
    const Outcome outcome = with_library(library, arguments);
    EXPECT_EQ(outcome.exit_code, 0) << library << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "Open Image Denoise 2 is not found")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, why)) << outcome.err;
    std::vector<std::string> by_name = arguments;
    by_name.insert(by_name.end(), {"--denoise", "oidn"});
    const Outcome refused = with_library(library, by_name);
    EXPECT_EQ(refused.exit_code, 2) << library << refused.err;
    EXPECT_TRUE(contains(refused.err, why)) << refused.err;
  }
};

TEST_F(DenoisingLibrary, IsSkippedIfItIsNoLibrary) {
  ASSERT_EQ(mkfifo(file("pipe.so").c_str(), 0600), 0);
  expect_passed_over(file("pipe.so"), "it is a named pipe");
  std::ofstream(file("empty.so")).close();
  expect_passed_over(file("empty.so"), "it is empty");
  expect_passed_over(file("text.so", "INPUT(libOpenImageDenoise.so.2)\n"), "it is no library");
  fs::create_symlink("loop.so", file("loop.so"));
  expect_passed_over(file("loop.so"), "Too many levels of symbolic links");
  expect_passed_over("/dev/null", "it is a device");
  expect_passed_over(file("none.so"), "none.so");
  fs::create_directories(file("folder") / "libOpenImageDenoise.so.2");
  expect_passed_over(file("folder"), "it is a folder");
}

TEST_F(DenoisingLibrary, IsSkippedIfAPartIsTruncated) {
  const fs::path library = testing::loaded_library();
  if (library.empty()) GTEST_SKIP() << "no library to cut";
  expect_passed_over(library, "has not the functions of version 2");
  std::ifstream whole(library, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(whole), std::istreambuf_iterator<char>()};
  for (const std::size_t length :
       {std::size_t{200}, std::size_t{5000}, bytes.size() / 2, bytes.size() - 1}) {
    std::ofstream(file("cut.so"), std::ios::binary) << bytes.substr(0, length);
    expect_passed_over(file("cut.so"), "it is cut short");
  }
  // The library that it would load by itself.
  fs::create_directories(file("lib"));
  fs::copy_file(library, file("lib") / "libOpenImageDenoise.so.2");
  for (const char* part :
       {"libOpenImageDenoise_core.so.2.5.1", "libOpenImageDenoise_device_cpu.so.2.5.1"}) {
    std::ofstream(file("lib") / part, std::ios::binary) << bytes.substr(0, bytes.size() / 2);
    expect_passed_over(file("lib"), std::string(part) + ": it is cut short");
    fs::remove(file("lib") / part);
  }
}

}  // namespace
}  // namespace ajar
