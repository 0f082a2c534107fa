#include "import/mesh/obj.h"

#include <tiny_obj_loader.h>

#include <istream>
#include <memory>
#include <span>
#include <streambuf>
#include <unordered_map>

#include "core/error.h"

namespace ajar {
namespace {

/// Lets a stream read memory that stays where it is.
class MemoryBuffer final : public std::streambuf {
 public:
  explicit MemoryBuffer(std::string_view bytes) {
    char* begin = const_cast<char*>(bytes.data());
    setg(begin, begin, begin + bytes.size());
  }
};

/// A corner of a face: which position, texture coordinates and normal it has, counted from 0; -1
/// for none.
struct Corner {
  int position = -1, uv = -1, normal = -1;
  bool operator==(const Corner&) const = default;
};
struct CornerHash {
  std::size_t operator()(const Corner& corner) const {
    std::size_t hash = static_cast<unsigned>(corner.position);
    for (const int index : {corner.uv, corner.normal}) {
      hash = hash * 0x9e3779b97f4a7c15U + static_cast<unsigned>(index);
    }
    return hash;
  }
};

class ObjReader {
 public:
  explicit ObjReader(const std::string& name) : name_(name) {}

  desc::Mesh read(std::string_view bytes) {
    tinyobj::callback_t calls;
    calls.vertex_cb = [](void* self, float x, float y, float z, float /*w*/) {
      static_cast<ObjReader*>(self)->positions_.emplace_back(x, y, z);
    };
    calls.normal_cb = [](void* self, float x, float y, float z) {
      static_cast<ObjReader*>(self)->normals_.emplace_back(x, y, z);
    };
    calls.texcoord_cb = [](void* self, float u, float v, float /*w*/) {
      static_cast<ObjReader*>(self)->uvs_.emplace_back(u, v);
    };
    calls.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
      static_cast<ObjReader*>(self)->add_face({corners, static_cast<std::size_t>(count)});
    };
    MemoryBuffer buffer(bytes);
    std::istream stream(&buffer);
    tinyobj::LoadObjWithCallback(stream, calls, this);
    if (faces_ == 0) fail("there are no faces in this file");
    if (lacks_normals_) mesh_.normals.clear();
    if (!has_uvs_) mesh_.uvs.clear();
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw SceneError({std::make_shared<const std::string>(name_), 0, 0}, message);
  }

  /// From a number as the file has it: from 1 on, or backwards from the last one; 0 for none.
  int index_of(int written, std::size_t count, const char* what) const {
    if (written == 0) return -1;
    const auto available = static_cast<std::int64_t>(count);
    const std::int64_t index = written > 0 ? written - std::int64_t{1} : available + written;
    if (index < 0 || index >= available) {
      fail("face " + std::to_string(faces_) + " refers to " + what + " " + std::to_string(written) +
           ", but there are " + std::to_string(count) + " before it");
    }
    return static_cast<int>(index);
  }

  void add_face(std::span<const tinyobj::index_t> corners) {
    ++faces_;
    polygon_.clear();
    for (const tinyobj::index_t& written : corners) {
      const Corner corner{index_of(written.vertex_index, positions_.size(), "vertex"),
                          index_of(written.texcoord_index, uvs_.size(), "texture coordinate"),
                          index_of(written.normal_index, normals_.size(), "normal")};
      if (corner.position < 0) {
        fail("face " + std::to_string(faces_) + " has a corner that is not a vertex number");
      }
      polygon_.push_back(vertex_of(corner));
    }
    for (std::size_t i = 2; i < polygon_.size(); ++i) {
      mesh_.indices.emplace_back(polygon_[0], polygon_[i - 1], polygon_[i]);
    }
  }

  unsigned vertex_of(const Corner& corner) {
    const auto [place, is_new] =
        vertices_.try_emplace(corner, static_cast<unsigned>(mesh_.positions.size()));
    if (!is_new) return place->second;
    const auto at = [](const auto& values, int index) {
      using Value = std::decay_t<decltype(values[0])>;
      return index < 0 ? Value(0.F) : values[static_cast<std::size_t>(index)];
    };
    mesh_.positions.push_back(at(positions_, corner.position));
    mesh_.normals.push_back(at(normals_, corner.normal));
    mesh_.uvs.push_back(at(uvs_, corner.uv));
    lacks_normals_ |= corner.normal < 0;
    has_uvs_ |= corner.uv >= 0;
    return place->second;
  }

  const std::string& name_;
  std::vector<Vec3> positions_, normals_;
  std::vector<Vec2> uvs_;
  std::unordered_map<Corner, unsigned, CornerHash> vertices_;
  std::vector<unsigned> polygon_;
  desc::Mesh mesh_;
  std::size_t faces_ = 0;
  bool lacks_normals_ = false;
  bool has_uvs_ = false;
};

}  // namespace

desc::Mesh read_obj(std::string_view bytes, const std::string& name) {
  return ObjReader(name).read(bytes);
}

}  // namespace ajar
