#pragma once
#include <optional>

#include "core/vector.h"

/// Transforms as scene files describe them, as row-vector matrices (p' = p * M).
namespace ajar {

Mat4 translation(const Vec3d& offset);
Mat4 scaling(const Vec3d& factors);
/// Counter-clockwise around `axis`, degrees. Empty if the axis has no direction.
std::optional<Mat4> rotation(double degrees, const Vec3d& axis);
/// World to camera: the camera at `eye` looks along +z to `target`. Empty if there is no such
/// direction or it is parallel to `up`.
std::optional<Mat4> look_at(const Vec3d& eye, const Vec3d& target, const Vec3d& up);
/// A rotation that turns +z into `direction`; identity for +z itself. Empty for the zero vector.
std::optional<Mat4> z_to(const Vec3d& direction);

/// Empty if the matrix cannot be inverted.
std::optional<Mat4> inverse(const Mat4& m);
/// The inverse rounded to about 40 bits, so that inverting twice gives the same bits again: scenes
/// that are written and read back keep their hash. Empty if the matrix cannot be inverted.
std::optional<Mat4> rounded_inverse(const Mat4& m);
bool is_finite(const Mat4& m);

}  // namespace ajar
