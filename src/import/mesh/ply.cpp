#include "import/mesh/ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "import/mesh/display_color.h"
#include "import/mesh/gzip.h"
#include "import/mesh/ply_cursor.h"
#include "import/mesh/polygon.h"

namespace ajar {
namespace {

/// gzip cannot compress better than this.
constexpr std::size_t kMaxGzipRatio = 1040;
/// Property of a vertex that becomes component `slot` of: x y z nx ny nz u v red green blue.
constexpr int kSlots = 11;
constexpr int kFirstColor = 8;
constexpr int kUnusedSlot = -1;
/// The element that strips of triangles are in.
constexpr std::string_view kStrips = "tristrips";

int slot_of(const std::string& name) {
  static const std::array<std::vector<std::string>, kSlots> kNames = {
      {{"x"},
       {"y"},
       {"z"},
       {"nx"},
       {"ny"},
       {"nz"},
       {"u", "s", "texture_u", "texture_s"},
       {"v", "t", "texture_v", "texture_t"},
       {"red", "r", "diffuse_red"},
       {"green", "g", "diffuse_green"},
       {"blue", "b", "diffuse_blue"}}};
  for (int slot = 0; slot < kSlots; ++slot) {
    const auto& names = kNames[static_cast<std::size_t>(slot)];
    if (std::find(names.begin(), names.end(), name) != names.end()) return slot;
  }
  return kUnusedSlot;
}

/// Value of 1 in a colour.
float full_color(PlyType type) {
  switch (type) {
    case PlyType::Int8:
      return std::numeric_limits<std::int8_t>::max();
    case PlyType::UInt8:
      return std::numeric_limits<std::uint8_t>::max();
    case PlyType::Int16:
      return std::numeric_limits<std::int16_t>::max();
    case PlyType::UInt16:
      return std::numeric_limits<std::uint16_t>::max();
    case PlyType::Int32:
    case PlyType::UInt32:
      return std::numeric_limits<std::uint8_t>::max();
    case PlyType::Float32:
    case PlyType::Float64:
      break;
  }
  return 1.F;
}

bool is_index_list(const PlyProperty& property) {
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& name)
      : bytes_(bytes), name_(name), header_(parse_ply_header(bytes, name)) {}

  PlyContents read() {
    const std::string_view body = bytes_.substr(header_.size);
    if (header_.format == PlyFormat::Ascii) {
      read_elements(PlyAsciiCursor(body));
    } else {
      read_elements(PlyBinaryCursor(body, header_.format == PlyFormat::BinaryBigEndian));
    }
    if (!has_vertices_) fail("there is no element \"vertex\" with x, y and z");
    if (!has_faces_) fail("there is no element \"face\" with a list \"vertex_indices\"");
    return {std::move(mesh_), std::move(colors_), header_.images, skipped()};
  }

 private:
  std::vector<std::string> skipped() const {
    std::vector<std::string> names;
    for (const PlyElement& element : header_.elements) {
      if (element.name != "vertex" && element.name != "face" && element.name != kStrips) {
        if (element.count > 0) names.push_back(element.name);
        continue;
      }
      for (const PlyProperty& property : element.properties) {
        const int slot = slot_of(property.name);
        const bool is_read = element.name == "vertex"
                                 ? slot != kUnusedSlot && (slot < kFirstColor || has_colors_)
                                 : is_index_list(property);
        if (!is_read) names.push_back(property.name);
      }
    }
    return names;
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw SceneError({std::make_shared<const std::string>(name_), 0, 0}, message);
  }
  [[noreturn]] void fail_in(const PlyElement& element, std::uint64_t record) const {
    fail("the file is damaged or ends early in " + element.name + " " + std::to_string(record) +
         " of " + std::to_string(element.count));
  }

  template <typename Cursor>
  void read_elements(Cursor cursor) {
    for (const PlyElement& element : header_.elements) {
      if (element.count == 0 || element.properties.empty()) {
        has_vertices_ |= element.name == "vertex";
        has_faces_ |= element.name == "face" || element.name == kStrips;
        continue;
      }
      // Refuses counts that cannot be true before any memory is taken for them.
      if (element.count > cursor.left() / Cursor::record_size(element) + 1) {
        fail("the file ends early: " + std::to_string(element.count) + " × " + element.name +
             " cannot fit in the " + std::to_string(cursor.left()) + " bytes that are left");
      }
      if (element.name == "vertex") {
        read_vertices(element, cursor);
      } else if (element.name == "face") {
        read_faces(element, cursor);
      } else if (element.name == kStrips) {
        read_strips(element, cursor);
      } else {
        for (std::uint64_t i = 0; i < element.count; ++i) skip_record(element, cursor, i);
      }
    }
  }

