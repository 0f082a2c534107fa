#pragma once
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/method_report.h"
#include "core/plane.h"
#include "integrator/regions/surface_pilot.h"
#include "scene/scene.h"

namespace ajar {

/// Layers of a render that divides regions of the picture.
inline constexpr std::array<const char*, 4> kRegionLayers = {"noise", "regions", "importance",
                                                             "edges"};

/// Pictures of one channel, by name of their layer.
using NamedPlanes = std::vector<std::pair<std::string, Plane>>;

/// Layers of `kRegionLayers` that `aovs` names. `importance`: weight of chains, in [0, 1].
NamedPlanes region_layers(std::span<const std::string> aovs, const Surfaces& surfaces,
                          const Plane& noise, const Plane& importance);
/// Layers of a render without regions: black pictures.
NamedPlanes black_region_layers(std::span<const std::string> aovs, const Box2i& crop);

/// A row for each region, the largest first: its number in the layer "regions", its pixels, object
/// and material, `noise` (one value per region), and the mean of `importance`. `region_count` tells
/// how many there are if not all are listed.
MethodReport report_regions(const Scene& scene, const Regions& regions,
                            std::span<const double> noise, const Plane& importance);

}  // namespace ajar
