#pragma once
#include <vector>

#include "transport/path_sampler.h"

namespace ajar::test {

/// A whole path, light to camera, with everything needed to say how likely each technique would
/// have been to make it. Slow and obvious: what the O(1) weights are checked against.
struct OraclePath {
  struct Node {
    Vec3 p;
    Vec3 ng;  ///< zero where there is no surface
    bool specular = false;
    /// Densities of the direction toward the camera's side given the light's, and the other way
    /// round; probabilities at specular nodes.
    double toward_camera = 0.0;
    double toward_light = 0.0;
    const Medium* medium = nullptr;  ///< that it scatters in; null on surfaces
  };
  std::vector<Node> nodes;        ///< x_1 … x_{k-1}
  std::vector<Segment> segments;  ///< k of them, the first leaves the light
  const Light* light = nullptr;
  EndpointPoint light_point;
  EndpointPoint camera_point;
  Vec2 raster{0.F, 0.F};

  int depth() const { return static_cast<int>(nodes.size()) + 1; }
};

/// Density (vertex measures) with which technique (s, t) generates this path; 0 if it cannot.
/// Source: Veach 1997, section 10.2.
double technique_pdf(const Scene& scene, const OraclePath& path, Technique technique);

/// MIS weight of a technique over a set, straight from the definition.
double mis_weight(const Scene& scene, const PathSamplerSettings& settings, const OraclePath& path,
                  Technique technique);

}  // namespace ajar::test
