#include "transport/segment.h"

#include "core/unit_interval.h"

namespace ajar {

namespace {
/// Rays that graze stacked interfaces could go on for ever through rounding; no real scene has this
/// many.
constexpr int kMaxInterfaces = 1000;

const Medium* medium_beyond(const Hit& hit, const Vec3& direction, const Medium* medium) {
  if (!hit.media->changes) return medium;
  return dot(direction, hit.point.ng) > 0.F ? hit.media->outside : hit.media->inside;
}

/// True if nothing scatters a ray at this hit.
bool is_passed(const Hit& hit, const Ray& ray) {
  return hit.cut_away || hit.is_interface() || (ray.passes_lights && hit.light != nullptr);
}

bool adds_edge(const Hit& hit) { return hit.cut_away || hit.material->adds_edge; }

/// Multiplies by the transmittance of `depth` (Beer–Lambert).
void cross_depth(const Medium& medium, const Spectrum& depth, Segment& segment) {
  segment.transmittance *= exp(depth * -1.F);
  if (medium.scatters()) segment.scattering_depth += depth;
}

void cross_medium(const Medium* medium, const Ray& ray, float distance, Segment& segment) {
  if (medium != nullptr) cross_depth(*medium, medium->along(ray, distance).depth, segment);
}

/// Counts rays that could not be traced; true for such a ray.
bool was_lost(const Scene& scene, const Ray& ray, RayCounts& rays) {
  if (scene.can_trace(ray)) return false;
  ++rays.rays_out_of_range;
  return true;
}
}  // namespace

Spectrum Segment::distance_pdf_in_medium(const MediumPoint& end) const {
  const Spectrum survival = exp(scattering_depth * -1.F);
  return end.medium == nullptr ? survival : survival * end.sigma_t();
}

FreeFlight::FreeFlight(const Segment& segment, const ByLane& before, const MediumPoint& end) {
  const ByLane pdfs = before * by_lane(segment.distance_pdf(end));
  const double pdf = mean(pdfs);
  lanes = pdfs / pdf;
  weight = segment.transmittance;
  if (end.medium != nullptr) weight *= end.sigma_s();
  weight /= static_cast<float>(pdf);
}

std::optional<float> invert_lane(const ByLane& pdf, float fresh) {
  if (pdf.x == pdf.y && pdf.x == pdf.z) return pdf.x > 0.0 ? std::optional(fresh) : std::nullopt;
  double sum = pdf.x + pdf.y + pdf.z;
  if (!(sum > 0.0)) return std::nullopt;
  int lane = 0;
  for (; lane < 2; ++lane) {
    if (came_first(pdf[lane], sum - pdf[lane], fresh)) break;
    sum -= pdf[lane];
  }
  if (!(pdf[lane] > 0.0)) return std::nullopt;
  return UnitInterval{lane / 3.0, 1.0 / 3.0}.at(fresh);
}

float invert_distance(const Segment& segment, const MediumPoint& end, int lane, float fresh) {
  const double survival = std::exp(-static_cast<double>(segment.scattering_depth[lane]));
  // On surfaces all distances beyond are one.
  return end.medium != nullptr ? std::min(static_cast<float>(1.0 - survival), kOneMinusEpsilon)
                               : UnitInterval{1.0 - survival, survival}.at(fresh);
}

SegmentEnd trace_segment(const Scene& scene, Ray ray, const Medium* medium, const ByLane& lanes,
                         const DistanceSource& numbers, RayCounts& rays) {
  SegmentEnd end;
  Hit& hit = end.hit.emplace();
  if (medium == nullptr && !scene.has_interfaces() && !ray.passes_lights) {
    ++rays.rays;
    const bool found = scene.intersect(ray, hit);
    end.medium = nullptr;
    end.lanes = lanes;
    end.distance = found ? hit.t : std::numeric_limits<float>::infinity();
    if (!found) {
      end.lost = was_lost(scene, ray, rays);
      end.hit.reset();
    }
    return end;
  }
  const Vec3 origin = ray.origin;
  int lane = -1;           // asked for when the first scattering medium is met
  float depth_left = 0.F;  // optical depth in `lane` until the next event
  float travelled = 0.F;
  bool found = false;
  const auto fly = [&](const FreeFlight& flight) {
    end.weight = flight.weight;
    end.lanes = flight.lanes;
  };
  for (int i = 0; i < kMaxInterfaces; ++i) {
    ++rays.rays;
    found = scene.intersect(ray, hit);
    if (!found && was_lost(scene, ray, rays)) {
      end.lost = true;
      break;
    }
    const float distance = found ? hit.t : std::numeric_limits<float>::infinity();
    if (medium != nullptr && medium->scatters()) {
      if (lane < 0) {
        lane = numbers.lane();
        depth_left = -std::log(1.F - numbers.distance());
      }
      const Crossing crossing = medium->along(ray, distance, lane, depth_left);
      cross_depth(*medium, crossing.depth, end.segment);
      if (crossing.reached) {
        end.medium = medium;
        end.distance = travelled + crossing.distance;
        end.scattered = true;
        end.hit.reset();
        const Vec3 here = origin + ray.direction * end.distance;
        fly({end.segment, lanes, {medium, here}});
        return end;
      }
      depth_left -= crossing.depth[lane];
    } else {
      cross_medium(medium, ray, distance, end.segment);
    }
    travelled += distance;
    if (!found || !is_passed(hit, ray)) break;
    if (adds_edge(hit)) {
      ++end.segment.counted_interfaces;
      // The camera sees lights beyond a vertex of its path.
      ray.passes_lights = false;
    }
    medium = medium_beyond(hit, ray.direction, medium);
    ray.origin = offset_ray_origin(hit.point.p, hit.point.ng, ray.direction);
    found = false;
  }
  if (!found) end.hit.reset();
  end.medium = medium;
  end.distance = found ? travelled : std::numeric_limits<float>::infinity();
  fly({end.segment, lanes});
  return end;
}

std::optional<Segment> unobstructed(const Scene& scene, const Ray& ray, const Medium* medium) {
  if (scene.has_interfaces() || ray.passes_lights) return std::nullopt;
  Segment segment;
  cross_medium(medium, ray, ray.t_max, segment);
  return segment;
}

bool is_blocked(const Scene& scene, const Ray& ray, RayCounts& rays) {
  ++rays.rays;
  if (!scene.occluded(ray)) return false;
  was_lost(scene, ray, rays);
  return true;
}

std::optional<Segment> connect(const Scene& scene, Ray ray, const Medium* medium, RayCounts& rays,
                               Heading heading) {
  if (!scene.has_interfaces() && !ray.passes_lights) {
    if (is_blocked(scene, ray, rays)) return std::nullopt;
    return unobstructed(scene, ray, medium);
  }
  Segment segment;
  bool passed_light = false;
  const bool bounded = std::isfinite(ray.t_max);
  const Vec3 target = bounded ? ray.origin + ray.direction * ray.t_max : Vec3(0.F);
  for (int i = 0; i < kMaxInterfaces; ++i) {
    ++rays.rays;
    const std::optional<Hit> hit = scene.intersect(ray);
    if (!hit) {
      if (was_lost(scene, ray, rays)) return std::nullopt;
      cross_medium(medium, ray, ray.t_max, segment);
      return segment;
    }
    if (!is_passed(*hit, ray)) return std::nullopt;
    passed_light = passed_light || !(hit->cut_away || hit->is_interface());
    if (adds_edge(*hit)) {
      // The camera sees lights beyond a vertex of its path.
      if (heading == Heading::AwayFromCamera) {
        ray.passes_lights = false;
      } else if (passed_light) {
        return std::nullopt;
      }
      ++segment.counted_interfaces;
    }
    cross_medium(medium, ray, hit->t, segment);
    medium = medium_beyond(*hit, ray.direction, medium);
    const Vec3 next = offset_ray_origin(hit->point.p, hit->point.ng, ray.direction);
    if (bounded) {
      // Aimed anew, or roundings would add up and the ray could hit the surface of its target.
      const Vec3 left = target - next;
      const float distance = length(left);
      if (dot(left, ray.direction) <= 0.F || distance == 0.F) return segment;
      ray = {next, left / distance, distance, ray.passes_lights};
    } else {
      ray.origin = next;
    }
  }
  return std::nullopt;
}

}  // namespace ajar
