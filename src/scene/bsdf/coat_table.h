#pragma once
#include "scene/bsdf/microfacet.h"

namespace ajar {

/// A rough boundary to a denser medium, with isotropic facets.
struct RoughBoundary {
  FacetModel model = FacetModel::Ggx;
  float eta = 1.5F;  ///< index inside over that outside, ≥ 1
  float alpha = 0.1F;
};

/// Light that meets facets of a rough boundary once, tabulated; α and index beyond the table are
/// those of its ends (α 1, index 20). What meets a second facet is in none of it, so that reflected
/// and refracted shares add up to less than 1.
namespace coat_table {

/// Share that is reflected back outside, of light from this cosine outside.
float reflected(const RoughBoundary& boundary, float cosine);
/// Share that is refracted inside, of the same.
float refracted(const RoughBoundary& boundary, float cosine);

/// Means over a hemisphere of directions outside, weighted by their cosines.
float mean_reflected(const RoughBoundary& boundary);
float mean_refracted(const RoughBoundary& boundary);

/// Share that is reflected back inside, of diffuse light from inside.
float mean_reflected_inside(const RoughBoundary& boundary);
/// The same as a sum over 64 evenly spaced cosines from 0 to 1 of which both ends count whole, as
/// Mitsuba 3 has it (roughplastic); 1.6 % less.
float sum_reflected_inside(const RoughBoundary& boundary);

}  // namespace coat_table
}  // namespace ajar
