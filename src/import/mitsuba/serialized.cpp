#include "import/mitsuba/serialized.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>

#include "core/error.h"
#include "import/mesh/inflate.h"

namespace ajar::mitsuba {
namespace {

static_assert(std::endian::native == std::endian::little, "the format is read as it is in memory");

constexpr std::uint16_t kMagic = 0x041C;
constexpr std::uint32_t kHasNormals = 0x0001;
constexpr std::uint32_t kHasUvs = 0x0002;
constexpr std::uint32_t kHasColors = 0x0008;
constexpr std::uint32_t kDoublePrecision = 0x2000;
/// zlib cannot compress better than this.
constexpr std::size_t kMaxRatio = 1040;

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  [[noreturn]] void fail(const std::string& message) const {
    throw SceneError({std::make_shared<const std::string>(name_), 0, 0}, message);
  }

  template <typename T>
  T take() {
    if (bytes_.size() < sizeof(T)) fail("the file is damaged or ends early");
    T value;
    std::memcpy(&value, bytes_.data(), sizeof(T));
    bytes_.remove_prefix(sizeof(T));
    return value;
  }
  void skip_text() {
    const std::size_t end = bytes_.find('\0');
    if (end == std::string_view::npos) fail("the file is damaged or ends early");
    bytes_.remove_prefix(end + 1);
  }
  std::string_view rest() const { return bytes_; }

  /// `count` records of `lanes` numbers of one precision.
  template <typename Vector>
  std::vector<Vector> take_vectors(std::uint64_t count, int lanes, bool is_double) {
    const std::size_t size = static_cast<std::size_t>(lanes) * (is_double ? 8U : 4U);
    if (count > bytes_.size() / size) fail("the file is damaged or ends early");
    std::vector<Vector> result(static_cast<std::size_t>(count));
    for (Vector& vector : result) {
      for (int i = 0; i < lanes; ++i) {
        vector[i] = is_double ? static_cast<float>(take<double>()) : take<float>();
      }
    }
    return result;
  }
  void skip_vectors(std::uint64_t count, int lanes, bool is_double) {
    const std::size_t size = static_cast<std::size_t>(lanes) * (is_double ? 8U : 4U);
    if (count > bytes_.size() / size) fail("the file is damaged or ends early");
    bytes_.remove_prefix(static_cast<std::size_t>(count) * size);
  }

 private:
  std::string_view bytes_;
  const std::string& name_;
};

/// Where the meshes of a file begin, and where the last one ends: a list at the end of the file
/// says it. Empty if there is no such list.
std::vector<std::uint64_t> places_in(std::string_view bytes, std::uint16_t version) {
  const std::size_t entry = version >= 4 ? 8 : 4;
  std::uint32_t count = 0;
  if (bytes.size() < sizeof(count)) return {};
  const std::size_t end = bytes.size() - sizeof(count);
  std::memcpy(&count, bytes.data() + end, sizeof(count));
  if (count > end / entry) return {};
  const std::size_t list = end - count * entry;
  std::vector<std::uint64_t> places(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    std::memcpy(&places[i], bytes.data() + list + i * entry, entry);
  }
  places.push_back(list);
  const bool is_list = places.front() == 0 && std::is_sorted(places.begin(), places.end());
  return is_list ? places : std::vector<std::uint64_t>();
}

/// The part of the file that has the mesh.
std::string_view part_of(std::string_view bytes, const Reader& reader, std::uint16_t version,
                         long long index) {
  const std::vector<std::uint64_t> places = places_in(bytes, version);
  if (places.empty() && index == 0) return bytes;
  if (places.empty()) reader.fail("the list of its meshes is missing or damaged");
  const auto count = static_cast<long long>(places.size()) - 1;
  if (index < 0 || index >= count) {
    reader.fail("there is no mesh " + std::to_string(index) + ": this file has " +
                std::to_string(count));
  }
  const auto begin = static_cast<std::size_t>(places[static_cast<std::size_t>(index)]);
  const auto end = static_cast<std::size_t>(places[static_cast<std::size_t>(index) + 1]);
  return bytes.substr(begin, end - begin);
}

std::uint16_t take_version(Reader& header) {
  if (header.take<std::uint16_t>() != kMagic) header.fail("this is not a serialized mesh");
  const auto version = header.take<std::uint16_t>();
  if (version != 3 && version != 4) {
    header.fail("serialized meshes of version 3 and 4 can be read, not of " +
                std::to_string(version));
  }
  return version;
}

std::vector<Imath::Vec3<unsigned>> take_triangles(Reader& body, std::uint64_t count,
                                                  bool has_long_indices) {
  const std::size_t size = has_long_indices ? 24 : 12;
  if (count > body.rest().size() / size) body.fail("the file is damaged or ends early");
  std::vector<Imath::Vec3<unsigned>> result(static_cast<std::size_t>(count));
  for (Imath::Vec3<unsigned>& triangle : result) {
    for (int i = 0; i < 3; ++i) {
      const std::uint64_t vertex =
          has_long_indices ? body.take<std::uint64_t>() : body.take<std::uint32_t>();
      // Larger indices are refused with all that are out of range.
      triangle[i] = static_cast<unsigned>(
          std::min<std::uint64_t>(vertex, std::numeric_limits<unsigned>::max()));
    }
  }
  return result;
}

}  // namespace

desc::Mesh read_serialized(std::string_view bytes, const std::string& name, long long index) {
  Reader whole(bytes, name);
  Reader header(part_of(bytes, whole, take_version(whole), index), name);
  const std::uint16_t version = take_version(header);
  const std::string_view packed = header.rest();
  const std::optional<std::string> unpacked =
      inflate_stream(packed, StreamKind::Zlib, packed.size() * kMaxRatio + 4096);
  if (!unpacked) header.fail("the compressed data is damaged or ends early");

  Reader body(*unpacked, name);
  const auto flags = body.take<std::uint32_t>();
  if (version >= 4) body.skip_text();  // its name
  const auto vertices = body.take<std::uint64_t>();
  const auto triangles = body.take<std::uint64_t>();
  const bool is_double = (flags & kDoublePrecision) != 0;
  desc::Mesh mesh;
  mesh.positions = body.take_vectors<Vec3>(vertices, 3, is_double);
  if ((flags & kHasNormals) != 0) mesh.normals = body.take_vectors<Vec3>(vertices, 3, is_double);
  if ((flags & kHasUvs) != 0) mesh.uvs = body.take_vectors<Vec2>(vertices, 2, is_double);
  if ((flags & kHasColors) != 0) body.skip_vectors(vertices, 3, is_double);
  mesh.indices = take_triangles(body, triangles, vertices > 0xFFFFFFFFU);
  // The flag 0x10 marks a faceted mesh; renderers of these files go by the normals.
  return mesh;
}

}  // namespace ajar::mitsuba