  template <typename Cursor>
  void skip_record(const PlyElement& element, Cursor& cursor, std::uint64_t record) {
    for (const PlyProperty& p : element.properties) skip_property(element, p, cursor, record);
  }
  template <typename Cursor>
  void skip_property(const PlyElement& element, const PlyProperty& p, Cursor& cursor,
                     std::uint64_t record) {
    std::uint64_t count = 1;
    if (p.is_list) count = list_size(element, p, cursor, record);
    if (!cursor.skip(p.type, count)) fail_in(element, record);
  }
  template <typename Cursor>
  std::uint64_t list_size(const PlyElement& element, const PlyProperty& p, Cursor& cursor,
                          std::uint64_t record) {
    const std::optional<double> count = cursor.read(p.count_type);
    if (!count || !(*count >= 0.0) || *count > 4294967295.0) fail_in(element, record);
    return static_cast<std::uint64_t>(*count);
  }

  void check_vertex_count(const PlyElement& element) {
    if (has_vertices_) fail("there are two elements \"vertex\"");
    if (element.count > std::numeric_limits<std::uint32_t>::max()) fail("too many vertices");
    has_vertices_ = true;
  }

  void resize_attributes(const std::array<bool, kSlots>& has, std::size_t count) {
    if (!has[0] || !has[1] || !has[2]) fail("the element \"vertex\" lacks x, y or z");
    has_normals_ = has[3] && has[4] && has[5];
    has_uvs_ = has[6] && has[7];
    has_colors_ = has[8] && has[9] && has[10];
    mesh_.positions.resize(count);
    if (has_normals_) mesh_.normals.resize(count);
    if (has_uvs_) mesh_.uvs.resize(count);
    if (has_colors_) colors_.resize(count);
  }

  /// Colours as the file has them become linear.
  void decode_colors(const PlyElement& element) {
    if (!has_colors_) return;
    float full = 1.F;
    for (const PlyProperty& property : element.properties) {
      if (slot_of(property.name) == kFirstColor) full = full_color(property.type);
    }
    // Floats are shares, or values of bytes: no share is that large.
    constexpr float kMostOfShares = 2.F;
    const bool are_bytes = full == 1.F && std::ranges::any_of(colors_, [](const Vec3& color) {
                             return std::max({color.x, color.y, color.z}) > kMostOfShares;
                           });
    if (are_bytes) full = 255.F;
    for (Vec3& color : colors_) color = from_display(color / full);
  }

  void store(std::size_t i, const std::array<float, kSlots>& values) {
    mesh_.positions[i] = Vec3(values[0], values[1], values[2]);
    if (has_normals_) mesh_.normals[i] = Vec3(values[3], values[4], values[5]);
    if (has_uvs_) mesh_.uvs[i] = Vec2(values[6], values[7]);
    if (has_colors_) colors_[i] = Vec3(values[8], values[9], values[10]);
  }

