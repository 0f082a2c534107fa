#include "import/tungsten/transforms.h"

#include <cmath>
#include <optional>

#include "import/common/degree.h"

namespace ajar::tungsten {
namespace {

Vec3d normalized(const Vec3d& v) {
  const double length = std::sqrt(v.dot(v));
  return length > 0.0 && std::isfinite(length) ? v / length : v;
}

/// Some direction across `v`.
Vec3d across(const Vec3d& v) {
  return normalized(
      v.cross(std::abs(v.x) > std::abs(v.y) ? Vec3d(0.0, 1.0, 0.0) : Vec3d(1.0, 0.0, 0.0)));
}

/// Below this squared length the rest of an axis has no direction.
constexpr double kNoDirection = 1e-5;

/// Makes the axes perpendicular: the first keeps its direction, the second its side.
void make_perpendicular(Vec3d& first, Vec3d& second, Vec3d& third) {
  first = normalized(first);
  second -= first * first.dot(second);
  second = second.dot(second) < kNoDirection ? across(first) : normalized(second);
  third -= first * first.dot(third);
  third -= second * second.dot(third);
  third = third.dot(third) < kNoDirection ? first.cross(second) : normalized(third);
}

/// The axes that a transform names, completed to a frame.
struct NamedAxes {
  Vec3d x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};
  bool has_x = false, has_y = false, has_z = false;

  void complete() {
    // The order in which they keep their directions, by those that are named.
    if (has_z || !(has_x || has_y)) {
      has_z&& has_x && !has_y ? make_perpendicular(z, x, y) : make_perpendicular(z, y, x);
    } else if (has_y) {
      has_x ? make_perpendicular(y, x, z) : make_perpendicular(y, z, x);
    } else {
      make_perpendicular(x, z, y);
    }
    if (x.cross(y).dot(z) < 0.0) {
      Vec3d& turned = !has_x ? x : !has_y ? y : z;
      turned = -turned;
    }
  }
};

/// Around z, then x, then, the other way round, y; `degrees` holds the angles of x, y, z.
Vec3d rotated_zxy(const Vec3d& v, const Vec3d& degrees) {
  const Vec3d c(std::cos(degrees.x * kDegree), std::cos(degrees.y * kDegree),
                std::cos(degrees.z * kDegree));
  const Vec3d s(std::sin(degrees.x * kDegree), std::sin(degrees.y * kDegree),
                std::sin(degrees.z * kDegree));
  const Vec3d a(c.z * v.x - s.z * v.y, s.z * v.x + c.z * v.y, v.z);
  const Vec3d b(a.x, c.x * a.y - s.x * a.z, s.x * a.y + c.x * a.z);
  return {c.y * b.x - s.y * b.z, b.y, s.y * b.x + c.y * b.z};
}

Mat4 from_matrix(const LocatedJson& json) {
  if (json.size() != 16) {
    throw SceneError(json.where(), "a matrix has 16 numbers, not " + std::to_string(json.size()));
  }
  Mat4 matrix;
  for (std::size_t i = 0; i < 16; ++i) {
    matrix[static_cast<int>(i % 4)][static_cast<int>(i / 4)] =
        static_cast<double>(json[i].as<float>());
  }
  // Tungsten ignores the last row of affine transforms; so do we.
  for (int i = 0; i < 3; ++i) matrix[i][3] = 0.0;
  matrix[3][3] = 1.0;
  return matrix;
}

}  // namespace

Mat4 transform_from_members(const ObjectReader& object) {
  const Vec3d origin = Vec3d(object.vector("position").value_or(Vec3(0.F)));
  NamedAxes axes;
  const auto name_axis = [&](std::initializer_list<std::string_view> names, Vec3d& axis,
                             bool& has) {
    if (const std::optional<Vec3> given = object.vector(names)) {
      axis = Vec3d(*given);
      has = true;
    }
  };
  if (const std::optional<Vec3> target = object.vector({"look_at", "lookAt"})) {
    axes.z = Vec3d(*target) - origin;
    axes.has_z = true;
  }
  name_axis({"up"}, axes.y, axes.has_y);
  name_axis({"x_axis"}, axes.x, axes.has_x);
  name_axis({"y_axis"}, axes.y, axes.has_y);
  name_axis({"z_axis"}, axes.z, axes.has_z);
  axes.complete();
  const Vec3d scale = Vec3d(object.vector("scale").value_or(Vec3(1.F)));
  const Vec3d degrees = Vec3d(object.vector("rotation").value_or(Vec3(0.F)));
  return from_axes(rotated_zxy(axes.x * scale.x, degrees), rotated_zxy(axes.y * scale.y, degrees),
                   rotated_zxy(axes.z * scale.z, degrees), origin);
}

Mat4 transform_of(const Context& context, const LocatedJson& json) {
  if (json.is(LocatedJson::Kind::Array)) return from_matrix(json);
  const ObjectReader object(context, json, "a transform");
  const Mat4 transform = transform_from_members(object);
  object.report_unknown();
  return transform;
}

Mat4 transform_of(const Context& context, const ObjectReader& object) {
  const auto transform = object.find("transform");
  return transform ? transform_of(context, *transform) : Mat4();
}

Vec3d axis_of(const Mat4& transform, int axis) {
  return {transform[axis][0], transform[axis][1], transform[axis][2]};
}

Vec3d origin_of(const Mat4& transform) { return axis_of(transform, 3); }

Mat4 from_axes(const Vec3d& x, const Vec3d& y, const Vec3d& z, const Vec3d& origin) {
  return {x.x, x.y, x.z, 0.0, y.x,      y.y,      y.z,      0.0,
          z.x, z.y, z.z, 0.0, origin.x, origin.y, origin.z, 1.0};
}

Vec3d scale_of(const Mat4& transform) {
  const auto length = [&](int axis) {
    const Vec3d v = axis_of(transform, axis);
    return std::sqrt(v.dot(v));
  };
  return {length(0), length(1), length(2)};
}

Mat4 without_scale(const Mat4& transform, bool with_origin) {
  Vec3d axes[3];
  for (int i = 0; i < 3; ++i) axes[i] = normalized(axis_of(transform, i));
  for (int i = 0; i < 3; ++i) {
    if (!(axes[i].dot(axes[i]) > 0.0)) axes[i] = axes[(i + 1) % 3].cross(axes[(i + 2) % 3]);
  }
  return from_axes(axes[0], axes[1], axes[2], with_origin ? origin_of(transform) : Vec3d(0.0));
}

bool is_invertible(const Mat4& transform) {
  const Vec3d scale = scale_of(transform);
  const double volume = scale.x * scale.y * scale.z;
  const double determinant =
      axis_of(transform, 0).cross(axis_of(transform, 1)).dot(axis_of(transform, 2));
  return std::isfinite(volume) && std::abs(determinant) > 1e-12 * volume;
}

}  // namespace ajar::tungsten
