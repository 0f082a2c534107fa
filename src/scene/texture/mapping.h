#pragma once
#include <variant>
#include <vector>

#include "scene/desc/node.h"
#include "scene/surface_point.h"

namespace ajar {

/// From a surface point to texture coordinates (s, t). Source: pbrt-v3, section 10.2.
class TextureMapping {
 public:
  /// Mapping of a node with the parameters of `mapping_parameters`.
  explicit TextureMapping(const desc::Node& node);
  Vec2 map(const SurfacePoint& at) const {
    if (const auto* uv = std::get_if<Uv>(&mapping_)) {
      const float u = uv->su * at.uv.x;
      const float v = uv->sv * at.uv.y;
      return {uv->cosine * u - uv->sine * v + uv->du, uv->sine * u + uv->cosine * v + uv->dv};
    }
    return map_position(at.p);
  }

 private:
  struct Uv {
    float su, sv, cosine, sine, du, dv;
  };
  struct Spherical {
    Mat4 world_to_texture;
  };
  struct Cylindrical {
    Mat4 world_to_texture;
    bool is_direction;
  };
  struct Planar {
    Vec3 vs, vt;
    float ds, dt;
  };
  using Mapping = std::variant<Uv, Spherical, Cylindrical, Planar>;

  static Mapping mapping_of(const desc::Node& node);
  Vec2 map_position(const Vec3& p) const;

  Mapping mapping_;
};

/// Parameters of textures that have a `TextureMapping`.
std::vector<ParameterSpec> mapping_parameters();
/// Parameter of textures that have a space of their own.
ParameterSpec texture_space();

}  // namespace ajar
