#include "import/tungsten/strands.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "core/error.h"
#include "import/common/spline_segments.h"
#include "os/file_extension.h"

namespace ajar::tungsten {
namespace {

static_assert(std::endian::native == std::endian::little, "values are read as they are stored");
static_assert(sizeof(Vec3) == 3 * sizeof(float));

constexpr std::string_view kFiberMagic = "\x80\xBF\x80\x46\x49\x42\x45\x52";
constexpr std::string_view kHairMagic = "HAIR";

/// Values from a place of a file on.
class StrandCursor {
 public:
  StrandCursor(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  [[noreturn]] void fail(const std::string& reason) const {
    throw SceneError(name_ + ": these curves cannot be read: " + reason);
  }
  void go_to(std::uint64_t place) {
    if (place > bytes_.size()) fail("the file ends too early");
    place_ = static_cast<std::size_t>(place);
  }
  std::string_view take(std::uint64_t size) {
    if (size > bytes_.size() - place_) fail("the file ends too early");
    const std::string_view taken = bytes_.substr(place_, static_cast<std::size_t>(size));
    place_ += taken.size();
    return taken;
  }
  template <typename Value>
  Value next() {
    Value value;
    std::memcpy(&value, take(sizeof(Value)).data(), sizeof(Value));
    return value;
  }
  template <typename Value>
  std::vector<Value> array(std::uint64_t count) {
    if (count > (bytes_.size() - place_) / sizeof(Value)) fail("the file ends too early");
    std::vector<Value> values(static_cast<std::size_t>(count));
    const std::string_view bytes = take(count * sizeof(Value));
    if (!bytes.empty()) std::memcpy(static_cast<void*>(values.data()), bytes.data(), bytes.size());
    return values;
  }
  std::size_t place() const { return place_; }

 private:
  std::string_view bytes_;
  const std::string& name_;
  std::size_t place_ = 0;
};

// ---------------------------------------------------------------- .fiber

struct FiberAttribute {
  std::uint64_t length = 0;  ///< in bytes, of its values
  bool is_of_curves = false;
  std::uint8_t type = 0;
  std::uint8_t lanes = 0;
  std::string_view name;
};
constexpr std::uint8_t kUint16 = 3;
constexpr std::uint8_t kFloat = 8;

FiberAttribute read_attribute(StrandCursor& cursor, std::uint64_t size) {
  FiberAttribute attribute;
  const std::size_t begin = cursor.place();
  attribute.length = cursor.next<std::uint64_t>();
  attribute.is_of_curves = (cursor.next<std::uint16_t>() & 1U) != 0;
  attribute.type = cursor.next<std::uint8_t>();
  attribute.lanes = cursor.next<std::uint8_t>();
  const std::size_t read = cursor.place() - begin;
  if (size < read) cursor.fail("an attribute has no room for what it says of itself");
  attribute.name = cursor.take(size - read);
  attribute.name = attribute.name.substr(0, attribute.name.find('\0'));
  return attribute;
}

/// Missing values repeat the last one.
template <typename Value>
void extend(std::vector<Value>& values, std::size_t count) {
  if (!values.empty()) values.resize(count, values.back());
}

Strands read_fiber(std::string_view bytes, const std::string& name) {
  StrandCursor cursor(bytes, name);
  if (cursor.take(kFiberMagic.size()) != kFiberMagic) cursor.fail("this is no .fiber file");
  const auto version = cursor.next<std::uint16_t>();
  cursor.next<std::uint16_t>();
  if (version != 1) cursor.fail("it has version " + std::to_string(version) + ", not 1");
  if (cursor.next<std::uint32_t>() != 0) cursor.fail("it holds something other than curves");
  const auto header_size = cursor.next<std::uint64_t>();
  const auto node_count = cursor.next<std::uint64_t>();
  const auto curve_count = cursor.next<std::uint64_t>();
  Strands strands;
  std::vector<std::uint16_t> counts;
  cursor.go_to(header_size);
  while (const auto size = cursor.next<std::uint64_t>()) {
    if (size < sizeof(size)) cursor.fail("an attribute has no room for what it says of itself");
    const FiberAttribute attribute = read_attribute(cursor, size - sizeof(size));
    const std::size_t values = cursor.place();
    const auto is = [&](std::string_view what, bool of_curves, int type, int lanes) {
      return attribute.name == what && attribute.is_of_curves == of_curves &&
             attribute.type == type && attribute.lanes == lanes;
    };
    if (is("num_vertices", true, kUint16, 1)) {
      counts = cursor.array<std::uint16_t>(attribute.length / sizeof(std::uint16_t));
    } else if (is("position", false, kFloat, 3)) {
      strands.nodes = cursor.array<Vec3>(attribute.length / sizeof(Vec3));
    } else if (is("width", false, kFloat, 1)) {
      strands.radii = cursor.array<float>(attribute.length / sizeof(float));
    }
    cursor.go_to(values);
    cursor.take(attribute.length);
  }
  if (strands.nodes.size() != node_count) {
    cursor.fail("there are " + std::to_string(strands.nodes.size()) + " positions of " +
                std::to_string(node_count) + " nodes");
  }
  if (curve_count > node_count) cursor.fail("there are more curves than nodes");
  extend(counts, static_cast<std::size_t>(curve_count));
  strands.counts.assign(counts.begin(), counts.end());
  strands.radii.resize(std::min(strands.radii.size(), strands.nodes.size()));
  extend(strands.radii, strands.nodes.size());
  return strands;
}

// ---------------------------------------------------------------- .hair

Strands read_hair(std::string_view bytes, const std::string& name) {
  enum Bits : std::uint32_t { kSegments = 1, kPoints = 2, kRadii = 4 };
  constexpr std::size_t kHeaderSize = 128;
  StrandCursor cursor(bytes, name);
  if (cursor.take(kHairMagic.size()) != kHairMagic) cursor.fail("this is no .hair file");
  const auto curve_count = cursor.next<std::uint32_t>();
  const auto node_count = cursor.next<std::uint32_t>();
  const auto has = cursor.next<std::uint32_t>();
  const auto usual_segments = cursor.next<std::uint32_t>();
  const auto usual_thickness = cursor.next<float>();
  cursor.go_to(kHeaderSize);
  if ((has & kPoints) == 0) cursor.fail("it has no points");
  if (curve_count > node_count) cursor.fail("there are more curves than points");
  Strands strands;
  std::vector<std::uint16_t> segments;
  if ((has & kSegments) != 0) segments = cursor.array<std::uint16_t>(curve_count);
  // Checked before memory is allocated for claims of the header.
  strands.nodes = cursor.array<Vec3>(node_count);
  if ((has & kSegments) != 0) {
    for (const std::uint16_t count : segments) strands.counts.push_back(count + 1U);
  } else {
    // More than there are is refused with the sum of all.
    strands.counts.assign(curve_count, std::min(usual_segments, node_count) + 1);
  }
  strands.radii = (has & kRadii) != 0 ? cursor.array<float>(node_count)
                                      : std::vector<float>(node_count, usual_thickness);
  return strands;
}

bool is_finite(const Strands& strands) {
  for (const Vec3& node : strands.nodes) {
    if (!ajar::is_finite(node)) return false;
  }
  for (const float radius : strands.radii) {
    if (!std::isfinite(radius)) return false;
  }
  return true;
}

}  // namespace

Strands read_strands(std::string_view bytes, const std::string& name) {
  const std::string extension = file_extension(name);
  if (extension != ".fiber" && extension != ".hair") {
    throw SceneError(name + ": unknown kind of file of curves. Valid: .fiber, .hair");
  }
  Strands strands = extension == ".fiber" ? read_fiber(bytes, name) : read_hair(bytes, name);
  std::uint64_t sum = 0;
  for (const std::uint32_t count : strands.counts) sum += count;
  const auto fail = [&](const std::string& reason) {
    throw SceneError(name + ": these curves cannot be read: " + reason);
  };
  if (sum > strands.nodes.size()) {
    fail("they have " + std::to_string(sum) + " nodes, but there are " +
         std::to_string(strands.nodes.size()));
  }
  if (!is_finite(strands)) fail("not all numbers are finite");
  return strands;
}

desc::Curves curves_of(const Strands& strands, const StrandTreatment& treatment) {
  desc::Curves curves;
  std::vector<float> radii;
  std::size_t first = 0;
  for (const std::uint32_t count : strands.counts) {
    radii.clear();
    for (std::size_t i = 0; i < count; ++i) {
      float radius =
          treatment.radius.value_or(strands.radii.empty() ? 0.F : strands.radii[first + i]);
      // Tungsten's, which is above 1 at the first node.
      if (treatment.tapers && count > 1) {
        radius *= 1.F - (static_cast<float>(i) - 0.5F) / static_cast<float>(count - 1);
      }
      radii.push_back(radius);
    }
    for (std::size_t i = 0; i + 2 < count; ++i) {
      const CubicSegment<Vec3> places = quadratic_spline_segment(&strands.nodes[first + i]);
      const CubicSegment<float> sizes = quadratic_spline_segment(&radii[i]);
      for (std::size_t j = 0; j < 4; ++j) {
        curves.control_points.push_back(places[j]);
        curves.widths.push_back(2.F * sizes[j]);
      }
    }
    first += count;
  }
  return curves;
}

}  // namespace ajar::tungsten
