#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/frame.h"
#include "core/pdf.h"
#include "core/spectrum.h"
#include "scene/bsdf/lobes.h"

namespace ajar {

/// Selects whether the density of the opposite direction is computed, too.
enum class Reverse : std::uint8_t { Compute, Skip };

struct BsdfValue {
  Spectrum value;       ///< f · |cos θ| of the lobes that are not specular
  Pdf<SolidAngle> pdf;  ///< density of wi given wo
};

/// Scattering event: a part of the path, beside the direction itself.
struct ScatterEvent {
  static constexpr std::int8_t kRough = -1;
  /// Number of the specular lobe, or `kRough` for all others together.
  std::int8_t lobe = kRough;
  bool transmission = false;
  bool specular() const { return lobe != kRough; }
  bool operator==(const ScatterEvent&) const = default;
};

/// Lobes to invert: all that are not specular, or only the diffuse ones.
enum class Inverted : std::uint8_t { Rough, Diffuse };

struct BsdfSample {
  Vec3 wi;           ///< unit, world space, points away from the surface
  Spectrum weight;   ///< f · |cos θ| / pdf, adjoint corrections included
  DirectionPdf pdf;  ///< density of wi given wo: of all lobes that are not specular, or of the one
                     ///< specular lobe
  DirectionPdf reverse_pdf;  ///< density of wo given wi, same lobes
  bool transmission = false;
  std::int8_t lobe = ScatterEvent::kRough;  ///< see ScatterEvent
  float eta = 1.F;  ///< index of refraction on wi's side over that on wo's; 1 unless refracted
  ScatterEvent event() const { return {lobe, transmission}; }
};

/// Scattering at one point: a few lobes by value in one shading frame. Trivially copyable.
/// Directions are unit vectors in world space pointing away from the surface; `wo` is where the
/// sampled path came from, `wi` where it goes.
///
/// Values are products f(wo, wi) · |cos θ|, including the adjoint factors of Veach 1997, chapter 5:
/// in mode Radiance refraction scales by (η_wo/η_wi)², in mode Importance it does not, and there
/// the shading-normal factor |wo·ns||wi·ng| / (|wo·ng||wi·ns|) appears instead. Hence, for lobes
/// that are not specular and any two directions a, b,
///
///     eval(a, b, Importance) · |a·ng| = eval(b, a, Radiance) · |b·ng|
///
/// (both are f_s(a → b) |a·ns| |b·ng|, with f_s the scattering of radiance from a to b), which is
/// what makes paths built from the light and from the camera agree; no η is left in it. Specular
/// lobes have instead, with w the product of weight and probability of going from one to the other,
///
///     w(a, b, Importance) · η_b² |a·ng| |b·ns| = w(b, a, Radiance) · η_a² |b·ng| |a·ns|
///
/// Diffuse lobes fill the whole hemisphere of ng. Lobes that depend on a half-vector scatter only
/// pairs that ns sees on the same sides as ng does.
///
/// The geometric normal decides which lobes count as reflection or transmission, so that light
/// never leaks through a surface. Directions within `kGrazing` of either normal's plane scatter
/// nothing.
class Bsdf {
 public:
  static constexpr int kMaxLobes = 8;

  Bsdf() = default;
  /// `ng` geometric, `frame.z` the shading normal, both on the outside of the surface.
  Bsdf(const Frame& frame, const Vec3& ng) : x_(frame.x), y_(frame.y), z_(frame.z), ng_(ng) {}

  /// Adds a lobe whose value is scaled by `scale`; ignored if the scale is black, or if there are
  /// `kMaxLobes` already (materials are checked for that when they are built).
  template <typename L>
  void add(const L& lobe, const Spectrum& scale = Spectrum(1.F)) {
    if (scale.is_black() || count_ == kMaxLobes) return;
    std::construct_at(&slots_[count_].entry, lobe, scale);
    ++count_;
    connectible_ = connectible_ || !L::kSpecular;
  }

  /// f · |cos θ| of the lobes that are not specular.
  Spectrum eval(const Vec3& wo, const Vec3& wi, TransportMode mode) const;
  /// `eval` and `pdf` of one pair of directions for the price of one.
  BsdfValue evaluate(const Vec3& wo, const Vec3& wi, TransportMode mode) const;
  /// Density of `sample` (specular lobes take their share of probability but do not add to it).
  Pdf<SolidAngle> pdf(const Vec3& wo, const Vec3& wi) const;
  /// Empty if the surface absorbs, or if the sampled direction is on the wrong side. The reverse
  /// density costs time where there are several lobes; with Reverse::Skip it is of no use.
  std::optional<BsdfSample> sample(const Vec3& wo, const BsdfUniforms& u, TransportMode mode,
                                   Reverse reverse = Reverse::Compute) const;

