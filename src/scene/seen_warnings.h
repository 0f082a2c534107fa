#pragma once
#include <vector>

#include "scene/scene.h"

namespace ajar {

/// Adds those warnings of which the camera sees what they are about: at the first surface of rays
/// through a coarse grid of its picture, and behind what is clear or a mirror, straight on. Each
/// once.
void add_seen_warnings(const Scene& scene, const desc::Camera& camera,
                       const std::vector<desc::WarningIfSeen>& candidates, Warnings& warnings);

}  // namespace ajar
