#include "scene/material/relief.h"

#include "core/frame.h"

namespace ajar {
namespace {
/// Step of the finite differences in u and v: pbrt-v3's choice where it knows no pixel footprint.
constexpr float kStep = 5e-4F;
/// A relief that tilts the normal closer than this (cosine) to the surface is ignored.
constexpr float kGrazing = 1e-4F;

SurfacePoint shifted(const SurfacePoint& at, const Vec3& dp, const Vec2& duv) {
  SurfacePoint moved = at;
  moved.p += dp * kStep;
  moved.uv += duv * kStep;
  return moved;
}

/// `n` as a shading normal, not normalised; that of `at` if it cannot be one.
Vec3 usable_normal(const Vec3& n, const SurfacePoint& at) {
  const float squared = length_squared(n);
  if (!(squared > 0.F) || !std::isfinite(squared)) return at.ns;
  const Vec3 ns = face_forward(n / std::sqrt(squared), at.ng);
  return abs_dot(ns, at.ng) >= kGrazing ? ns : at.ns;
}

/// Projection of `tangent` onto the plane of the shading normal: without this, a mesh with smooth
/// normals would show its facets.
Vec3 along_surface(const Vec3& tangent, const SurfacePoint& at) {
  return tangent - at.ns * dot(tangent, at.ns);
}

}  // namespace

ReliefFrame bump_frame(const TextureSlot& displacement, const SurfacePoint& at) {
  const float here = displacement.eval_float(at);
  const float along_u = displacement.eval_float(shifted(at, at.dpdu, Vec2(1.F, 0.F)));
  const float along_v = displacement.eval_float(shifted(at, at.dpdv, Vec2(0.F, 1.F)));
  const Vec3 dpdu =
      along_surface(at.dpdu, at) + at.ns * ((along_u - here) / kStep) + at.dndu * here;
  const Vec3 dpdv =
      along_surface(at.dpdv, at) + at.ns * ((along_v - here) / kStep) + at.dndv * here;
  const Vec3 ns = usable_normal(cross(dpdu, dpdv), at);
  return {ns, ns == at.ns ? at.dpdu : dpdu};
}

ReliefFrame normal_map_frame(const TextureSlot& normals, float strength, bool right_handed,
                             const SurfacePoint& at) {
  const Frame frame = Frame::around(at.ns, at.dpdu);
  const bool is_mirrored = !right_handed && dot(frame.y, at.dpdv) < 0.F;
  const Spectrum c = normals.eval(at);
  const float y = (2.F * c[1] - 1.F) * strength;
  const Vec3 n((2.F * c[0] - 1.F) * strength, is_mirrored ? -y : y, 2.F * c[2] - 1.F);
  return {usable_normal(frame.to_world(n), at), at.dpdu};
}

Relief::Relief(const desc::Material& description, const TextureList& textures)
    : strength_(description.normal_map.strength),
      right_handed_(description.normal_map.right_handed) {
  const auto slot = [&](desc::TextureId id) {
    return TextureSlot(textures.at(static_cast<std::size_t>(id)).get());
  };
  if (description.bump >= 0) {
    texture_ = slot(description.bump);
    // A bump that is the same everywhere is none.
    if (!texture_.is_constant()) kind_ = Kind::Bump;
  } else if (description.normal_map.texture >= 0) {
    texture_ = slot(description.normal_map.texture);
    // The normals of a file that cannot be read are those of the surface.
    const bool is_known =
        !textures.at(static_cast<std::size_t>(description.normal_map.texture))->is_stand_in();
    if (is_known) kind_ = Kind::Normals;
  }
}

ReliefFrame Relief::frame(const SurfacePoint& at) const {
  switch (kind_) {
    case Kind::Bump:
      return bump_frame(texture_, at);
    case Kind::Normals:
      return normal_map_frame(texture_, strength_, right_handed_, at);
    case Kind::Flat:
      break;
  }
  return {at.ns, at.dpdu};
}

}  // namespace ajar
