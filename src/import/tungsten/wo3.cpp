#include "import/tungsten/wo3.h"

#include <bit>
#include <cstring>

#include "core/error.h"

namespace ajar::tungsten {
namespace {

static_assert(std::endian::native == std::endian::little, "values are read as they are stored");

struct Vertex {
  float position[3];
  float normal[3];
  float uv[2];
};
struct Triangle {
  std::uint32_t vertices[3];
  std::int32_t material;
};
static_assert(sizeof(Vertex) == 32 && sizeof(Triangle) == 16);

class Cursor {
 public:
  Cursor(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  /// The number of records that follow, each of which takes bytes of the file.
  template <typename Record>
  std::size_t count(const char* what) {
    std::uint64_t count = 0;
    if (bytes_.size() < sizeof(count)) fail(std::string("there is no number of ") + what);
    std::memcpy(&count, bytes_.data(), sizeof(count));
    bytes_.remove_prefix(sizeof(count));
    if (count > bytes_.size() / sizeof(Record)) {
      fail("the file ends before its " + std::to_string(count) + " " + what);
    }
    return static_cast<std::size_t>(count);
  }
  template <typename Record>
  Record next() {
    Record record;
    std::memcpy(&record, bytes_.data(), sizeof(Record));
    bytes_.remove_prefix(sizeof(Record));
    return record;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw SceneError(name_ + ": this is no complete .wo3 mesh: " + reason);
  }

  std::string_view bytes_;
  const std::string& name_;
};

}  // namespace

Wo3Mesh read_wo3(std::string_view bytes, const std::string& name) {
  Cursor cursor(bytes, name);
  Wo3Mesh result;
  desc::Mesh& mesh = result.mesh;
  const std::size_t vertices = cursor.count<Vertex>("vertices");
  mesh.positions.reserve(vertices);
  mesh.normals.reserve(vertices);
  mesh.uvs.reserve(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    const auto v = cursor.next<Vertex>();
    mesh.positions.emplace_back(v.position[0], v.position[1], v.position[2]);
    mesh.normals.emplace_back(v.normal[0], v.normal[1], v.normal[2]);
    mesh.uvs.emplace_back(v.uv[0], v.uv[1]);
  }
  const std::size_t triangles = cursor.count<Triangle>("triangles");
  mesh.indices.reserve(triangles);
  result.materials.reserve(triangles);
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto t = cursor.next<Triangle>();
    mesh.indices.emplace_back(t.vertices[0], t.vertices[1], t.vertices[2]);
    result.materials.push_back(t.material);
  }
  return result;
}

}  // namespace ajar::tungsten
