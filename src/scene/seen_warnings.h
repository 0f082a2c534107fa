#pragma once
#include <vector>

#include "scene/scene.h"

namespace ajar {

/// Adds those warnings whose objects the camera sees: at the first surface of rays through a coarse
/// grid of its picture, and behind clear surfaces or mirrors, straight on. Each once.
void add_seen_warnings(const Scene& scene, const desc::Camera& camera,
                       const std::vector<desc::WarningIfSeen>& candidates, Warnings& warnings);

}  // namespace ajar
