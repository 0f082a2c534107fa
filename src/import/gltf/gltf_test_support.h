#pragma once
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "import/gltf/document.h"
#include "import/gltf/gltf_import.h"
#include "import/testing/import_checks.h"

namespace ajar::gltf {

using Json = nlohmann::json;

/// The bytes of numbers, as they are in memory.
template <typename T>
std::string bytes_of(const std::vector<T>& numbers) {
  std::string bytes(numbers.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

std::string encode_base64(std::string_view bytes);

/// A file in the making: JSON, and one buffer.
class TestFile {
 public:
  Json json = Json::parse(R"({"asset": {"version": "2.0"}})");

  /// Each returns the index of the added element.
  std::size_t add_view(const std::string& bytes, std::size_t stride = 0);
  std::size_t add_accessor(const std::string& bytes, int component_type, const char* type,
                           std::size_t count, std::size_t stride = 0);
  std::size_t add(const char* array, Json value);
  /// Triangle with corners (0 0 0), (1 0 0), (0 1 0) and uv (0 0), (1 0), (0 1), in the mode
  /// "triangles".
  Json triangle();
  /// A mesh of one triangle with a material, and a node at the root that has it.
  std::size_t add_triangle(Json material = Json::object());

  std::string text() const;
  std::string glb() const;

 private:
  Json with_buffer(bool with_uri) const;
  std::string binary_;
};

/// Imports as "test.gltf", with files beside it.
desc::SceneDesc import_with(const std::string& bytes, Warnings& warnings, const Files& files = {});
/// Scene of a file, without any warning.
desc::SceneDesc scene_of(const TestFile& file);
/// Mesh of a shape that is one.
inline const desc::Mesh& mesh_of(const desc::SceneDesc& scene, std::size_t shape = 0) {
  return *scene.shapes.at(shape).node.mesh("mesh");
}
inline void expect_near(const Vec3& actual, const Vec3& expected) {
  EXPECT_LT(length(actual - expected), 1e-5F) << actual << " is not " << expected;
}
/// Messages without lines and columns, which in the text of a TestFile say little.
std::string without_places(const std::string& messages);
/// Message of the SceneError that importing raises, or "no error"; without its place.
std::string error_of(const std::string& bytes);
/// All warnings, one per line, without their places.
std::string warnings_of(const TestFile& file);

/// The material of the only triangle of a file with one.
desc::Node only_material(const Json& material);

}  // namespace ajar::gltf