  /// The numbers by which `sample` goes to `wi`, `u_lobe` being the one it chooses the lobe by,
  /// with the density of `wi` given that number. Empty if the lobe is not one of those to be
  /// inverted, or if `wo` grazes the surface so much that nothing is sampled.
  std::optional<LobeInverse> inverse(const Vec3& wo, const Vec3& wi, float u_lobe,
                                     Inverted lobes) const;
  /// The numbers by which `sample` goes from `wo` to `wi` by this event, the lobe's too.
  /// Undetermined numbers (the choice among several lobes, unused ones) are taken from `fresh`: if
  /// that is uniform, the result is distributed as the numbers of all samples that give `wi`; their
  /// density is that of the sample. Empty if it never does. The direction of specular events is
  /// ignored.
  std::optional<BsdfUniforms> invert(const Vec3& wo, const Vec3& wi, ScatterEvent event,
                                     const BsdfUniforms& fresh) const;
  /// Sample of `wo` by this specular event; empty if the event is impossible.
  std::optional<BsdfSample> specular(const Vec3& wo, ScatterEvent event, TransportMode mode) const;

  /// True for straight transmission that does not count in the depth of a path.
  bool is_uncounted(ScatterEvent event) const;

  /// False if all lobes are specular (or there are none): connecting to this point is pointless.
  bool connectible() const { return connectible_; }
  bool empty() const { return count_ == 0; }
  /// Index of refraction behind the surface over that in front, as the first rough dielectric among
  /// the lobes has it; 1 if there is none.
  float rough_eta() const;
  /// Approximate directional albedo for direction `wo`, for the albedo AOV.
  Spectrum albedo(const Vec3& wo) const;

  Vec3 ng() const { return ng_.unpack(); }
  Vec3 ns() const { return z_.unpack(); }
  Frame frame() const { return {x_.unpack(), y_.unpack(), z_.unpack()}; }

 private:
  struct Entry {
    template <typename L>
    Entry(const L& l, const Spectrum& s) : lobe(l), scale(s) {}
    Lobe lobe;
    Spectrum scale;
  };
  /// A vector that can be copied as bytes, which Imath's cannot.
  struct PackedVector {
    float x, y, z;
    explicit PackedVector(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}
    Vec3 unpack() const { return {x, y, z}; }
  };
  /// Storage that costs nothing until it is used: a BSDF is made for every hit.
  union Slot {
    Slot() {}  // NOLINT(modernize-use-equals-default): must not touch the entry
    Entry entry;
  };
  struct Weights;
  struct Pair;

  const Entry& entry(int index) const { return slots_[index].entry; }
  Pair classify(const Vec3& wo, const Vec3& wi) const;
  /// Probabilities of the lobes for `local_wo`.
  Weights weights(const Vec3& local_wo) const;
  /// The lobe that `u` chooses, which is made a number for that lobe alone; none if it is
  /// impossible.
  std::optional<int> choose(const Weights& weights, float& u) const;
  /// The numbers by which lobe `index` is chosen and gives a direction; `u` as in `choices` of the
  /// lobes.
  UnitInterval choices(int index, const Weights& weights, const Vec3& wo, const Vec3& wi,
                       bool transmission, float& u) const;
  Spectrum value(int index, const Pair& pair, TransportMode mode) const;
  LobeValue evaluate(int index, const Pair& pair, TransportMode mode) const;
  /// `reverse` is null if the reverse density is not wanted.
  void add_other_lobes(int chosen, const Vec3& wo, const Weights& forward, const Weights* reverse,
                       TransportMode mode, LobeSample& s) const;

  PackedVector x_{Vec3(1.F, 0.F, 0.F)};  ///< axes of the shading frame
  PackedVector y_{Vec3(0.F, 1.F, 0.F)};
  PackedVector z_{Vec3(0.F, 0.F, 1.F)};
  PackedVector ng_{Vec3(0.F, 0.F, 1.F)};
  std::int8_t count_ = 0;
  bool connectible_ = false;
  std::array<Slot, kMaxLobes> slots_;
};

static_assert(std::is_trivially_copyable_v<Bsdf>);
static_assert(sizeof(Bsdf) <= 640);

}  // namespace ajar
