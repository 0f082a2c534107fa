#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "core/frame.h"
#include "core/pdf.h"
#include "core/spectrum.h"
#include "scene/bsdf/lobes.h"

namespace ajar {

/// What travels along the path that is being sampled: radiance (paths from the camera) or importance
/// (paths from lights). They differ where light is refracted and where shading normals are used.
enum class TransportMode : std::uint8_t { Radiance, Importance };

/// Uniform numbers one scattering event consumes.
struct BsdfUniforms {
  float lobe;
  Vec2 direction;
};

struct BsdfSample {
  Vec3 wi;          ///< unit, world space, points away from the surface
  Spectrum weight;  ///< f · |cos θ| / pdf, adjoint corrections included
  DirectionPdf pdf; ///< of wi given wo, over all lobes that can produce it
  DirectionPdf reverse_pdf;  ///< of wo given wi, same lobes
  bool transmission = false;
  float eta = 1.F;  ///< index of refraction on wi's side over that on wo's; 1 unless refracted
};

/// Scattering at one point: a few lobes by value in one shading frame. Trivially copyable. Directions
/// are unit vectors in world space pointing away from the surface; `wo` is where the sampled path came
/// from, `wi` where it goes.
///
/// Values are products f(wo, wi) · |cos θ|, including the adjoint factors of Veach 1997, chapter 5:
/// in mode Radiance refraction scales by (η_wo/η_wi)², in mode Importance it does not, and there
/// the shading-normal factor |wo·ns||wi·ng| / (|wo·ng||wi·ns|) appears instead. Hence for any pair and
/// ignoring specular lobes
///   eval(a, b, Radiance) · |a·ng| · η_b² ... = eval(b, a, Importance) · |b·ng| ...
/// (tested in bsdf_test.cpp). Which lobes count as reflection or transmission is decided by the
/// geometric normal, so that light never leaks through a surface.
class Bsdf {
 public:
  static constexpr int kMaxLobes = 8;

  Bsdf() = default;
  /// `ng` geometric, `frame.z` the shading normal, both on the outside of the surface.
  Bsdf(const Frame& frame, const Vec3& ng) : frame_(frame), ng_(ng) {}

  /// Adds a lobe whose value is scaled by `scale`; ignored if the scale is black.
  void add(const Lobe& lobe, const Spectrum& scale = Spectrum(1.F));

  /// f · |cos θ| of the lobes that are not specular.
  Spectrum eval(const Vec3& wo, const Vec3& wi, TransportMode mode) const;
  /// Density of `sample` (specular lobes take their share of probability but do not add to it).
  Pdf<SolidAngle> pdf(const Vec3& wo, const Vec3& wi) const;
  /// Empty if the surface absorbs, or if the sampled direction is on the wrong side.
  std::optional<BsdfSample> sample(const Vec3& wo, const BsdfUniforms& u, TransportMode mode) const;

  /// False if all lobes are specular (or there are none): connecting to this point is pointless.
  bool connectible() const { return connectible_; }
  bool empty() const { return count_ == 0; }
  /// Approximate directional albedo for direction `wo`: what the albedo AOV shows.
  Spectrum albedo(const Vec3& wo) const;

  const Vec3& ng() const { return ng_; }
  const Vec3& ns() const { return frame_.z; }
  const Frame& frame() const { return frame_; }

 private:
  struct Entry {
    Lobe lobe;
    Spectrum scale;
  };
  Frame frame_;
  Vec3 ng_{0.F, 0.F, 1.F};
  std::int8_t count_ = 0;
  bool connectible_ = false;
  std::array<Entry, kMaxLobes> entries_;
};

}  // namespace ajar
