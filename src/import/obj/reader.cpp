#include "import/obj/reader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <unordered_map>

#include "import/obj/text_stream.h"

namespace ajar::obj {
namespace {

/// Numbers of a position, a texture coordinate and a normal.
using Corner = std::array<std::uint32_t, 3>;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

struct CornerHash {
  std::size_t operator()(const Corner& corner) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t number : corner) {
      hash = (hash ^ number) * 0xff51afd7ed558ccdULL;
      hash ^= hash >> 32U;
    }
    return static_cast<std::size_t>(hash);
  }
};

/// A part in the making: a vertex of its mesh for each different corner.
struct PartBuilder {
  Part part;
  std::unordered_map<Corner, unsigned, CornerHash> vertices;
};

class Reader final : public tinyobj::MaterialReader {
 public:
  Reader(std::string_view text, const std::string& name, Library& library)
      : stream_(text), name_(std::make_shared<const std::string>(name)), library_(library) {}

  std::vector<Part> read() {
    tinyobj::callback_t calls;
    calls.vertex_cb = [](void* self, float x, float y, float z, float) {
      to(self).positions_.emplace_back(x, y, z);
    };
    calls.normal_cb = [](void* self, float x, float y, float z) {
      to(self).normals_.emplace_back(x, y, z);
    };
    calls.texcoord_cb = [](void* self, float u, float v, float) {
      to(self).uvs_.emplace_back(u, v);
    };
    calls.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
      to(self).add_face({corners, static_cast<std::size_t>(count)});
    };
    calls.usemtl_cb = [](void* self, const char* name, int) {
      to(self).material_ = trimmed(name);
      to(self).current_ = nullptr;
    };
    tinyobj::LoadObjWithCallback(stream_, calls, this, this);
    if (builders_.empty()) throw SceneError({name_, 0, 0}, "there are no faces in this file");
    std::vector<Part> parts;
    for (const std::unique_ptr<PartBuilder>& builder : builders_) {
      parts.push_back(std::move(builder->part));
    }
    return parts;
  }

 private:
  static Reader& to(void* self) { return *static_cast<Reader*>(self); }

  /// A file of materials; false lets the library try the next name of the line.
  bool operator()(const std::string& file, std::vector<tinyobj::material_t>* /*materials*/,
                  std::map<std::string, int>* /*numbers*/, std::string* /*warnings*/,
                  std::string* /*errors*/) override {
    library_.load(here(), file);
    return false;
  }

  SourceLocation here() { return {name_, stream_.line(), 0}; }

  /// Numbers count from 1, or backwards from the last one.
  std::uint32_t resolve(int number, std::size_t count, const char* what) {
    const std::int64_t place =
        number > 0 ? std::int64_t{number} - 1 : static_cast<std::int64_t>(count) + number;
    if (number == 0 || place < 0 || place >= static_cast<std::int64_t>(count)) {
      throw SceneError(here(), "this face refers to " + std::string(what) + " " +
                                   std::to_string(number) + " of " + std::to_string(count));
    }
    return static_cast<std::uint32_t>(place);
  }
  std::uint32_t resolve_if_given(int number, std::size_t count, const char* what) {
    return number == 0 ? kNone : resolve(number, count, what);
  }

  void add_face(std::span<const tinyobj::index_t> face) {
    if (face.size() < 3) {
      throw SceneError(here(),
                       "a face has three corners or more, not " + std::to_string(face.size()));
    }
    corners_.clear();
    bool has_uvs = true;
    bool has_normals = true;
    for (const tinyobj::index_t& corner : face) {
      corners_.push_back(
          {resolve(corner.vertex_index, positions_.size(), "vertex"),
           resolve_if_given(corner.texcoord_index, uvs_.size(), "texture coordinate"),
           resolve_if_given(corner.normal_index, normals_.size(), "normal")});
      has_uvs &= corners_.back()[1] != kNone;
      has_normals &= corners_.back()[2] != kNone;
    }
    PartBuilder& builder = builder_of(has_uvs, has_normals);
    polygon_.clear();
    for (const Corner& corner : corners_) {
      polygon_.push_back(vertex_of(builder, corner, has_uvs, has_normals));
    }
    for (std::size_t i = 2; i < polygon_.size(); ++i) {
      builder.part.mesh.indices.emplace_back(polygon_[0], polygon_[i - 1], polygon_[i]);
    }
  }

  PartBuilder& builder_of(bool has_uvs, bool has_normals) {
    const int kind = (has_uvs ? 1 : 0) + (has_normals ? 2 : 0);
    if (current_ != nullptr && current_kind_ == kind) return *current_;
    const auto [place, is_new] = by_kind_.try_emplace({material_, kind}, nullptr);
    if (is_new) {
      builders_.push_back(std::make_unique<PartBuilder>());
      place->second = builders_.back().get();
      place->second->part.material = material_;
      place->second->part.where = here();
    }
    current_ = place->second;
    current_kind_ = kind;
    return *current_;
  }

  unsigned vertex_of(PartBuilder& builder, Corner corner, bool has_uvs, bool has_normals) const {
    if (!has_uvs) corner[1] = kNone;
    if (!has_normals) corner[2] = kNone;
    desc::Mesh& mesh = builder.part.mesh;
    const auto [place, is_new] =
        builder.vertices.try_emplace(corner, static_cast<unsigned>(mesh.positions.size()));
    if (is_new) {
      mesh.positions.push_back(positions_[corner[0]]);
      if (has_uvs) mesh.uvs.push_back(uvs_[corner[1]]);
      if (has_normals) mesh.normals.push_back(normals_[corner[2]]);
    }
    return place->second;
  }

  TextStream stream_;
  std::shared_ptr<const std::string> name_;
  Library& library_;
  std::vector<Vec3> positions_, normals_;
  std::vector<Vec2> uvs_;
  std::string material_;
  std::vector<std::unique_ptr<PartBuilder>> builders_;  ///< in the order of their first faces
  std::map<std::pair<std::string, int>, PartBuilder*> by_kind_;
  PartBuilder* current_ = nullptr;
  int current_kind_ = 0;
  std::vector<Corner> corners_;
  std::vector<unsigned> polygon_;
};

}  // namespace

std::vector<Part> read_parts(std::string_view text, const std::string& name, Library& library) {
  return Reader(text, name, library).read();
}

}  // namespace ajar::obj
