#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>

/// The library reads and writes numbers alike in every locale of its host: nothing that follows
/// LC_NUMERIC or std::locale (docs/develop/style.md, "Code").
namespace ajar {
namespace {

namespace fs = std::filesystem;

/// Files that may use string streams or C formats: no number with a point or a separator reaches a
/// picture or a file by these.
const std::map<std::string, std::string>& excused() {
  static const std::map<std::string, std::string> kExcused = {
      {"imageio/formats/tiff_decoder.cpp", "libtiff hands over messages as format and arguments"},
      {"apps/cli/command_line.cpp", "help"},
      {"core/archive.h", "bytes"},
      {"os/available_memory.cpp", "whole numbers of the kernel, without separators"},
      {"import/obj/library.cpp", "bytes for a library that parses them itself"},
      {"study/comparison_report.cpp", "lines"},
      {"study/machine.cpp", "a whole file"}};
  return kExcused;
}

bool only_tests_use(const std::string& file) {
  return file.ends_with("_test.cpp") || file.find("test_support") != std::string::npos ||
         file.find("/testing/") != std::string::npos;
}

TEST(Locale, IsIgnored) {
  const fs::path src = fs::path(AJAR_SOURCE_DIR) / "src";
  const std::regex functions(
      R"(\b(stof|stod|stold|strtof|strtod|strtold|atof|v?f?s?n?printf|v?f?s?scanf|setlocale|localeconv|imbue)\s*\()");
  const std::regex streams(R"(\b[io]?stringstream\b)");
  std::size_t files = 0;
  std::map<std::string, std::string> unused = excused();
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(src)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".h" && extension != ".cpp") continue;
    const std::string file = fs::relative(entry.path(), src).generic_string();
    if (only_tests_use(file)) continue;
    ++files;
    std::ifstream text(entry.path());
    int number = 0;
    for (std::string line; std::getline(text, line);) {
      ++number;
      if (!std::regex_search(line, functions) && !std::regex_search(line, streams)) continue;
      EXPECT_TRUE(excused().contains(file))
          << file << ":" << number << ": " << line << "\nuse core/number_text.h or fmt";
      unused.erase(file);
    }
  }
  EXPECT_GT(files, 300U);
  for (const auto& [file, reason] : unused) ADD_FAILURE() << file << " needs no excuse";
}

}  // namespace
}  // namespace ajar
