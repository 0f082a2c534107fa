#pragma once
#include "scene/texture/texture.h"

namespace ajar {

/// A shading normal, and what of the surface runs along with it.
struct ReliefFrame {
  Vec3 ns;    ///< unit, in the hemisphere of ng
  Vec3 dpdu;  ///< not normalised
};

/// Shading normal and tangent of the surface displaced along its normal by `displacement` (scene
/// units). Where the displaced surface has no normal, those of `at`. Source: pbrt-v3, section 9.3.
ReliefFrame bump_frame(const TextureSlot& displacement, const SurfacePoint& at);

/// The same for a surface of which a texture says the normals: its colour c stands for the vector
/// 2c − 1, of which `strength` multiplies the first two lanes. They are along dp/du and along that
/// perpendicular to it on which dp/dv is; if `right_handed`, along ns × dp/du wherever dp/dv is.
/// The third lane is along ns. Where that is no direction, the normal of `at`.
ReliefFrame normal_map_frame(const TextureSlot& normals, float strength, bool right_handed,
                             const SurfacePoint& at);

/// What tilts the shading normals of a material: a bump, normals of a texture, or nothing.
class Relief {
 public:
  Relief() = default;
  /// Of a description with both, the bump counts.
  Relief(const desc::Material& description, const TextureList& textures);

  bool is_flat() const { return kind_ == Kind::Flat; }
  /// Needs derivatives in `at` unless it is flat.
  ReliefFrame frame(const SurfacePoint& at) const;

 private:
  enum class Kind { Flat, Bump, Normals };
  Kind kind_ = Kind::Flat;
  TextureSlot texture_;
  float strength_ = 1.F;
  bool right_handed_ = false;
};

}  // namespace ajar
