#include "scene/material/inputs.h"

namespace ajar {
namespace {

constexpr WarningKind kTooManyLobes{
    Effect::Surface, "mixes have too many lobes: only their first materials are used"};

/// `amount` of one material and the rest of another, lane by lane.
class Mix final : public Material {
 public:
  /// The materials outlive the mix. As in pbrt-v3, the relief is that of `a` unless the mix has one
  /// of its own.
  Mix(const TextureSlot& amount, const Material& a, const Material& b)
      : amount_(amount),
        a_(a),
        b_(b),
        max_lobes_(std::max(1, a.max_lobes()) + std::max(1, b.max_lobes())) {
    relief = a.relief;
    needs_tangent = a.needs_tangent || b.needs_tangent;
    index_varies = a.index_varies || b.index_varies;
    passes_uncounted = a.passes_uncounted || b.passes_uncounted;
  }
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    const Spectrum amount = reflectance(amount_, at);
    const Spectrum rest = Spectrum(1.F) - amount;
    if (!amount.is_black()) a_.add_lobes(at, scale * amount, bsdf);
    if (!rest.is_black()) b_.add_lobes(at, scale * rest, bsdf);
  }
  /// A part counts as one lobe at least: so the limit on lobes also limits how mixes can nest.
  int max_lobes() const override { return max_lobes_; }

 private:
  TextureSlot amount_;
  const Material& a_;
  const Material& b_;
  int max_lobes_;  ///< kept: asking the parts each time doubles with every level of nesting
};

/// Replacement for a mix of too many lobes: its first material.
class FirstOfMix final : public Material {
 public:
  /// `first` outlives this, and is none of these itself, so that they cannot nest.
  explicit FirstOfMix(const Material& first) : first_(first) {
    relief = first.relief;
    needs_tangent = first.needs_tangent;
    index_varies = first.index_varies;
    passes_uncounted = first.passes_uncounted;
  }
  void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const override {
    first_.add_lobes(at, scale, bsdf);
  }
  int max_lobes() const override { return first_.max_lobes(); }
  const Material& first() const { return first_; }

 private:
  const Material& first_;
};

std::unique_ptr<Material> make_mix(const MaterialInputs& in) {
  const Material& first = in.material("first");
  const Material& second = in.material("second");
  auto mix = std::make_unique<Mix>(in.slot("amount"), first, second);
  if (mix->max_lobes() <= Bsdf::kMaxLobes) return mix;
  in.warn(kTooManyLobes, "mix of too many lobes (" + std::to_string(mix->max_lobes()) +
                             ", at most " + std::to_string(Bsdf::kMaxLobes) +
                             " are possible): only its first material is used");
  const auto* nested = dynamic_cast<const FirstOfMix*>(&first);
  return std::make_unique<FirstOfMix>(nested != nullptr ? nested->first() : first);
}

}  // namespace

MaterialModel mix_material() {
  return {{.name = "mix",
           .summary = "blend of two materials by a texture",
           .source = "",
           .parameters = {declare::reflectance("amount", "0.5", "share of the first, lane by lane"),
                          declare::material("first", "the one that `amount` is of"),
                          declare::material("second", "the one that the rest is of")}},
          make_mix};
}

}  // namespace ajar
