#include "apps/viewer/live_state.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"

namespace ajar::viewer {

namespace {

/// Numbers of a camera that has a lens; null where there is none.
struct Lens {
  float* radius = nullptr;
  float* focus = nullptr;
  float* fov = nullptr;
};

Lens lens_of(desc::Camera& camera) {
  if (auto* node = std::get_if<desc::PerspectiveCamera>(&camera.node)) {
    return {&node->lens_radius, &node->focal_distance, &node->fov};
  }
  if (auto* node = std::get_if<desc::OrthographicCamera>(&camera.node)) {
    return {&node->lens_radius, &node->focal_distance, nullptr};
  }
  return {};
}

Vec3 axis(const Mat4& matrix, int row) {
  return Vec3(static_cast<float>(matrix[row][0]), static_cast<float>(matrix[row][1]),
              static_cast<float>(matrix[row][2]));
}

void set_row(Mat4& matrix, int row, const Vec3& value) {
  for (int i = 0; i < 3; ++i) matrix[row][i] = static_cast<double>(value[i]);
}

void check(bool holds, const char* otherwise) {
  if (!holds) throw UsageError(std::string("camera: ") + otherwise);
}

}  // namespace

CameraPose pose_of(const desc::Camera& camera, const Box3& bounds) {
  CameraPose pose;
  desc::Camera copy = camera;
  const Lens lens = lens_of(copy);
  const Mat4& to_world = camera.to_world;
  pose.position = axis(to_world, 3);
  const Vec3 forward = normalize(axis(to_world, 2));
  pose.up = normalize(axis(to_world, 1));
  if (lens.fov != nullptr) pose.fov = *lens.fov;
  if (lens.radius != nullptr) {
    pose.lens_radius = *lens.radius;
    pose.focal_distance = *lens.focus;
  }
  float distance = 1.F;
  if (pose.lens_radius > 0.F) {
    distance = pose.focal_distance;
  } else if (!bounds.isEmpty()) {
    const float extent = length(bounds.size());
    const float ahead = dot(bounds.center() - pose.position, forward);
    distance = std::max(ahead, 0.05F * extent);
  }
  pose.target = pose.position + forward * distance;
  return pose;
}

void move_camera(desc::Camera& camera, const CameraPose& pose) {
  check(is_finite(pose.position) && is_finite(pose.target) && is_finite(pose.up),
        "a place is not a number");
  const Vec3 ahead = pose.target - pose.position;
  check(length(ahead) > 0.F, "the target is where the camera is");
  const Vec3 forward = normalize(ahead);
  const Vec3 side = cross(pose.up, forward);
  check(length(side) > 1e-6F * length(pose.up), "up is where it looks");
  const Vec3 right = normalize(side) * (swaps_handedness(camera.to_world) ? -1.F : 1.F);
  set_row(camera.to_world, 0, right);
  set_row(camera.to_world, 1, cross(forward, normalize(side)));
  set_row(camera.to_world, 2, forward);
  set_row(camera.to_world, 3, pose.position);
  const Lens lens = lens_of(camera);
  if (lens.fov != nullptr) {
    check(pose.fov > 0.F && pose.fov < 180.F, "fov is between 0 and 180 degrees");
    *lens.fov = pose.fov;
  }
  if (lens.radius != nullptr) {
    check(pose.lens_radius >= 0.F && std::isfinite(pose.lens_radius),
          "the lens has a radius of 0 or more");
    check(pose.focal_distance > 0.F && std::isfinite(pose.focal_distance),
          "the focus lies ahead of the camera");
    *lens.radius = pose.lens_radius;
    *lens.focus = pose.focal_distance;
  }
}

std::string rules_text(const std::vector<Rule>& rules) {
  std::string text;
  for (const Rule& rule : rules) {
    text += fmt::format("{} \"{}\" {}\n", rule.kind, rule.name, rule.choice);
  }
  return text;
}

bool LiveState::is_other_scene(const LiveState& before) const {
  return camera != before.camera || resolution != before.resolution || edits != before.edits;
}

bool LiveState::is_other_picture(const LiveState& before) const {
  return is_other_scene(before) || crop != before.crop || integrator != before.integrator ||
         parameters != before.parameters;
}

}  // namespace ajar::viewer
