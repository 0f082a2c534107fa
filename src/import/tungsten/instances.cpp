#include "import/tungsten/instances.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "import/tungsten/transforms.h"

namespace ajar::tungsten {
namespace {

constexpr WarningKind kUnreadableInstances{Effect::Geometry,
                                           "files of instances cannot be read: they are left out"};

struct Header {
  std::uint32_t count;
  std::uint32_t flags;
  float low[3];
  float high[3];
};
constexpr std::uint32_t kRounded = 1;

/// Position, and axis times angle in radians.
struct Exact {
  float position[3];
  float turn[3];
};
/// Position in 3 × 21 bits of the box; 12 bits each of two lanes of the axis, 8 of the angle.
struct Rounded {
  std::uint32_t a, b, c;
};

template <typename Record>
Record record_at(std::string_view bytes, std::size_t offset) {
  Record record;
  std::memcpy(&record, bytes.data() + offset, sizeof(Record));
  return record;
}

/// Rodrigues' formula.
Mat4 turned_and_moved(const Vec3d& axis, double radians, const Vec3d& position) {
  const double sine = std::sin(radians);
  const double cosine = std::cos(radians);
  const auto image = [&](const Vec3d& v) {
    return v * cosine + axis.cross(v) * sine + axis * (axis.dot(v) * (1.0 - cosine));
  };
  return from_axes(image({1.0, 0.0, 0.0}), image({0.0, 1.0, 0.0}), image({0.0, 0.0, 1.0}),
                   position);
}

Mat4 place_of(const Exact& exact) {
  const Vec3d turn(exact.turn[0], exact.turn[1], exact.turn[2]);
  const double angle = turn.length();
  const Vec3d axis = angle > 0.0 ? turn / angle : Vec3d(0.0, 1.0, 0.0);
  return turned_and_moved(axis, angle, {exact.position[0], exact.position[1], exact.position[2]});
}

Mat4 place_of(const Rounded& rounded, const Header& header) {
  constexpr std::uint32_t kPlaces = 1U << 21;
  const std::uint32_t cells[3] = {rounded.a >> 11,
                                  ((rounded.a << 10) | (rounded.b >> 22)) & (kPlaces - 1),
                                  (rounded.b >> 1) & (kPlaces - 1)};
  Vec3d position;
  for (int i = 0; i < 3; ++i) {
    const auto low = static_cast<double>(header.low[i]);
    const auto high = static_cast<double>(header.high[i]);
    position[i] = low + (high - low) * static_cast<double>(cells[i]) / kPlaces;
  }
  const auto lane = [](std::uint32_t bits) { return static_cast<double>(bits) / 2048.0 - 1.0; };
  const double x = lane((rounded.c >> 8) & 0xfffU);
  const double y = lane(rounded.c >> 20);
  const double z = std::sqrt(std::max(1.0 - x * x - y * y, 0.0));
  const double angle = 2.0 * 3.14159265358979323846 * (rounded.c & 0xffU) / 256.0;
  return turned_and_moved({x, y, z}, angle, position);
}

}  // namespace

std::optional<std::vector<Placed>> read_instance_file(std::string_view bytes) {
  if (bytes.size() < sizeof(Header)) return std::nullopt;
  const auto header = record_at<Header>(bytes, 0);
  const bool is_rounded = (header.flags & kRounded) != 0;
  const std::size_t size = is_rounded ? sizeof(Rounded) : sizeof(Exact);
  const std::size_t count = header.count;
  if (count > (bytes.size() - sizeof(Header)) / (size + 1)) return std::nullopt;
  std::vector<Placed> placed(count);
  const std::size_t masters = sizeof(Header) + count * size;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t offset = sizeof(Header) + i * size;
    placed[i].to_world = is_rounded ? place_of(record_at<Rounded>(bytes, offset), header)
                                    : place_of(record_at<Exact>(bytes, offset));
    placed[i].master = static_cast<unsigned char>(bytes[masters + i]);
  }
  return placed;
}

std::vector<Placed> read_placed(const Context& context, const LocatedJson& json) {
  if (json.is(LocatedJson::Kind::Text)) {
    std::string reason = "it ends too early";
    try {
      const FileBytes bytes = context.files.load(context.files.resolve(json.text(), json.where()));
      if (std::optional<std::vector<Placed>> placed = read_instance_file(bytes.view())) {
        return std::move(*placed);
      }
    } catch (const IoError& error) {
      reason = error.what();
    }
    context.warnings.add(kUnreadableInstances, json.where(),
                         "cannot read these instances: " + reason + ". They are left out",
                         printable(json.text()));
    return {};
  }
  if (!json.is(LocatedJson::Kind::Array)) {
    throw SceneError(json.where(), "\"instances\" must be an array or the name of a file");
  }
  std::vector<Placed> placed;
  for (const LocatedJson& item : json.items()) {
    const ObjectReader object(context, item, "an instance");
    Placed one;
    one.master = object.integer("id").value_or(0);
    one.to_world = without_scale(transform_of(context, object), true);
    object.report_unknown();
    placed.push_back(one);
  }
  return placed;
}

}  // namespace ajar::tungsten
