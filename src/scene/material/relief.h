#pragma once
#include "scene/texture/texture.h"

namespace ajar {

/// A shading normal, and tangents of the surface across it.
struct ReliefFrame {
  Vec3 ns;    ///< unit, in the hemisphere of ng
  Vec3 dpdu;  ///< not normalised
};

/// Shading normal and tangent of the surface displaced along its normal by `displacement` (scene
/// units). Where the displaced surface has no normal, those of `at`. Source: pbrt-v3, section 9.3.
ReliefFrame bump_frame(const TextureSlot& displacement, const SurfacePoint& at);

/// Frame of a normal map: its colour c encodes the vector 2c − 1, of which `strength` multiplies
/// the first two lanes. The axes are dp/du and the perpendicular to it on the side of dp/dv; if
/// `right_handed`, ns × dp/du in place of the latter. The third lane is along ns. The normal of
/// `at` where that is no direction.
ReliefFrame normal_map_frame(const TextureSlot& normals, float strength, bool right_handed,
                             const SurfacePoint& at);

/// Tilt of the shading normals of a material: a bump, a normal map, or nothing.
class Relief {
 public:
  Relief() = default;
  /// The bump takes precedence in a description with both.
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
