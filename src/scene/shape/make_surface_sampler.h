#pragma once
#include <memory>

#include "scene/shape/quadric.h"
#include "scene/shape/surface_sampler.h"
#include "scene/shape/triangle_mesh.h"

namespace ajar {

/// Triangles by area. Null if the mesh has no area. The mesh must outlive the sampler.
std::unique_ptr<SurfaceSampler> make_surface_sampler(const TriangleMesh& mesh);
/// Whole spheres that stay spheres in the world: by visible cone. All others: by area in object
/// space, which is by area in the world if the transform is a similarity and else known by its
/// Jacobian.
std::unique_ptr<SurfaceSampler> make_surface_sampler(const Quadric& quadric,
                                                     const Placement& placement, bool reversed);

}  // namespace ajar