  /// Records of any kind.
  template <typename Cursor>
  void read_vertices(const PlyElement& element, Cursor& cursor) {
    check_vertex_count(element);
    std::vector<int> slots;
    std::array<bool, kSlots> has{};
    bool fixed_size = true;
    for (const PlyProperty& p : element.properties) {
      int slot = p.is_list ? kUnusedSlot : slot_of(p.name);
      if (slot >= 0 && has[static_cast<std::size_t>(slot)]) slot = kUnusedSlot;
      if (slot >= 0) has[static_cast<std::size_t>(slot)] = true;
      slots.push_back(slot);
      fixed_size &= !p.is_list;
    }
    const auto count = static_cast<std::size_t>(element.count);
    if constexpr (std::is_same_v<Cursor, PlyBinaryCursor>) {
      if (fixed_size) {
        if (count > cursor.left() / Cursor::record_size(element)) fail_in(element, count);
        resize_attributes(has, count);
        read_fixed_vertices(element, slots, cursor);
        decode_colors(element);
        return;
      }
    }
    resize_attributes(has, count);
    std::array<float, kSlots> values{};
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t p = 0; p < slots.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        if (slots[p] == kUnusedSlot) {
          skip_property(element, property, cursor, i);
          continue;
        }
        const std::optional<double> value = cursor.read(property.type);
        if (!value) fail_in(element, i);
        values[static_cast<std::size_t>(slots[p])] = static_cast<float>(*value);
      }
      store(i, values);
    }
    decode_colors(element);
  }

  /// Binary records of one size: all values are at known places.
  void read_fixed_vertices(const PlyElement& element, const std::vector<int>& slots,
                           PlyBinaryCursor& cursor) {
    struct Field {
      std::size_t offset = 0;
      PlyType type = PlyType::Float32;
    };
    std::array<Field, kSlots> fields;
    std::size_t stride = 0;
    for (std::size_t p = 0; p < slots.size(); ++p) {
      if (slots[p] >= 0)
        fields[static_cast<std::size_t>(slots[p])] = {stride, element.properties[p].type};
      stride += ply_size(element.properties[p].type);
    }
    const auto packed = [&](std::size_t first, std::size_t count) {
      for (std::size_t i = first; i < first + count; ++i) {
        if (fields[i].type != PlyType::Float32 ||
            fields[i].offset != fields[first].offset + 4 * (i - first)) {
          return false;
        }
      }
      return cursor.native_order();
    };
    // Copies runs of native floats, the layout of nearly every file, and converts anything else.
    const auto fill = [&](auto& attribute, std::size_t first, std::size_t components) {
      const char* record = cursor.position();
      const bool copy = packed(first, components);
      for (auto& vector : attribute) {
        if (copy) {
          std::memcpy(&vector.x, record + fields[first].offset, 4 * components);
        } else {
          for (std::size_t c = 0; c < components; ++c) {
            const Field& field = fields[first + c];
            vector[static_cast<int>(c)] =
                static_cast<float>(cursor.at(record + field.offset, field.type));
          }
        }
        record += stride;
      }
    };
    fill(mesh_.positions, 0, 3);
    if (has_normals_) fill(mesh_.normals, 3, 3);
    if (has_uvs_) fill(mesh_.uvs, 6, 2);
    if (has_colors_) fill(colors_, kFirstColor, 3);
    cursor.advance(stride * static_cast<std::size_t>(element.count));
  }

  /// The number of the property that has the indices of the vertices.
  std::size_t index_list_of(const PlyElement& element) const {
    if (has_faces_) fail("there are two elements \"face\" or \"tristrips\"");
    std::size_t which = element.properties.size();
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      if (is_index_list(element.properties[p])) which = p;
    }
    if (which == element.properties.size()) {
      fail("the element \"" + element.name + "\" lacks the list \"vertex_indices\"");
    }
    return which;
  }

  unsigned vertex_number(const PlyElement& element, std::uint64_t record, double value) const {
    if (!(value >= 0.0) || value > 4294967295.0 || value != std::floor(value)) {
      fail(element.name + " " + std::to_string(record) +
           " has an index that is not a vertex number");
    }
    return static_cast<unsigned>(value);
  }

  template <typename Cursor>
  void read_strips(const PlyElement& element, Cursor& cursor) {
    const std::size_t which = index_list_of(element);
    has_faces_ = true;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        if (p == which) {
          read_strip(element, element.properties[p], cursor, i);
        } else {
          skip_property(element, element.properties[p], cursor, i);
        }
      }
    }
  }

  /// Each vertex but the first two makes a triangle with those before it, every other one turned;
  /// -1 begins anew.
  template <typename Cursor>
  void read_strip(const PlyElement& element, const PlyProperty& p, Cursor& cursor,
                  std::uint64_t record) {
    const std::uint64_t count = list_size(element, p, cursor, record);
    if (count > cursor.left()) fail_in(element, record);
    std::array<unsigned, 2> before{};
    std::uint64_t length = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::optional<double> value = cursor.read(p.type);
      if (!value) fail_in(element, record);
      if (*value == -1.0) {
        length = 0;
        continue;
      }
      const unsigned vertex = vertex_number(element, record, *value);
      const bool is_triangle =
          length >= 2 && vertex != before[0] && vertex != before[1] && before[0] != before[1];
      if (is_triangle && length % 2 == 0) mesh_.indices.emplace_back(before[0], before[1], vertex);
      if (is_triangle && length % 2 == 1) mesh_.indices.emplace_back(before[1], before[0], vertex);
      before = {before[1], vertex};
      ++length;
    }
  }

  template <typename Cursor>
  void read_faces(const PlyElement& element, Cursor& cursor) {
    const std::size_t which = index_list_of(element);
    has_faces_ = true;
    mesh_.indices.reserve(static_cast<std::size_t>(element.count));
    std::uint64_t done = 0;
    if constexpr (std::is_same_v<Cursor, PlyBinaryCursor>)
      done = read_plain_triangles(element, cursor);
    std::vector<unsigned> polygon;
    for (std::uint64_t i = done; i < element.count; ++i) {
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        if (p == which) {
          read_polygon(element, element.properties[p], cursor, i, polygon);
        } else {
          skip_property(element, element.properties[p], cursor, i);
        }
      }
    }
  }

  /// Leading faces that are triangles with a one-byte count and native 32-bit indices, and nothing
  /// else in the record. Returns their number.
  std::uint64_t read_plain_triangles(const PlyElement& element, PlyBinaryCursor& cursor) {
    const PlyProperty& p = element.properties.front();
    const bool plain = element.properties.size() == 1 && ply_size(p.count_type) == 1 &&
                       (p.type == PlyType::Int32 || p.type == PlyType::UInt32) &&
                       cursor.native_order();
    if (!plain) return 0;
    constexpr std::size_t kRecord = 1 + 3 * sizeof(std::uint32_t);
    const std::uint64_t limit = std::min<std::uint64_t>(element.count, cursor.left() / kRecord);
    const char* record = cursor.position();
    std::uint64_t done = 0;
    for (; done < limit && record[0] == 3; ++done, record += kRecord) {
      std::uint32_t t[3];
      std::memcpy(t, record + 1, sizeof(t));
      mesh_.indices.emplace_back(t[0], t[1], t[2]);
    }
    cursor.advance(static_cast<std::size_t>(done) * kRecord);
    return done;
  }

  template <typename Cursor>
  void read_polygon(const PlyElement& element, const PlyProperty& p, Cursor& cursor,
                    std::uint64_t record, std::vector<unsigned>& polygon) {
    const std::uint64_t count = list_size(element, p, cursor, record);
    if (count > cursor.left()) fail_in(element, record);
    polygon.clear();
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::optional<double> value = cursor.read(p.type);
      if (!value) fail_in(element, record);
      polygon.push_back(vertex_number(element, record, *value));
    }
    if (polygon.size() == 3) {
      mesh_.indices.emplace_back(polygon[0], polygon[1], polygon[2]);
      return;
    }
    // Vertices that are not there are an error later, and may follow the faces.
    places_.clear();
    for (const unsigned vertex : polygon) {
      places_.push_back(vertex < mesh_.positions.size() ? mesh_.positions[vertex] : Vec3(0.F));
    }
    triangles_.clear();
    triangulate(places_, triangles_);
    for (const auto& t : triangles_) {
      mesh_.indices.emplace_back(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
    }
  }

  std::string_view bytes_;
  const std::string& name_;
  PlyHeader header_;
  desc::Mesh mesh_;
  bool has_vertices_ = false;
  bool has_faces_ = false;
  bool has_normals_ = false;
  bool has_uvs_ = false;
  bool has_colors_ = false;
  std::vector<Vec3> colors_;
  std::vector<Vec3> places_;  ///< corners of a face, and its triangles
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

