// Fixtures of the tests of glTF; in a file of tests, so that only their program has it.
#include "import/gltf/gltf_test_support.h"

#include <regex>

#include "import/gltf/uri.h"

namespace ajar::gltf {

std::string encode_base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const unsigned byte = i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U;
      bits = bits << 8U | byte;
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text += i + j <= bytes.size() ? kDigits[bits >> (18 - 6 * j) & 63U] : '=';
    }
  }
  return text;
}

std::size_t TestFile::add(const char* array, Json value) {
  json[array].push_back(std::move(value));
  return json[array].size() - 1;
}

std::size_t TestFile::add_view(const std::string& bytes, std::size_t stride) {
  Json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
  if (stride > 0) view["byteStride"] = stride;
  binary_ += bytes;
  return add("bufferViews", std::move(view));
}

std::size_t TestFile::add_accessor(const std::string& bytes, int component_type, const char* type,
                                   std::size_t count, std::size_t stride) {
  return add("accessors", {{"bufferView", add_view(bytes, stride)},
                           {"componentType", component_type},
                           {"type", type},
                           {"count", count}});
}

Json TestFile::triangle() {
  const std::size_t positions =
      add_accessor(bytes_of<float>({0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}), 5126, "VEC3", 3);
  const std::size_t uvs =
      add_accessor(bytes_of<float>({0.F, 0.F, 1.F, 0.F, 0.F, 1.F}), 5126, "VEC2", 3);
  return {{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uvs}}}};
}

std::size_t TestFile::add_triangle(Json material) {
  Json primitive = triangle();
  primitive["material"] = add("materials", std::move(material));
  const std::size_t mesh = add("meshes", {{"primitives", Json::array({primitive})}});
  return add("nodes", {{"mesh", mesh}});
}

Json TestFile::with_buffer(bool with_uri) const {
  Json whole = json;
  if (binary_.empty()) return whole;
  Json buffer = {{"byteLength", binary_.size()}};
  if (with_uri) {
    buffer["uri"] = "data:application/octet-stream;base64," + encode_base64(binary_);
  }
  whole["buffers"] = Json::array({buffer});
  return whole;
}

std::string TestFile::text() const { return with_buffer(true).dump(); }

std::string TestFile::glb() const {
  std::string chunk = with_buffer(false).dump();
  while (chunk.size() % 4 != 0) chunk += ' ';
  std::string binary = binary_;
  while (binary.size() % 4 != 0) binary += '\0';
  const auto number = [](std::size_t value) {
    return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(value)});
  };
  const std::size_t length = 12 + 8 + chunk.size() + (binary.empty() ? 0 : 8 + binary.size());
  std::string bytes = "glTF" + number(2) + number(length) + number(chunk.size()) + "JSON" + chunk;
  if (!binary.empty()) bytes += number(binary.size()) + std::string("BIN\0", 4) + binary;
  return bytes;
}

desc::SceneDesc import_with(const std::string& bytes, Warnings& warnings, const Files& files) {
  return import_gltf_bytes(bytes, "test.gltf", "/scene", warnings, provider_of(files));
}

desc::SceneDesc scene_of(const TestFile& file) {
  Warnings warnings;
  desc::SceneDesc scene = import_with(file.text(), warnings);
  expect_none(warnings);
  return scene;
}

std::string without_places(const std::string& messages) {
  static const std::regex kPlace("test\\.gltf:[0-9]+:[0-9]+");
  return std::regex_replace(messages, kPlace, "test.gltf");
}

std::string error_of(const std::string& bytes) {
  return without_places(error_in([&](Warnings& warnings) { import_with(bytes, warnings); }));
}

std::string warnings_of(const TestFile& file) {
  return without_places(
      warnings_in([&](Warnings& warnings) { import_with(file.text(), warnings); }));
}

desc::Node only_material(const Json& material) {
  TestFile file;
  file.add_triangle(material);
  const desc::SceneDesc scene = scene_of(file);
  return scene.materials.at(static_cast<std::size_t>(scene.shapes.front().material)).node;
}

namespace {

TEST(Base64, IsDecodedWithAndWithoutPadding) {
  EXPECT_EQ(decode_base64("TWFu"), "Man");
  EXPECT_EQ(decode_base64("TWE="), "Ma");
  EXPECT_EQ(decode_base64("TQ"), "M");
  EXPECT_EQ(decode_base64(""), "");
  EXPECT_FALSE(decode_base64("TWF*"));
  EXPECT_FALSE(decode_base64("TWFuT"));
  EXPECT_EQ(encode_base64("Ma"), "TWE=");
}

}  // namespace
}  // namespace ajar::gltf
