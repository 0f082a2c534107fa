#pragma once
#include <array>

#include "transport/kept_directions.h"
#include "transport/mis.h"
#include "transport/path_vertex.h"
#include "transport/sample_source.h"
#include "transport/segment.h"

namespace ajar {

/// A subpath on its way from vertex z_i to z_{i+1}, from either end of a path.
struct Flight {
  Ray ray;
  const Medium* medium = nullptr;
  Spectrum throughput{1.F};
  ByLane lanes = kAnyLane;        ///< as in `FreeFlight`
  Vec3 reference{0.F, 0.F, 0.F};  ///< z_i itself; the ray starts a little off it
  int edges = 0;                  ///< index i of the vertex it left
  int surplus = 0;                ///< see PathVertex, with the event at z_i
  /// Factor of the throughput in Russian roulette: squared index ratios undo the scaling of
  /// radiance, and the initial throughput of light is normalised.
  float roulette_scale = 1.F;
  float roulette = 1.F;  ///< product of roulette weights so far
  // For the MIS recursion:
  MisState mis;           ///< MIS state of z_i
  float departure = 0.F;  ///< density (or probability) of the direction, for endpoints at infinity
                          ///< of the position
  bool from_infinity = false;
  bool specular = false;                 ///< the scattering event at z_i
  bool has_rough_edge = false;           ///< both ends of an edge so far are not specular
  ScatterEvent event;                    ///< full scattering event
  float reverse_previous = 0.F;          ///< r_{i-1}
  float cosine = 1.F;                    ///< |cos θ_i| at z_i; 1 where there is no surface
  const Medium* scattered_in = nullptr;  ///< the medium that z_i lies in, if it is not on a surface
};

/// Settings of a random walk.
struct WalkSettings {
  TransportMode mode;
  Stream stream;
  Heuristic heuristic;
  int roulette_start;  ///< edges from which Russian roulette may end the walk
  /// False if no technique has a subpath from the other end: then only vertices on lights need
  /// their MIS state, and reverse densities are not needed at all.
  bool has_other_end;
  int repeat = 0;  ///< index of the light subpath of the sample
  /// Directions to follow or to keep, if not null.
  KeptDirections* directions = nullptr;
  /// Where the recursion is recorded, if the set names single techniques; room for every vertex.
  MisTrailEntry* trail = nullptr;
};

/// The ray of a camera subpath through a place on the film (pixels of the full image); empty if it
/// carries nothing.
std::optional<EmissionSample> camera_ray(const Camera& camera, SampleSource& source,
                                         const Vec2& raster);

/// Fills in the vertex at the end of a flight that ended in the scene. `class_coefficient`: see
/// `MisStep`.
void arrive(const WalkSettings& settings, const Flight& flight, const SegmentEnd& end,
            double class_coefficient, PathVertex& vertex);

/// h-recursion step of a flight over `distance` to a vertex where the direction of flight has
/// cosine `cosine_at_end`; `end` is where it scatters in a medium; pass
/// `at_infinity` if it left the scene.
MisStep mis_step(const Flight& flight, const Segment& segment, float distance, float cosine_at_end,
                 const MediumPoint& end, bool at_infinity, double class_coefficient);

/// Worth of a direction, samples per unit of throughput, by rough lobes and by specular ones; 0
/// where it is not known (`EfficiencyCells`).
using WorthOfDirection = std::array<float, 2>;

/// Scatters at `vertex` and sets off again; false if the subpath ends (absorbed, or Russian
/// roulette, which leaves the expectation unchanged: survivors are divided by the probability to
/// survive). Where the worth of the direction is known, roulette follows that, and may end paths of
/// any length; else it follows the throughput of long ones.
bool scatter(const WalkSettings& settings, const PathVertex& vertex, SampleSource& source,
             Flight& flight, const WorthOfDirection& worth = {0.F, 0.F});

}  // namespace ajar
