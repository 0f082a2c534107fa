#pragma once
#include <cstddef>
#include <type_traits>
#include <variant>

#include "scene/bsdf/coat.h"
#include "scene/bsdf/conductor.h"
#include "scene/bsdf/dielectric.h"
#include "scene/bsdf/disney_clearcoat.h"
#include "scene/bsdf/disney_diffuse.h"
#include "scene/bsdf/disney_specular.h"
#include "scene/bsdf/fresnel_blend.h"
#include "scene/bsdf/full_oren_nayar.h"
#include "scene/bsdf/lambert.h"
#include "scene/bsdf/microfacet_reflection.h"
#include "scene/bsdf/oren_nayar.h"
#include "scene/bsdf/rough_dielectric.h"
#include "scene/bsdf/sheet_transmission.h"
#include "scene/bsdf/specular.h"
#include "scene/bsdf/under_gloss.h"

namespace ajar {

/// The closed set of lobes, common ones first.
using Lobe =
    std::variant<Lambert, SmoothDielectric, Conductor, DielectricReflection, FresnelBlend,
                 RoughDielectric, Mirror, PassThrough, OrenNayar, LambertTransmission,
                 ThinDielectric, SpecularReflection, SpecularTransmission, DisneyDiffuse,
                 DisneySpecular, DisneyGlassSpecular, DisneyClearcoat, SmoothConductor, SmoothCoat,
                 RoughCoat, CoatedDiffuse, CoatedConductor, CoatedConductorEcho,
                 SmoothCoatedConductor, CoatAttenuated<DisneySpecular>,
                 CoatAttenuated<UnderGloss<SheenOverLambert>>,
                 CoatAttenuated<UnderGloss<LambertTransmission>>, FullOrenNayar, SheetTransmission>;

static_assert(std::is_trivially_copyable_v<Lobe>);
static_assert(sizeof(Lobe) <= 48);

/// `function(lobe as its own type)`. A chain of comparisons that compilers turn into one switch and
/// inline, which they do not do with std::visit for this many alternatives.
template <std::size_t Index = 0, typename Function>
decltype(auto) visit_lobe(const Lobe& lobe, const Function& function) {
  if constexpr (Index + 1 == std::variant_size_v<Lobe>) {
    return function(*std::get_if<Index>(&lobe));
  } else {
    if (lobe.index() == Index) return function(*std::get_if<Index>(&lobe));
    return visit_lobe<Index + 1>(lobe, function);
  }
}

}  // namespace ajar
