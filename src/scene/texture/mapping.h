#pragma once
#include "scene/desc/scene_desc.h"
#include "scene/surface_point.h"

namespace ajar {

/// From a surface point to texture coordinates (s, t). Source: pbrt-v3, section 10.2.
class TextureMapping {
 public:
  explicit TextureMapping(const desc::Mapping2D& mapping) : mapping_(mapping) {}
  Vec2 map(const SurfacePoint& at) const {
    if (const auto* uv = std::get_if<desc::UvMapping>(&mapping_)) {
      return {uv->su * at.uv.x + uv->du, uv->sv * at.uv.y + uv->dv};
    }
    return map_position(at.p);
  }

 private:
  Vec2 map_position(const Vec3& p) const;
  desc::Mapping2D mapping_;
};

/// Greatest integer not above x, for coordinates of any size (NaN gives 0).
int floor_to_int(float x);

}  // namespace ajar
