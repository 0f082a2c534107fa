#pragma once
#include "scene/texture/texture.h"

namespace ajar {

struct BumpedFrame {
  Vec3 ns;    ///< unit, in the hemisphere of ng
  Vec3 dpdu;  ///< not normalised
};

/// Shading normal and tangent of the surface displaced along its normal by `displacement` (scene
/// units). Where the displaced surface has no normal, those of `at`. Source: pbrt-v3, section 9.3.
BumpedFrame bump_frame(const TextureSlot& displacement, const SurfacePoint& at);

}  // namespace ajar
