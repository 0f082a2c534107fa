#include "import/gltf/document.h"

#include "import/gltf/gltf_test_support.h"

namespace ajar::gltf {
namespace {

TEST(GltfDocument, SyntaxErrorsHaveLineAndColumn) {
  const std::string error = error_of("{\n  \"asset\": {\"version\": \"2.0\"},\n  \"nodes\": [}\n}");
  EXPECT_EQ(error.rfind("test.gltf:3:13: this is not valid JSON: ", 0), 0U) << error;
}

TEST(GltfDocument, NumbersBeyondDoublesAreErrors) {
  EXPECT_TRUE(contains(error_of(R"({"asset": {"version": "2.0"}, "scene": 1e999})"),
                       "this is not valid JSON: "));
}

TEST(GltfDocument, MustBeOfVersionTwo) {
  EXPECT_EQ(error_of(R"({"asset": {"version": "1.0"}})"),
            "test.gltf#/asset/version: this is glTF 1.0; only glTF 2 can be read");
  EXPECT_EQ(error_of("{}"), "test.gltf: there is no \"asset\" here");
  EXPECT_EQ(error_of("[]"), "test.gltf: this must be an object, not array");
}

TEST(GltfDocument, DeepNestingIsNoProblem) {
  const std::string deep(1'000'000, '[');
  EXPECT_TRUE(contains(error_of(deep), "not valid JSON"));
  EXPECT_EQ(error_of(R"({"asset": {"version": "2.0"}, "extras": )" + deep +
                     std::string(1'000'000, ']') + "}"),
            "no error");
}

TEST(GltfDocument, ContainersThatAreDamagedSayWhere) {
  TestFile file;
  file.add_triangle();
  const std::string bytes = file.glb();
  EXPECT_EQ(error_of(bytes), "no error");
  for (std::size_t size = 4; size < bytes.size(); size += 7) {
    EXPECT_TRUE(contains(error_of(bytes.substr(0, size)), "the file ends")) << size;
  }
  std::string other = bytes;
  other[4] = 1;
  EXPECT_TRUE(contains(error_of(other), "container of version 1"));
  std::string beyond = bytes;
  beyond[14] = 1;  // the length of the first chunk
  EXPECT_TRUE(contains(error_of(beyond), "reaches beyond the end"));
}

TEST(GltfDocument, ContainerAndTextGiveTheSameScene) {
  TestFile file;
  file.add_triangle();
  Warnings warnings;
  EXPECT_EQ(desc::hash(import_with(file.glb(), warnings)),
            desc::hash(import_with(file.text(), warnings)));
}

}  // namespace
}  // namespace ajar::gltf
