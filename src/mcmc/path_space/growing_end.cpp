#include "mcmc/path_space/growing_end.h"

#include <algorithm>

#include "scene/medium/phase.h"

namespace ajar {

void GrowingEnd::keep(const Path& path, int count) {
  vertices.clear();
  segments.clear();
  endpoint = nullptr;
  if (count == 0) return;
  const auto inner = static_cast<std::ptrdiff_t>(count) - 1;
  if (stream_ == Stream::Light) {
    start(*path.light, path.light_point);
    vertices.assign(path.vertices.begin(), path.vertices.begin() + inner);
    segments.assign(path.segments.begin(), path.segments.begin() + inner);
  } else {
    start(scene_.camera(), path.camera_point);
    vertices.assign(path.vertices.rbegin(), path.vertices.rbegin() + inner);
    segments.assign(path.segments.rbegin(), path.segments.rbegin() + inner);
  }
}

void GrowingEnd::start(const Endpoint& at, const EndpointPoint& where) {
  vertices.clear();
  segments.clear();
  endpoint = &at;
  point = where;
}

void GrowingEnd::start(const Endpoint& at, const EndpointPoint& where, const Ray& ray,
                       const Medium* medium) {
  start(at, where);
  ray_ = ray;
  ray_.passes_lights = stream_ == Stream::Camera && scene_.hides_lights();
  medium_ = medium;
}

Vec3 GrowingEnd::back() const {
  const Vec3& here = vertices.back().p();
  if (vertices.size() > 1) return normalize(vertices[vertices.size() - 2].p() - here);
  if (!endpoint->at_infinity()) return normalize(point.surface.p - here);
  return point.toward;
}

bool GrowingEnd::scatter(SampleSource& source) {
  InnerVertex& vertex = vertices.back();
  const auto address = [&](Slot slot) {
    return SampleAddress(stream_, static_cast<int>(vertices.size()), slot);
  };
  const Vec2 u = source.get_pair(address(Slot::BsdfDirectionX));
  if (vertex.in_medium) {
    vertex.event = {};
    leave(phase::sample_henyey_greenstein(vertex.medium->g(), back(), u));
    return true;
  }
  const TransportMode mode =
      stream_ == Stream::Light ? TransportMode::Importance : TransportMode::Radiance;
  const auto sample =
      vertex.bsdf.sample(back(), {source.get(address(Slot::BsdfLobe)), u}, mode, Reverse::Skip);
  if (!sample) return false;
  vertex.event = sample->event();
  leave(sample->wi);
  return true;
}

bool GrowingEnd::follow(const ScatterEvent& event) {
  InnerVertex& vertex = vertices.back();
  if (vertex.in_medium) return false;
  const auto sample = vertex.bsdf.specular(back(), event, TransportMode::Radiance);
  if (!sample) return false;
  vertex.event = event;
  leave(sample->wi);
  return true;
}

void GrowingEnd::go(const Vec3& direction) {
  vertices.back().event = {};
  leave(direction);
}

void GrowingEnd::leave(const Vec3& direction) {
  const InnerVertex& vertex = vertices.back();
  ray_ = {vertex.ray_origin(direction), direction};
  ray_.passes_lights = stream_ == Stream::Camera && scene_.hides_lights() &&
                       std::ranges::all_of(vertices, &InnerVertex::is_uncounted) &&
                       std::ranges::all_of(segments, [](const Segment& passed) {
                         return passed.counted_interfaces == 0;
                       });
  medium_ = vertex.medium_toward(direction);
}

SegmentEnd GrowingEnd::trace(SampleSource& source) {
  return trace_segment(scene_, ray_, medium_, kAnyLane,
                       {source, stream_, static_cast<int>(vertices.size()), 0}, rays_);
}

bool GrowingEnd::arrive(SampleSource& source) {
  const SegmentEnd end = trace(source);
  if (!end.hit && !end.scattered) return false;
  InnerVertex& vertex = vertices.emplace_back();
  vertex.medium = end.medium;
  vertex.in_medium = end.scattered;
  if (end.scattered) {
    vertex.hit = bare_hit(ray_.origin + ray_.direction * end.distance);
  } else {
    vertex.hit = *end.hit;
    vertex.hit.material->bsdf(vertex.hit.point, vertex.bsdf);
  }
  segments.push_back(end.segment);
  return true;
}

}  // namespace ajar
