#include "import/mitsuba/curve_file.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <memory>

#include "core/error.h"
#include "core/printable_text.h"
#include "import/common/spline_segments.h"
#include "import/mesh/text_lines.h"

namespace ajar::mitsuba {
namespace {

static_assert(std::endian::native == std::endian::little, "values are read as they are stored");

constexpr std::string_view kBinary = "BINARY_HAIR";

CurveFile read_binary(std::string_view bytes, const std::string& name) {
  const auto fail = [&](const std::string& reason) {
    throw SceneError(name + ": these curves cannot be read: " + reason);
  };
  bytes.remove_prefix(kBinary.size());
  const auto next = [&]<typename Value>(Value value) {
    if (bytes.size() < sizeof(Value)) fail("the file ends too early");
    std::memcpy(&value, bytes.data(), sizeof(Value));
    bytes.remove_prefix(sizeof(Value));
    return value;
  };
  const auto count = next(std::uint32_t{});
  CurveFile curves(1);
  for (std::uint32_t i = 0; i < count; ++i) {
    float x = next(float{});
    if (x == std::numeric_limits<float>::infinity()) {
      if (!curves.back().empty()) curves.emplace_back();
      x = next(float{});
    }
    const float y = next(float{});
    const Vec3 place(x, y, next(float{}));
    if (!is_finite(place)) fail("not all numbers are finite");
    curves.back().push_back({place});
  }
  return curves;
}

CurveFile read_text(std::string_view bytes, const std::string& name, bool has_radii) {
  const auto file = std::make_shared<const std::string>(name);
  TextLines lines(bytes);
  CurveFile curves(1);
  while (lines.next()) {
    LineWords words(lines.line());
    const bool is_remark = !has_radii && words.rest().starts_with('#');
    if (words.rest().empty() || is_remark) {
      if (!curves.back().empty()) curves.emplace_back();
      continue;
    }
    const auto number = [&] {
      const int column = words.column();
      const std::string_view word = words.word();
      const std::optional<float> value = number_in(word);
      if (value && std::isfinite(*value)) return *value;
      throw SceneError({file, lines.number(), column},
                       word.empty() ? "here a number is missing"
                                    : "this is no finite number: \"" + printable_line(word) + "\"");
    };
    CurvePoint point;
    for (int i = 0; i < 3; ++i) point.place[i] = number();
    if (has_radii) point.radius = number();
    curves.back().push_back(point);
  }
  return curves;
}

void add(const CubicSegment<Vec3>& places, const CubicSegment<float>& radii, desc::Curves& curves) {
  for (std::size_t i = 0; i < 4; ++i) {
    curves.control_points.push_back(places[i]);
    curves.widths.push_back(2.F * radii[i]);
  }
}

template <typename Value>
CubicSegment<Value> straight_segment(const Value& a, const Value& b) {
  return {a, lerp(1.F / 3.F, a, b), lerp(2.F / 3.F, a, b), b};
}

}  // namespace

CurveFile read_curve_file(std::string_view bytes, const std::string& name, bool has_radii) {
  if (!has_radii && bytes.starts_with(kBinary)) return read_binary(bytes, name);
  return read_text(bytes, name, has_radii);
}

desc::Curves curves_of(const CurveFile& file, CurveKind kind) {
  const std::size_t points_of_segment = kind == CurveKind::Corners ? 2 : 4;
  desc::Curves curves;
  for (const std::vector<CurvePoint>& curve : file) {
    for (std::size_t i = 0; i + points_of_segment <= curve.size(); ++i) {
      std::array<Vec3, 4> places;
      std::array<float, 4> radii{};
      for (std::size_t j = 0; j < points_of_segment; ++j) {
        places[j] = curve[i + j].place;
        radii[j] = curve[i + j].radius;
      }
      if (kind == CurveKind::Corners) {
        add(straight_segment(places[0], places[1]), straight_segment(radii[0], radii[1]), curves);
      } else {
        add(cubic_spline_segment(places.data()), cubic_spline_segment(radii.data()), curves);
      }
    }
  }
  return curves;
}

}  // namespace ajar::mitsuba
