#pragma once
#include <memory>
#include <string>

#include "scene/scene.h"

namespace ajar::test {

constexpr float kBright = 0.95F;
constexpr float kDark = 0.01F;

/// A wall of upright stripes as wide as a pixel, seen from in front, of the materials "bright" and
/// "dark" in turns, under the lights of `lamp` (pbrt). Their borders are those of the pixels, moved
/// by `offset` pixels to the right. If all are lit alike and there is no offset, what the dark ones
/// show is kDark / kBright of what the bright ones do.
std::unique_ptr<Scene> stripes(int width, int height, const std::string& lamp, float offset = 0.F);

}  // namespace ajar::test
