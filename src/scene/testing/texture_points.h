#pragma once
#include "scene/texture/texture.h"

/// Points at which tests ask textures.
namespace ajar::testing {

inline SurfacePoint at_uv(float u, float v) {
  SurfacePoint point{};
  point.uv = {u, v};
  return point;
}

}  // namespace ajar::testing
