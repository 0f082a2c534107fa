// Runs a fuzz target once on each file of its corpus, as any compiler can. The environment names
// the folder (AJAR_FUZZ_CORPUS), so that this is compiled once for all targets.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {
namespace fs = std::filesystem;

std::vector<fs::path> corpus() {
  std::vector<fs::path> files;
  const char* folder = std::getenv("AJAR_FUZZ_CORPUS");
  if (folder == nullptr) return files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class Corpus : public testing::TestWithParam<fs::path> {};

TEST_P(Corpus, IsReadOrRefused) {
  SCOPED_TRACE(GetParam().string());
  std::ifstream file(GetParam(), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  // Exact size, so that sanitizers see reads beyond.
  const std::vector<std::uint8_t> input(bytes.begin(), bytes.end());
  EXPECT_EQ(LLVMFuzzerTestOneInput(input.data(), input.size()), 0);
}

TEST(Corpora, AreNamedByTheEnvironment) { EXPECT_FALSE(corpus().empty()); }

TEST(Nothing, IsReadOrRefused) { EXPECT_EQ(LLVMFuzzerTestOneInput(nullptr, 0), 0); }

INSTANTIATE_TEST_SUITE_P(Files, Corpus, testing::ValuesIn(corpus()), [](const auto& one) {
  // Letters, digits and '_' are allowed in names of tests.
  std::string name = one.param.filename().string();
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
});

}  // namespace
