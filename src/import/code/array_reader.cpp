#include "import/code/array_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "imageio/image_encoder.h"
#include "import/mesh/validate_mesh.h"

namespace ajar::code {

namespace {

template <typename Vector, typename Number>
std::vector<Vector> vectors(const NumberArray& array) {
  const std::size_t columns = array.shape.back();
  const auto* from = static_cast<const Number*>(array.data);
  std::vector<Vector> result(array.shape.front());
  for (Vector& vector : result) {
    for (std::size_t c = 0; c < columns; ++c) vector[static_cast<int>(c)] = *from++;
  }
  return result;
}

std::string shape_text(const NumberArray& array) {
  return fmt::format("{}", fmt::join(array.shape, " x "));
}

/// FNV-1a. Source: Fowler, Noll and Vo, draft-eastlake-fnv.
std::uint64_t hash_of(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char byte : bytes) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  }
  return hash;
}

/// Rows of one channel or three, as three.
template <typename T>
RowSource<T> rows_of(const NumberArray& array) {
  const std::size_t width = array.shape[1];
  const std::size_t channels = array.shape.size() == 3 ? array.shape[2] : 1;
  const auto* from = static_cast<const T*>(array.data);
  return [=](int y, T* to) {
    const T* row = from + static_cast<std::size_t>(y) * width * channels;
    for (std::size_t x = 0; x < width; ++x) {
      for (std::size_t c = 0; c < 3; ++c) *to++ = row[x * channels + std::min(c, channels - 1)];
    }
  };
}

}  // namespace

const NumberArray* ArrayReader::find(const LocatedJson& part, const char* name) const {
  const auto number = part.find(name);
  if (!number) return nullptr;
  if (arrays_.empty()) number->fail("is array " + number->shown() + ", but no arrays are given");
  return &arrays_[number->index(arrays_.size())];
}

const NumberArray& ArrayReader::array(const LocatedJson& part, const char* name,
                                      NumberArray::Type type, std::size_t columns) const {
  static const NumberArray kNone{NumberArray::Type::Float32, {0, 0}, nullptr};
  const NumberArray* found = find(part, name);
  if (found == nullptr) return kNone;
  const NumberArray& array = *found;
  const std::size_t last = array.shape.size() == 2 ? array.shape[1] : 1;
  const bool fits =
      last == columns && (array.shape.size() == 2 || (columns == 1 && array.shape.size() == 1));
  if (array.type != type || !fits) {
    part.at(name).fail(
        fmt::format("must be an array of N x {}, not {}", columns, shape_text(array)));
  }
  return array;
}

desc::MeshPointer ArrayReader::mesh(const LocatedJson& part) const {
  using enum NumberArray::Type;
  check_members(part, {"positions", "indices", "normals", "tangents", "uvs"});
  for (const char* needed : {"positions", "indices"}) {
    if (!part.has(needed)) part.fail("a mesh needs \"" + std::string(needed) + "\"");
  }
  desc::Mesh mesh;
  mesh.positions = vectors<Vec3, float>(array(part, "positions", Float32, 3));
  mesh.indices = vectors<Imath::Vec3<unsigned>, std::uint32_t>(array(part, "indices", UInt32, 3));
  mesh.normals = vectors<Vec3, float>(array(part, "normals", Float32, 3));
  mesh.tangents = vectors<Vec3, float>(array(part, "tangents", Float32, 3));
  mesh.uvs = vectors<Vec2, float>(array(part, "uvs", Float32, 2));
  const std::size_t vertices = mesh.positions.size();
  const auto check = [&](const char* name, std::size_t count) {
    if (count != 0 && count != vertices) {
      part.fail(fmt::format("it has {} positions, but {} {}", vertices, count, name));
    }
  };
  check("normals", mesh.normals.size());
  check("tangents", mesh.tangents.size());
  check("uvs", mesh.uvs.size());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const Imath::Vec3<unsigned>& t = mesh.indices[i];
    const unsigned last = std::max({t.x, t.y, t.z});
    if (last < vertices) continue;
    part.fail(fmt::format("\"indices\": triangle {} refers to vertex {} of {}", i, last, vertices));
  }
  std::vector<Warning> remarks;
  validate_mesh(mesh, part.where(), remarks);
  for (Warning& remark : remarks) warnings_.add(std::move(remark));
  return std::make_shared<const desc::Mesh>(std::move(mesh));
}

desc::CurvesPointer ArrayReader::curves(const LocatedJson& part) const {
  using enum NumberArray::Type;
  check_members(part, {"control_points", "widths", "normals"});
  desc::Curves curves;
  curves.control_points = vectors<Vec3, float>(array(part, "control_points", Float32, 3));
  const NumberArray& widths = array(part, "widths", Float32, 1);
  const auto* width = static_cast<const float*>(widths.data);
  curves.widths.assign(width, width + widths.shape.front());
  curves.normals = vectors<Vec3, float>(array(part, "normals", Float32, 3));
  const std::size_t points = curves.control_points.size();
  if (points == 0 || points % 4 != 0 || curves.widths.size() != points ||
      (!curves.normals.empty() && curves.normals.size() != points)) {
    part.fail(fmt::format(
        "curves need four control points for each segment, each with a width (and a normal, if "
        "there are normals), not {} points with {} widths and {} normals",
        points, curves.widths.size(), curves.normals.size()));
  }
  const auto finite = [](const Vec3& v) { return is_finite(v); };
  if (!std::all_of(curves.control_points.begin(), curves.control_points.end(), finite) ||
      !std::all_of(curves.normals.begin(), curves.normals.end(), finite) ||
      !std::all_of(curves.widths.begin(), curves.widths.end(),
                   [](float w) { return std::isfinite(w) && w >= 0.F; })) {
    part.fail("curves must be finite, and their widths not negative");
  }
  return std::make_shared<const desc::Curves>(std::move(curves));
}

std::string ArrayReader::image(const LocatedJson& part) const {
  check_members(part, {"image"});
  const NumberArray* found = find(part, "image");
  if (found == nullptr) part.fail("an image needs the number of its array");
  const NumberArray& array = *found;
  constexpr std::size_t kMostSide = std::size_t{1} << 20U;
  const std::vector<std::size_t>& shape = array.shape;
  const bool fits =
      (shape.size() == 2 || (shape.size() == 3 && (shape[2] == 1 || shape[2] == 3))) &&
      shape[0] >= 1 && shape[0] <= kMostSide && shape[1] >= 1 && shape[1] <= kMostSide;
  if (!fits || array.type == NumberArray::Type::UInt32) {
    part.fail("an image is an array of rows x columns, or rows x columns x 3, not " +
              shape_text(array));
  }
  ImageLayout layout;
  layout.height = static_cast<int>(shape[0]);
  layout.width = static_cast<int>(shape[1]);
  layout.resolution = {layout.width, layout.height};
  layout.names = {"R", "G", "B"};
  const bool is_linear = array.type == NumberArray::Type::Float32;
  const std::vector<unsigned char> bytes = is_linear
                                               ? encode_exr(layout, rows_of<float>(array))
                                               : encode_png(layout, rows_of<unsigned char>(array));
  auto content = std::make_shared<const std::string>(bytes.begin(), bytes.end());
  std::string name = fmt::format("array-{:016x}-{}{}", hash_of(*content), content->size(),
                                 is_linear ? ".exr" : ".png");
  embedded_[name] = std::move(content);
  return name;
}

}  // namespace ajar::code
