#pragma once
#include <span>

#include "core/vector.h"
#include "image/plane.h"
#include "image/regions.h"
#include "integrator/regions/heuristics.h"

namespace ajar {

/// Properties of the first surfaces of a picture's pixels, row by row.
struct SurfacePicture {
  Vec2i size{0, 0};
  std::span<const PixelIdentity> identities;  ///< one per pixel
  std::span<const float> depths{};  ///< one per pixel, scene units; or none: they then tell nothing
  std::span<const float> normals{};  ///< three per pixel, of any length; or none
};

/// Difference of neighbours at which an edge has full weight; below, it fades in linearly.
struct EdgeLimits {
  float depth_step = RegionHeuristics::kDepthStep;      ///< relative to the nearer of the two
  float normal_angle = RegionHeuristics::kNormalAngle;  ///< radians
};

/// Where a picture has edges, in [0, 1]: for each pixel the strongest edge towards a neighbour
/// above, below, left or right. It is 1 where they show different things, else the larger of depth
/// step and angle between normals, relative to their limits. Both pixels of a pair are on the edge.
/// Between pixels that show nothing there is none; depths that are not positive and finite and
/// normals without a direction tell nothing. Raises std::invalid_argument if sizes do not fit or a
/// limit is not positive.
///
/// Hint from the G-buffer for the antialiasing of `selective` (Frolov, "Selective application of
/// Metropolis Light Transport for hard sampling illumination phenomena"), who does not publish its
/// construction.
Plane surface_edges(const SurfacePicture& picture, const EdgeLimits& limits = {});

/// The edges at which a map (σ) takes a step, that is, has another value in a neighbour above,
/// below, left or right; 0 elsewhere. Raises std::invalid_argument if sizes differ.
Plane edges_of_map(const Plane& edges, const Plane& map);

}  // namespace ajar