void append(std::string& out, const void* data, std::size_t size) {
  out.append(static_cast<const char*>(data), size);
}

}  // namespace

desc::Mesh read_ply(std::string_view bytes, const std::string& name) {
  return read_ply_contents(bytes, name).mesh;
}

PlyContents read_ply_contents(std::string_view bytes, const std::string& name) {
  if (!is_gzip(bytes)) return PlyReader(bytes, name).read();
  const std::optional<std::string> unpacked = gunzip(bytes, bytes.size() * kMaxGzipRatio + 4096);
  if (!unpacked) {
    throw SceneError({std::make_shared<const std::string>(name), 0, 0},
                     "the gzip data is damaged or ends early");
  }
  return PlyReader(*unpacked, name).read();
}

std::string write_ply(const desc::Mesh& mesh) {
  static_assert(std::endian::native == std::endian::little, "write_ply copies memory as it is");
  const bool normals = !mesh.normals.empty();
  const bool uvs = !mesh.uvs.empty();
  std::string out = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                    std::to_string(mesh.positions.size()) +
                    "\nproperty float x\nproperty float y\nproperty float z\n";
  if (normals) out += "property float nx\nproperty float ny\nproperty float nz\n";
  if (uvs) out += "property float u\nproperty float v\n";
  out += "element face " + std::to_string(mesh.indices.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
  out.reserve(out.size() + mesh.positions.size() * (12 + (normals ? 12U : 0U) + (uvs ? 8U : 0U)) +
              mesh.indices.size() * 13);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    append(out, &mesh.positions[i], 12);
    if (normals) append(out, &mesh.normals[i], 12);
    if (uvs) append(out, &mesh.uvs[i], 8);
  }
  for (const Imath::Vec3<unsigned>& t : mesh.indices) {
    out.push_back(3);
    append(out, &t, 12);
  }
  return out;
}

}  // namespace ajar
