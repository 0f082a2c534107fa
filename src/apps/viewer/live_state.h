#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/vector.h"
#include "scene/desc/scene_desc.h"

namespace ajar::viewer {

struct CameraPose {
  Vec3 position, target, up;
  float fov = 40.F;  ///< degrees, of the shorter side
  float lens_radius = 0.F;
  float focal_distance = 1e6F;
  bool operator==(const CameraPose&) const = default;
};

/// Where the camera of a description stands. `bounds` of the scene say how far away the target is
/// if the focus does not.
CameraPose pose_of(const desc::Camera& camera, const Box3& bounds);
/// Moves a camera; a mirrored one stays so. Raises UsageError for a pose that is none.
void move_camera(desc::Camera& camera, const CameraPose& pose);

/// A line of a rules file (`parse_region_rules`).
struct Rule {
  std::string kind;    ///< object or material
  std::string name;    ///< may have *
  std::string choice;  ///< chain, omc, auto or a weight
  bool operator==(const Rule&) const = default;
};
std::string rules_text(const std::vector<Rule>& rules);

/// Weights that were painted, 0 to 254 for 0 to 1, 255 where nothing was.
struct Mask {
  Vec2i size;
  std::vector<std::uint8_t> weights;
};

/// All of a picture that a person changes, and may undo.
struct LiveState {
  std::string integrator;
  std::map<std::string, std::string> parameters;
  std::vector<Rule> rules;
  std::shared_ptr<const Mask> mask;  ///< null: none
  std::optional<CameraPose> camera;  ///< empty: the scene's
  std::optional<std::array<int, 2>> resolution;
  std::optional<std::array<int, 4>> crop;
  std::vector<nlohmann::json> edits;  ///< as changes of a scene have them, in order

  /// Another picture: what was rendered before is of no use.
  bool is_other_picture(const LiveState& before) const;
  /// Another scene to be built.
  bool is_other_scene(const LiveState& before) const;
};

}  // namespace ajar::viewer
