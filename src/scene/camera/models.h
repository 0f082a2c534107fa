#pragma once
#include <memory>

#include "scene/camera/camera.h"
#include "scene/direction_map.h"

/// The camera models, one file each; `make_camera` chooses among them. All of them require an
/// invertible `to_world`.
namespace ajar {

std::unique_ptr<Camera> make_perspective_camera(const desc::Camera& camera,
                                                const desc::PerspectiveCamera& node,
                                                Vec2i resolution);
std::unique_ptr<Camera> make_orthographic_camera(const desc::Camera& camera,
                                                 const desc::OrthographicCamera& node,
                                                 Vec2i resolution);
std::unique_ptr<Camera> make_environment_camera(const desc::Camera& camera, Vec2i resolution);

}  // namespace ajar
