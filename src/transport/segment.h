#pragma once
#include <optional>

#include "scene/ray_counts.h"
#include "scene/scene.h"
#include "transport/sample_source.h"

namespace ajar {

/// What lies along a straight piece of a path between two vertices.
struct Segment {
  Spectrum transmittance{1.F};
  /// Optical depth per lane of the scattering media only: distances are sampled from these, while
  /// media that merely absorb just attenuate.
  Spectrum scattering_depth;
  /// Interfaces along it that add to the depth of its path.
  int counted_interfaces = 0;

  /// Density of `sample_distance` ending at `end`, at the end of this segment: 1/(scene unit) in a
  /// medium, else a probability.
  float distance_pdf(const MediumPoint& end = {}) const {
    return end.medium == nullptr && scattering_depth.is_black() ? 1.F : distance_pdf_in_medium(end);
  }

 private:
  float distance_pdf_in_medium(const MediumPoint& end) const;
};

/// Where a traced segment ended.
struct SegmentEnd {
  std::optional<Hit> hit;  ///< empty: scattered in `medium`, or left the scene
  const Medium* medium;    ///< at the end
  float distance;          ///< from the ray's origin; infinity if it left the scene
  bool scattered = false;  ///< in `medium`, at origin + distance · direction
  bool lost = false;       ///< the ray could not be traced: nobody knows what it would have met
  Spectrum weight{1.F};    ///< transmittance (· σ_s) / distance pdf
  Segment segment;
};

struct DistanceUniforms {
  float channel;
  float distance;
};
/// The numbers by which `trace_segment` ends a segment that crosses a scattering medium at `end`.
/// What it forgets is taken from `fresh` (docs/methods/inverses.md); the density of the numbers is
/// `Segment::distance_pdf`. Empty if it never does.
std::optional<DistanceUniforms> invert_distance(const Segment& segment, const MediumPoint& end,
                                                const DistanceUniforms& fresh);

/// Where a segment gets its numbers if it crosses a scattering medium; most do not.
class DistanceSource {
 public:
  DistanceSource(SampleSource& source, Stream stream, int vertex, int repeat)
      : source_(source), stream_(stream), vertex_(vertex), repeat_(repeat) {}
  DistanceUniforms get() const {
    return {source_.get({stream_, vertex_, Slot::MediumChannel, repeat_}),
            source_.get({stream_, vertex_, Slot::MediumDistance, repeat_})};
  }

 private:
  SampleSource& source_;
  Stream stream_;
  int vertex_;
  int repeat_;
};

/// Follows a ray that starts in `medium`, straight through interface materials, to the next
/// scattering event: a surface, or a point in a scattering medium whose distance is sampled. The
/// lane to sample by is chosen uniformly and all lanes count in the density (single-sample MIS).
/// `rays` is increased by the number of rays traced.
SegmentEnd trace_segment(const Scene& scene, Ray ray, const Medium* medium,
                         const DistanceSource& numbers, RayCounts& rays);

/// Whether anything at all lies on `ray`, or it cannot be traced. It is counted either way.
bool is_blocked(const Scene& scene, const Ray& ray, RayCounts& rays);

/// The segment between two points if nothing opaque lies between them; empty if interfaces may,
/// which only tracing tells.
std::optional<Segment> unobstructed(const Scene& scene, const Ray& ray, const Medium* medium);

/// The segment between two mutually visible points; empty if a surface that is not an interface
/// lies between, or a ray cannot be traced.
std::optional<Segment> connect(const Scene& scene, Ray ray, const Medium* medium, RayCounts& rays);

}  // namespace ajar
