#pragma once
#include <optional>

#include "core/by_lane.h"
#include "scene/ray_counts.h"
#include "scene/scene.h"
#include "transport/sample_source.h"

namespace ajar {

/// A straight edge of a path between two vertices.
struct Segment {
  Spectrum transmittance{1.F};
  /// Optical depth per lane of the scattering media only: distances are sampled from these, while
  /// media that merely absorb just attenuate.
  Spectrum scattering_depth;
  /// Interfaces along it that add to the depth of its path.
  int counted_interfaces = 0;

  /// Density with which a distance that is sampled by each lane ends at `end`, at the end of this
  /// segment: 1/(scene unit) in a medium, else a probability.
  Spectrum distance_pdf(const MediumPoint& end = {}) const {
    return end.medium == nullptr && scattering_depth.is_black() ? Spectrum(1.F)
                                                                : distance_pdf_in_medium(end);
  }

 private:
  Spectrum distance_pdf_in_medium(const MediumPoint& end) const;
};

/// Lanes of a path that has not met a medium.
inline constexpr ByLane kAnyLane{1.0, 1.0, 1.0};

/// A subpath's free flight along a segment: its lane may have been any (docs/methods/
/// bidirectional.md, "Media").
struct FreeFlight {
  /// `lanes`: density of the subpath so far by each lane, over its density by all of them.
  FreeFlight(const Segment& segment, const ByLane& lanes, const MediumPoint& end = {});
  Spectrum weight;  ///< transmittance (· σ_s) / density by all lanes, given the subpath so far
  ByLane lanes;     ///< live lanes of the subpath with this segment
};

/// Where a traced segment ended.
struct SegmentEnd {
  std::optional<Hit> hit;   ///< empty: scattered in `medium`, or left the scene
  const Medium* medium;     ///< at the end
  float distance;           ///< from the ray's origin; infinity if it left the scene
  bool scattered = false;   ///< in `medium`, at origin + distance · direction
  bool lost = false;        ///< the ray could not be traced: its end is unknown
  Spectrum weight{1.F};     ///< transmittance (· σ_s) / distance pdf
  ByLane lanes = kAnyLane;  ///< live lanes of the subpath up to here
  Segment segment;
};

// The numbers by which `trace_segment` ends segments that cross scattering media. Undetermined
// numbers are taken from `fresh` (docs/methods/inverses.md).

/// The number of `kLaneChoice`. `pdf`: density of the whole path by each lane. Empty if no lane
/// makes it.
std::optional<float> invert_lane(const ByLane& pdf, float fresh);
/// The number of the distance, which was sampled by `lane`; its density is `Segment::distance_pdf`.
float invert_distance(const Segment& segment, const MediumPoint& end, int lane, float fresh);

/// Where a segment gets its numbers if it crosses a scattering medium; most do not.
class DistanceSource {
 public:
  DistanceSource(SampleSource& source, Stream stream, int vertex, int repeat)
      : source_(source), stream_(stream), vertex_(vertex), repeat_(repeat) {}
  int lane() const { return lane_of(source_.get(kLaneChoice)); }
  float distance() const { return source_.get({stream_, vertex_, Slot::MediumDistance, repeat_}); }

 private:
  SampleSource& source_;
  Stream stream_;
  int vertex_;
  int repeat_;
};

/// Follows a ray that starts in `medium`, straight through interface materials, to the next
/// scattering event: a surface, or a point in a scattering medium whose distance is sampled by the
/// path's lane. `lanes`: as in `FreeFlight`. `rays` is increased by the number of rays traced.
SegmentEnd trace_segment(const Scene& scene, Ray ray, const Medium* medium, const ByLane& lanes,
                         const DistanceSource& numbers, RayCounts& rays);

/// True if anything at all lies on `ray`, or it cannot be traced. Counts the ray either way.
bool is_blocked(const Scene& scene, const Ray& ray, RayCounts& rays);

/// The segment between two points if nothing opaque lies between them; empty if there may be
/// interfaces, which need tracing.
std::optional<Segment> unobstructed(const Scene& scene, const Ray& ray, const Medium* medium);

/// Direction along the path of a ray that passes lights: beyond an interface that counts, as seen
/// from the camera, lights are met.
enum class Heading { TowardCamera, AwayFromCamera };

/// The segment between two mutually visible points; empty if a surface that is not an interface
/// lies between, or a ray cannot be traced.
std::optional<Segment> connect(const Scene& scene, Ray ray, const Medium* medium, RayCounts& rays,
                               Heading heading = Heading::TowardCamera);

}  // namespace ajar
