#include "study/json_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"

namespace ajar::study {
namespace {

namespace fs = std::filesystem;

/// Error of reading the text, without the file's name; or the result.
std::string read(const std::string& text) {
  const std::string path =
      (fs::temp_directory_path() / ("ajar-json-" + std::to_string(getpid()) + ".json")).string();
  std::ofstream(path, std::ios::binary) << text;
  std::string result = "no error";
  try {
    JsonNode::read_file(path);
  } catch (const UsageError& error) {
    result = error.what();
    EXPECT_TRUE(result.starts_with(path)) << result;
    result.erase(0, path.size());
  }
  fs::remove(path);
  return result;
}

TEST(JsonNode, NumbersThatAreTooLargeHaveAPlace) {
  EXPECT_EQ(read("{\"a\": 1,\n \"b\": 1e309}"),
            ":2:7: the number 1e309 is too large; at most 1.7e308");
  EXPECT_EQ(read("[-1e999 ]"), ":1:2: the number -1e999 is too large; at most 1.7e308");
  EXPECT_EQ(read("[1e308, 1e-400, 123456789012345678901234567890]"), "no error");
}

TEST(JsonNode, DuplicateMembersAreErrors) {
  EXPECT_EQ(read("{\"a\": {\"b\": 1}, \"b\": [{\"a\": 1}, {\"a\": 2}]}"), "no error");
  EXPECT_EQ(read("{\"a\": 1,\n  \"b\": 2,\n  \"a\": 3}"), ":3:3: the member \"a\" is there twice");
}

TEST(JsonNode, PlacesAreNotRepeated) {
  const JsonNode node(1, "a.json", "scale");
  try {
    node.check([&] { node.text(); });
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "a.json: scale: expects a text \"…\"");
  }
}

TEST(JsonNode, NestingIsLimited) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + "1" + std::string(depth, ']');
  };
  EXPECT_EQ(read(nested(64)), "no error");
  EXPECT_EQ(read(nested(65)), ":1:65: values are nested more than 64 deep");
  EXPECT_EQ(read(nested(1'000'000)), ":1:65: values are nested more than 64 deep");
}

TEST(JsonNode, SyntaxErrorsHaveAPlace) {
  EXPECT_EQ(read("").substr(0, 23), ":1:1: this is not JSON:");
  for (const char* text : {"{\"a\": NaN}", "{\"a\": Infinity}", "{\"a\": \"\xff\"}", "{\"a\" 1}"}) {
    const std::string error = read(text);
    EXPECT_TRUE(error.starts_with(":1:")) << text << error;
    EXPECT_NE(error.find("this is not JSON"), std::string::npos) << text << error;
  }
}

}  // namespace
}  // namespace ajar::study
