#pragma once
#include <span>

#include "core/vector.h"
#include "image/plane.h"
#include "image/regions.h"
#include "integrator/regions/heuristics.h"

namespace ajar {

/// What the first surfaces of a picture's pixels are like, row by row.
struct SurfacePicture {
  Vec2i size{0, 0};
  std::span<const PixelIdentity> identities;  ///< one per pixel
  std::span<const float> depths{};  ///< one per pixel, scene units; or none: they then tell nothing
  std::span<const float> normals{};  ///< three per pixel, of any length; or none
};

/// How different neighbours are where an edge counts as whole; below, it fades in linearly.
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
/// This is the hint that the antialiasing of `selective` takes from the G-buffer (Frolov,
/// "Selective application of Metropolis Light Transport for hard sampling illumination phenomena"),
/// who does not say how it is made.
Plane surface_edges(const SurfacePicture& picture, const EdgeLimits& limits = {});

/// The edges at which a map (σ) takes a step, that is, has another value in a neighbour above,
/// below, left or right; 0 elsewhere. Raises std::invalid_argument if sizes differ.
Plane edges_of_map(const Plane& edges, const Plane& map);

}  // namespace ajar
