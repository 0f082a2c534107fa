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
/// those of its ends (α 1, index 20). Light that meets a second facet is left out, so that
/// reflected and refracted shares add up to less than 1.
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
/// Sum over 64 evenly spaced cosines from 0 to 1 of which both ends count whole, as Mitsuba 3
/// has it (roughplastic); 1.6 % less.
float sum_reflected_inside(const RoughBoundary& boundary);

/// A smooth boundary, with rough mirrors inside that reflect all light: of light from this cosine
/// outside, the share that comes in, is reflected once, and is reflected back to the mirrors, less
/// that of smooth ones. `below` has the index of the boundary and the facets of the mirrors.
float returned(const RoughBoundary& below, float cosine);
/// Its mean over a hemisphere of directions outside, weighted by their cosines.
float mean_returned(const RoughBoundary& below);
/// Mirrors below the boundary in diffuse light from inside: the share that they reflect to where
/// the boundary transmits it, and to where it reflects it back.
struct DiffuseBelow {
  float leaves, returns;
};
DiffuseBelow diffuse_below(const RoughBoundary& below);

}  // namespace coat_table
}  // namespace ajar
