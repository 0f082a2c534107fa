#include "import/gltf/document.h"

#include "import/gltf/gltf_test_support.h"

namespace ajar::gltf {
namespace {

TEST(GltfDocument, SyntaxErrorsHaveLineAndColumn) {
  const std::string text = "{\n  \"asset\": {\"version\": \"2.0\"},\n  \"nodes\": [}\n}";
  const std::string error = error_in([&](Warnings& warnings) { import_with(text, warnings); });
  EXPECT_EQ(error.rfind("test.gltf:3:13: this is no JSON: ", 0), 0U) << error;
}

TEST(GltfDocument, MessagesHaveLineColumnAndElement) {
  const std::string text =
      "{\n  \"asset\": {\"version\": \"2.0\", \"b/d\": {}},\n  \"scene\": 0,\n"
      "  \"scenes\": [{\"nodes\": [0, 1]}, {\"nods\": [7]}],\n"
      "  \"nodes\": [{}, { \"mash\" : [[], 3, {\"x\": 1}] }],\n  \"asset\": {\"version\": "
      "\"2.0\"}\n}";
  const auto warnings_in_text = [](const std::string& bytes) {
    return warnings_in([&](Warnings& warnings) { import_with(bytes, warnings); });
  };
  const std::string warnings = warnings_in_text(text);
  for (const char* part : {"test.gltf:6:3: \"asset\" stands twice in this object: the last counts",
                           "test.gltf:4:34#/scenes/1: a scene has no member \"nods\"",
                           "test.gltf:4:13#/scenes: of these 2 scenes only number 0",
                           "test.gltf:5:19#/nodes/1: a node has no member \"mash\""}) {
    EXPECT_TRUE(contains(warnings, part)) << part << "\n" << warnings;
  }
  EXPECT_FALSE(contains(warnings, "b/d")) << "the first of the two is not looked into";
  // Offsets in a container count from its JSON.
  std::string padded = text;
  while (padded.size() % 4 != 0) padded += ' ';
  const auto number = [](std::size_t value) {
    return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(value)});
  };
  EXPECT_EQ(warnings_in_text("glTF" + number(2) + number(20 + padded.size()) +
                             number(padded.size()) + "JSON" + padded),
            warnings);
}

TEST(GltfDocument, DeepDuplicateMembersTakeLinearTime) {
  constexpr int kLevels = 20000;
  std::string text = R"({"asset": {"version": "2.0"}, "extras": )";
  for (int i = 0; i < kLevels; ++i) text += R"({"a": 0, "a": 0, "b": )";
  text += "0" + std::string(kLevels + 1, '}');
  const std::string warnings = warnings_in([&](Warnings& found) { import_with(text, found); });
  EXPECT_TRUE(contains(warnings, "\"a\" stands twice in this object: the last counts"));
  EXPECT_TRUE(contains(warnings, "19900 more members stand twice"));
}

TEST(GltfDocument, NumbersBeyondDoublesAreErrors) {
  EXPECT_TRUE(contains(error_of(R"({"asset": {"version": "2.0"}, "scene": 1e999})"),
                       "the number 1e999 is too large; at most 1.7e308"));
}

TEST(GltfDocument, MustBeOfVersionTwo) {
  EXPECT_EQ(error_of(R"({"asset": {"version": "1.0"}})"),
            "test.gltf#/asset/version: this is glTF 1.0; only glTF 2 can be read");
  EXPECT_EQ(error_of("{}"), "test.gltf: there is no \"asset\" here");
  EXPECT_EQ(error_of("[]"), "test.gltf: must be an object, not []");
}

TEST(GltfDocument, DeepNestingIsNoProblem) {
  const std::string deep(1'000'000, '[');
  EXPECT_TRUE(contains(error_of(deep), "this is no JSON"));
  EXPECT_EQ(error_of(R"({"asset": {"version": "2.0"}, "extras": )" + deep +
                     std::string(1'000'000, ']') + "}"),
            "no error");
}

TEST(GltfDocument, DamagedContainersAreLocatedErrors) {
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
